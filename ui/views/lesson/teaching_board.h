#pragma once

#include "ui/document/document.h"

#include <QWidget>

class QHBoxLayout;
class QLabel;

namespace knittsim::ui {

/// The course and the present operation in one sentence, in large letters of the highest contrast.
class TeachingBoard : public QWidget {
    Q_OBJECT

public:
    explicit TeachingBoard(document::Document& document, QWidget* parent = nullptr);

    QString sentence() const;
    QString course() const;

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void takeStep();
    void scale();

    document::Document& m_document;
    QHBoxLayout* m_row = nullptr;
    QLabel* m_course = nullptr;
    QLabel* m_sentence = nullptr;
};

} // namespace knittsim::ui
