#pragma once

#include "ui/document/document.h"
#include "ui/views/chart_editor/chart_stroke.h"
#include "ui/views/pattern_editor/cell_painter.h"
#include "ui/views/pattern_editor/chart_area.h"

#include <QHash>
#include <QPixmap>

#include <optional>

namespace knittsim::ui {

/// The chart that is edited. The left button draws with the tool at hand, the right one picks stitch and
/// yarn, the middle one moves the chart. With the tool Select a selection is moved by dragging it and
/// repeated by dragging its edges. Arrow keys move a cursor (with Shift they select), Return uses the tool
/// there.
class ChartCanvas : public ChartArea {
    Q_OBJECT

public:
    ChartCanvas(document::Document& document, ChartLook& look, QWidget* parent = nullptr);

    ChartTool tool() const { return m_tool; }
    void setTool(ChartTool tool);
    const pattern::Brush& brush() const { return m_brush; }
    void setBrush(const pattern::Brush& brush) { m_brush = brush; }
    void setModule(const pattern::Module* module);
    const pattern::Module* module() const { return m_module; }

    /// Selected cells; empty when none are.
    pattern::CellRange selection() const { return m_selection; }
    void select(pattern::CellRange range);
    void selectAll();
    /// Where a part is pasted, and courses and wales are put in.
    pattern::CellPlace cursor() const { return m_cursor; }

    void cut();
    void copy() const;
    void paste();
    void clearSelected();
    void mirror(pattern::Mirror how);
    void rotate();
    /// The selection again and again over the whole chart.
    void repeat();
    /// The edge of the selection goes so many wales and courses outwards; what is selected fills it.
    void repeatBy(int wales, int courses);
    /// Of the selection, else of all: what leaves on one side comes in on the other.
    void shift(int wales, int courses);
    void moveSelected(int wales, int courses);
    /// Stitch and yarn under the cursor.
    void pick();
    void insertCourses();
    void removeCourses();
    void insertWales();
    void removeWales();
    /// Of the cursor's course, or of those of the selection.
    void chooseCourseYarn();
    void editStitchSize();
    void editRacking();
    /// Of the selected courses, else of all.
    void chooseColourMethod();
    void useBothBeds(bool both);

    QSize sizeHint() const override { return {420, 420}; }

signals:
    void toolChanged();
    void selectionChanged();
    void picked(knittsim::pattern::Cell cell);
    void hovered(const QString& text);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;
    bool viewportEvent(QEvent* event) override;

private:
    /// What the left button does while it is held in Select.
    enum class Drag { None, Select, Move, Tile, Scroll };

    const pattern::Chart& shown() const; ///< with what a stroke or a drag has done so far
    void takeChart();
    std::optional<pattern::CellPlace> placeAt(QPoint position) const;
    pattern::CellPlace nearestPlace(QPoint position) const;
    pattern::CellRange target() const; ///< the selection, else the cell under the cursor
    void beginStroke(pattern::CellPlace at);
    void endStroke();
    /// The edges of the selection at a position.
    Qt::Edges edgesAt(QPoint position) const;
    void showGrip(QPoint position);
    void beginSelecting(QPoint position);
    void dragSelection(pattern::CellPlace at);
    void endSelecting();
    void moveCursor(int across, int up, bool selecting);
    void showSelected();
    void show(pattern::CellPlace place);
    QRect handle() const; ///< that repeats the selection when it is dragged
    QRect rectOf(pattern::CellRange range) const;
    pattern::CellRange stampRange(pattern::CellPlace at) const;
    void hover(std::optional<pattern::CellPlace> place);
    QString textOf(pattern::CellPlace place) const;
    QColor colourOf(const pattern::Cell& cell) const;

    // chart_canvas_sides.cpp
    void takeFacts();
    void takeNotes();
    std::vector<CourseNote::Yarn> yarnsOf(int course) const;
    pattern::CellRange coursesAt(int course) const;
    void editSide(SidePlace place, QPoint position);
    void chooseYarn(int course, std::optional<std::uint8_t> from, QPoint globalPosition);
    void editNumber(SidePlace place);

    // chart_canvas_colours.cpp
    void setColourMethod(pattern::CellRange courses, pattern::ColourMethod method);

    // chart_canvas_paint.cpp
    void paintGrounds(QPainter& painter) const;
    void paintCells(QPainter& painter);
    void paintMarks(QPainter& painter) const;
    void paintProblems(QPainter& painter) const;
    const QPixmap& symbol(pattern::Stitch stitch, const QSize& size, bool darkInk);

    document::Document& m_document;
    std::shared_ptr<const pattern::Project> m_project;
    std::vector<document::CourseFacts> m_facts; ///< by course; empty while the fabric does not follow
    ChartTool m_tool = ChartTool::Select;
    pattern::Brush m_brush{pattern::Stitch::Purl, std::nullopt};
    const pattern::Module* m_module = nullptr;
    std::optional<ChartStroke> m_stroke;
    std::optional<pattern::Chart> m_moved; ///< the chart while the selection is dragged
    Drag m_drag = Drag::None;
    Qt::Edges m_dragged; ///< of the selection, while it is repeated
    std::optional<pattern::CellPlace> m_hovered;
    pattern::CellRange m_selection;
    pattern::CellRange m_rangeAtPress;
    pattern::CellRange m_repeated; ///< the selection that repeatBy() has left, of the cells below
    pattern::CellRange m_repeatedFrom;
    pattern::CellPlace m_cellAtPress;
    pattern::CellPlace m_cursor;
    pattern::CellPlace m_anchor; ///< of a selection by keys
    QHash<quint64, QPixmap> m_symbols;
};

} // namespace knittsim::ui
