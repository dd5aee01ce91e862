#pragma once

#include "ui/views/pattern_editor/chart_geometry.h"

#include <QAbstractScrollArea>

#include <optional>
#include <vector>

namespace knittsim::ui {

/// A scrolled chart of cells with row numbers beside and needle numbers below it. Ctrl and the wheel, + and -
/// zoom at the cursor; until the first zoom the cells follow the size of the widget. What stands in the cells
/// is up to who derives from it.
class ChartArea : public QAbstractScrollArea {
    Q_OBJECT

public:
    const ChartGeometry& geometryOfChart() const { return m_geometry; }

    void fitChart();
    void zoomIn() { zoomAt(viewport()->rect().center(), +1); }
    void zoomOut() { zoomAt(viewport()->rect().center(), -1); }

    QSize minimumSizeHint() const override { return {180, 140}; }

protected:
    /// Widths of cells, in pixels.
    struct Cells {
        int leastFitted = 9;    ///< symbols stay readable
        int largestFitted = 26; ///< few cells do not grow into posters
        int leastWithLines = 7;
    };

    ChartArea(Cells cells, QWidget* parent);

    /// Courses and columns; the first column has this number.
    void setChart(int columns, int courses, bool tall, int firstNumber);
    void layoutChart();
    /// Moves the chart so that `cell` is seen, and `margin` pixels around it where there is room.
    void scrollTo(const QRect& cell, int margin);
    void scrollToFirstCourse();

    void beginScrolling(QPoint position);
    void scrollFrom(QPoint position); ///< where beginScrolling() began
    bool zoomedByKey(int key);

    void resizeEvent(QResizeEvent* event) override;
    void scrollContentsBy(int dx, int dy) override;
    void wheelEvent(QWheelEvent* event) override;
    void changeEvent(QEvent* event) override;

    // chart_area_paint.cpp
    void paintLines(QPainter& painter) const;
    /// Numbers that matter now stand out; those they cover are left out.
    void paintHeaders(QPainter& painter, const std::vector<int>& strongCourses = {},
                      std::optional<int> strongColumn = {}) const;
    void paintFocus(QPainter& painter) const;

private:
    void setCellWidth(int width, QPoint fixed);
    void zoomAt(QPoint position, int direction);
    void paintNumber(QPainter& painter, const QRect& rect, int number, bool strong, int align) const;
    void paintRowNumbers(QPainter& painter, const std::vector<int>& strongCourses) const;
    void paintColumnNumbers(QPainter& painter, std::optional<int> strongColumn) const;

    const Cells m_cells;
    ChartGeometry m_geometry;
    int m_firstNumber = 0;
    bool m_fitted = true;
    QPoint m_pressed;
    QPoint m_scrollAtPress;
};

} // namespace knittsim::ui
