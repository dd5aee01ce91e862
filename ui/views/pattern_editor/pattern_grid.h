#pragma once

#include "ui/document/document.h"
#include "ui/views/pattern_editor/cell_painter.h"
#include "ui/views/pattern_editor/chart_area.h"

#include <vector>

namespace knittsim::ui {

/// The fabric of a document as a chart. Click or arrow keys select a stitch for all views; dragging moves the
/// chart. What is not knitted yet at the document's step is faint.
class PatternGrid : public ChartArea {
    Q_OBJECT

public:
    PatternGrid(document::Document& document, ChartLook& look, QWidget* parent = nullptr);

    /// Middle of a stitch in viewport coordinates, after scrolling it into view.
    QPoint showLoop(machine::LoopIndex loop);

    QSize sizeHint() const override { return {340, 420}; }

signals:
    void loopHovered(int loop); ///< -1: none

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;
    bool viewportEvent(QEvent* event) override;

private:
    void takeFile();
    void takeStep();
    void takeSelection();
    void takeYarns();
    void takeNotes();
    bool moveSelection(int key);
    machine::LoopIndex loopAt(QPoint position) const;
    QString textAt(QPoint position) const;
    void setHover(machine::LoopIndex loop);

    const document::StitchGrid* grid() const;
    QColor colourOf(machine::LoopIndex loop) const;
    bool isFaint(machine::LoopIndex loop) const { return loop >= m_knitted; }
    void paintGrounds(QPainter& painter) const;
    void paintSymbols(QPainter& painter);
    void paintFloats(QPainter& painter, std::int32_t course) const;
    void paintMarker(QPainter& painter, machine::LoopIndex loop, const QColor& colour, int width) const;
    void paintProblems(QPainter& painter) const;
    QRect rectOf(machine::LoopIndex loop) const;

    document::Document& m_document;
    CellPainter m_cells;
    std::vector<document::CourseFacts> m_facts;
    std::vector<QColor> m_colours;    ///< by carrier
    machine::LoopIndex m_knitted = 0; ///< loops below this are made at the document's step
    machine::LoopIndex m_hover = -1;
    std::int32_t m_currentCourse = -1; ///< course of the last stitch made at the document's step
    QPoint m_pressed;
    bool m_dragging = false;
};

} // namespace knittsim::ui
