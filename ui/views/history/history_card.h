#pragma once

#include "ui/document/document.h"

#include <QFrame>

class QLabel;
class QScrollArea;

namespace knittsim::ui {

/// What happened to the selected bonding point: by which operation on which line its loop was made, moved,
/// crossed and bound. Lies in the top right corner of its parent; hidden while nothing is selected or it is
/// switched off.
class HistoryCard : public QFrame {
    Q_OBJECT

public:
    HistoryCard(document::Document& document, QWidget* parent);

    void setSwitchedOn(bool on);
    bool isSwitchedOn() const { return m_on; }

signals:
    void lineWanted(int line);
    void closeWanted();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void take();
    void place();
    QString rows(const fabric::PointHistory& history) const;

    document::Document& m_document;
    QLabel* m_title;
    QLabel* m_stitch;
    QLabel* m_events;
    QScrollArea* m_scroll;
    bool m_on = true;
};

} // namespace knittsim::ui
