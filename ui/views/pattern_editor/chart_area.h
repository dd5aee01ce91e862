#pragma once

#include "ui/views/pattern_editor/chart_geometry.h"
#include "ui/views/pattern_editor/course_notes.h"

#include <QAbstractScrollArea>

#include <optional>
#include <vector>

namespace knittsim::ui {

/// A scrolled chart of cells with columns of what each course is made of beside and needle numbers below it.
/// Ctrl and the wheel, + and - zoom at the cursor; until the first zoom the cells follow the size of the
/// widget. What stands in the cells is up to who derives from it.
class ChartArea : public QAbstractScrollArea {
    Q_OBJECT

public:
    const ChartGeometry& geometryOfChart() const { return m_geometry; }

    bool isShown(SideColumn column) const;

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

    /// A place beside the chart.
    struct SidePlace {
        SideColumn column = SideColumn::Course;
        int course = 0;
    };

    ChartArea(ChartLook& look, Cells cells, QWidget* parent);

    const ChartLook& look() const { return m_look; }

    /// Courses and columns; the first column has this number.
    void setChart(int columns, int courses, bool tall, int firstNumber);
    /// One for each course. `severalYarns`: the column of the carriers has something to say, also before it
    /// is drawn, so that the chart does not move aside under the pointer.
    void setNotes(std::vector<CourseNote> notes, bool severalYarns = false);
    void layoutChart();
    std::optional<SidePlace> sideAt(QPoint position) const;
    QString sideText(QPoint position) const; ///< of the course beside which it is; empty elsewhere
    QRect sideRect(SidePlace place) const;   ///< null where the column is hidden
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
    struct Side {
        SideColumn column = SideColumn::Course;
        int left = 0;
        int width = 0;
    };

    void setCellWidth(int width, QPoint fixed);
    void zoomAt(QPoint position, int direction);
    void paintNumber(QPainter& painter, const QRect& rect, int number, bool strong, int align) const;
    void paintRowNumbers(QPainter& painter, const std::vector<int>& strongCourses) const;
    void paintColumnNumbers(QPainter& painter, std::optional<int> strongColumn) const;

    // chart_sides.cpp
    void layoutSides();
    int widthOf(SideColumn column) const;
    int carrierWidth() const; ///< of the box of one carrier
    void paintSides(QPainter& painter, int labelEvery) const;
    void paintSide(QPainter& painter, const Side& side, int course, bool labelled) const;
    void paintYarns(QPainter& painter, const QRect& rect, const CourseNote& note) const;

    ChartLook& m_look;
    const Cells m_cells;
    std::vector<CourseNote> m_notes;
    bool m_severalYarns = false;
    std::vector<Side> m_sides; ///< that are shown, from the left
    ChartGeometry m_geometry;
    int m_firstNumber = 0;
    bool m_fitted = true;
    QPoint m_pressed;
    QPoint m_scrollAtPress;
};

} // namespace knittsim::ui
