#pragma once

#include "ui/document/document.h"

#include <QWidget>

class QLabel;

namespace knittsim::ui {

/// One line of facts: needle, course, racking and carrier of the stitch under the mouse, else of the selected
/// one, else of the operation shown; then stitches, energy, time a step and what draws.
class StatusLine : public QWidget {
    Q_OBJECT

public:
    explicit StatusLine(document::Document& document, QWidget* parent = nullptr);

    void setHoveredLoop(int loop);
    void setRenderer(const QString& name);
    /// The level of detail that is drawn, in words; empty where there is none.
    void setDetail(const QString& level, bool fixed);

private:
    QLabel* addField(const char* name, const QString& toolTip, const QString& widest);
    void takePlace();
    void takeFrame();
    void takeLadders();
    void changeEvent(QEvent* event) override;
    void showLoop(machine::LoopIndex loop);
    void showOperation(machine::OperationIndex operation);

    document::Document& m_document;
    machine::LoopIndex m_hovered = -1;
    QLabel* m_needle;
    QLabel* m_course;
    QLabel* m_rack;
    QLabel* m_carrier;
    QLabel* m_state;
    QLabel* m_stitches;
    QLabel* m_ladders;
    QLabel* m_energy;
    QLabel* m_time;
    QLabel* m_detail;
    QLabel* m_renderer;
};

} // namespace knittsim::ui
