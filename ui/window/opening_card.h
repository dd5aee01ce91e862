#pragma once

#include "ui/document/document.h"

#include <QFrame>
#include <QTimer>

class QLabel;
class QProgressBar;

namespace knittsim::ui {

/// Floats over the middle of its parent while a file is being opened, once that takes longer than half a
/// second.
class OpeningCard : public QFrame {
    Q_OBJECT

public:
    OpeningCard(document::Document& document, QWidget* parent);

    static constexpr int kDelayMs = 500;

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();

    document::Document& m_document;
    QTimer m_delay;
    QLabel* m_title;
    QLabel* m_stage;
    QProgressBar* m_progress;
};

} // namespace knittsim::ui
