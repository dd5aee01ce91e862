#pragma once

#include "ui/document/document.h"
#include "ui/views/pattern_editor/cell_painter.h"
#include "ui/views/pattern_editor/chart_geometry.h"

#include <QAbstractScrollArea>

#include <vector>

namespace knittsim::ui {

/// The chart of a document. Click or arrow keys select a stitch for all views; Ctrl+wheel, + and - zoom at
/// the cursor; dragging moves the chart. What is not knitted yet at the document's step is faint.
class PatternGrid : public QAbstractScrollArea {
    Q_OBJECT

public:
    explicit PatternGrid(document::Document& document, QWidget* parent = nullptr);

    const ChartGeometry& geometryOfChart() const { return m_chart; }

    /// Middle of a stitch in viewport coordinates, after scrolling it into view.
    QPoint showLoop(machine::LoopIndex loop);

    void zoomIn() { zoomAt(viewport()->rect().center(), +1); }
    void zoomOut() { zoomAt(viewport()->rect().center(), -1); }
    void fitChart();

    QSize sizeHint() const override { return {340, 420}; }
    QSize minimumSizeHint() const override { return {180, 140}; }

signals:
    void loopHovered(int loop); ///< -1: none

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void scrollContentsBy(int dx, int dy) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;
    bool viewportEvent(QEvent* event) override;

private:
    void takeFile();
    void takeStep();
    void takeSelection();
    void takeYarns();
    void layoutChart();
    void setCellWidth(int width, QPoint fixed);
    void zoomAt(QPoint position, int direction);
    bool moveSelection(int key);
    machine::LoopIndex loopAt(QPoint position) const;
    QString textAt(QPoint position) const;
    void setHover(machine::LoopIndex loop);

    const document::StitchGrid* grid() const;
    QColor colourOf(machine::LoopIndex loop) const;
    bool isFaint(machine::LoopIndex loop) const { return loop >= m_knitted; }
    void paintGrounds(QPainter& painter) const;
    void paintLines(QPainter& painter) const;
    void paintSymbols(QPainter& painter);
    void paintFloats(QPainter& painter, std::int32_t course) const;
    void paintMarker(QPainter& painter, machine::LoopIndex loop, const QColor& colour, int width) const;
    void paintProblems(QPainter& painter) const;
    void paintHeaders(QPainter& painter) const;
    QRect rectOf(machine::LoopIndex loop) const;

    document::Document& m_document;
    ChartGeometry m_chart;
    CellPainter m_cells;
    std::vector<QColor> m_colours;    ///< by carrier
    machine::LoopIndex m_knitted = 0; ///< loops below this are made at the document's step
    machine::LoopIndex m_hover = -1;
    std::int32_t m_currentCourse = -1; ///< course of the last stitch made at the document's step
    bool m_fitted = true;              ///< the cell size follows the widget until the user zooms
    QPoint m_pressed;
    QPoint m_scrollAtPress;
    bool m_dragging = false;
};

} // namespace knittsim::ui
