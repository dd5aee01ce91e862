#include "ui/views/chart_editor/chart_canvas.h"

#include "ui/views/chart_editor/stitch_picture.h"

#include <algorithm>
#include <cmath>

namespace knittsim::ui {

using pattern::CellPlace;
using pattern::CellRange;
using pattern::Chart;

namespace {

constexpr int kHandle = 9; ///< pixels
constexpr int kGrip = 3;   ///< pixels on both sides of an edge

} // namespace

ChartCanvas::ChartCanvas(document::Document& document, ChartLook& look, QWidget* parent)
    : ChartArea(look, {.leastFitted = 5, .largestFitted = 30, .leastWithLines = 6}, parent),
      m_document(document) {
    setObjectName(QStringLiteral("chartCanvas"));
    setAccessibleName(tr("Chart"));
    setWhatsThis(tr("Wales across, courses up. The left button draws, the right one picks stitch and yarn."));
    connect(&m_document, &document::Document::chartChanged, this, &ChartCanvas::takeChart);
    connect(&m_document, &document::Document::opened, this, [this] {
        select({});
        m_cursor = {};
        fitChart();
        scrollToFirstCourse();
    });
    const auto repaint = [this] { viewport()->update(); };
    connect(&m_document, &document::Document::stepChanged, this, repaint);
    connect(&m_document, &document::Document::selectionChanged, this, repaint);
    connect(&m_document, &document::Document::yarnsChanged, this, &ChartCanvas::takeNotes);
    connect(&m_document, &document::Document::chartFollowed, this, &ChartCanvas::takeFacts);
    connect(&m_document, &document::Document::problemsChanged, this, repaint);
    connect(&m_document, &document::Document::selectionChanged, this, &ChartCanvas::showSelected);
    takeChart();
    takeFacts();
}

void ChartCanvas::takeChart() {
    m_stroke.reset();
    m_moved.reset();
    m_drag = Drag::None;
    m_project = m_document.project();
    const Chart& chart = shown();
    if (m_selection != pattern::inside(chart, m_selection)) {
        select({});
    }
    m_cursor = {std::clamp(m_cursor.wale, 0, std::max(0, chart.width - 1)),
                std::clamp(m_cursor.course, 0, std::max(0, chart.height() - 1))};
    setChart(chart.width, chart.height(), chart.beds == pattern::BedUse::Double,
             m_project ? m_project->firstNeedle : 1);
    takeNotes();
}

const Chart& ChartCanvas::shown() const {
    static const Chart kNone;
    return m_stroke ? m_stroke->chart() : m_moved ? *m_moved : m_project ? m_project->chart : kNone;
}

void ChartCanvas::setModule(const pattern::Module* module) {
    m_module = module;
    emit toolChanged();
    viewport()->update();
}

void ChartCanvas::setTool(ChartTool tool) {
    if (tool != m_tool) {
        m_tool = tool;
        viewport()->setCursor(tool == ChartTool::Select ? Qt::ArrowCursor : Qt::CrossCursor);
        emit toolChanged();
    }
}

void ChartCanvas::select(CellRange range) {
    range = range.empty() ? CellRange{} : pattern::inside(shown(), range);
    if (range != m_selection) {
        m_selection = range;
        emit selectionChanged();
        viewport()->update();
    }
}

void ChartCanvas::selectAll() {
    select({0, 0, shown().width, shown().height()});
}

CellRange ChartCanvas::target() const {
    return m_selection.empty() ? CellRange{m_cursor.wale, m_cursor.course, 1, 1} : m_selection;
}

std::optional<CellPlace> ChartCanvas::placeAt(QPoint position) const {
    const ChartGeometry::Cell cell = geometryOfChart().cellAt(position);
    return cell.course < 0 ? std::nullopt : std::optional(CellPlace{cell.column, cell.course});
}

/// Of a position outside the chart: the cell at its edge.
CellPlace ChartCanvas::nearestPlace(QPoint position) const {
    const QPoint at = position - geometryOfChart().origin();
    const auto cell = [](int pixels, int size) {
        return static_cast<int>(std::floor(static_cast<double>(pixels) / size));
    };
    return {
        std::clamp(cell(at.x(), geometryOfChart().cellWidth), 0, std::max(0, geometryOfChart().columns - 1)),
        std::clamp(geometryOfChart().courses - 1 - cell(at.y(), geometryOfChart().cellHeight()), 0,
                   std::max(0, geometryOfChart().courses - 1))};
}

void ChartCanvas::beginStroke(CellPlace at) {
    if (!m_project || (m_tool == ChartTool::Stamp && m_module == nullptr)) {
        return;
    }
    m_stroke.emplace(m_project->chart, m_tool, m_brush, m_module, at);
    viewport()->update();
}

void ChartCanvas::endStroke() {
    if (m_stroke) {
        const QString text = m_stroke->text();
        const Chart after = m_stroke->chart();
        m_stroke.reset();
        m_document.editChart(text, [&](Chart& chart) { chart = after; });
        viewport()->update();
    }
}

QRect ChartCanvas::rectOf(CellRange range) const {
    const QRect low = geometryOfChart().cellRect(range.course, range.wale);
    const QRect high =
        geometryOfChart().cellRect(range.course + range.height - 1, range.wale + range.width - 1);
    return low.united(high);
}

QRect ChartCanvas::handle() const {
    return m_selection.empty() ? QRect()
                               : QRect(rectOf(m_selection).topRight() - QPoint(kHandle / 2, kHandle / 2),
                                       QSize(kHandle, kHandle));
}

Qt::Edges ChartCanvas::edgesAt(QPoint position) const {
    if (m_selection.empty()) {
        return {};
    }
    if (handle().adjusted(-3, -3, 3, 3).contains(position)) {
        return Qt::RightEdge | Qt::TopEdge;
    }
    const QRect rect = rectOf(m_selection);
    if (!rect.adjusted(-kGrip, -kGrip, kGrip, kGrip).contains(position)) {
        return {};
    }
    const auto near = [](int a, int b) { return std::abs(a - b) <= kGrip; };
    Qt::Edges edges;
    edges.setFlag(Qt::LeftEdge, near(position.x(), rect.left()));
    edges.setFlag(Qt::RightEdge, near(position.x(), rect.right()));
    edges.setFlag(Qt::TopEdge, near(position.y(), rect.top()));
    edges.setFlag(Qt::BottomEdge, near(position.y(), rect.bottom()));
    return edges;
}

/// The pointer tells what a drag will do.
void ChartCanvas::showGrip(QPoint position) {
    if (m_tool != ChartTool::Select) {
        return;
    }
    const Qt::Edges edges = edgesAt(position);
    const bool across = edges & (Qt::LeftEdge | Qt::RightEdge);
    const bool up = edges & (Qt::TopEdge | Qt::BottomEdge);
    const auto place = placeAt(position);
    viewport()->setCursor(across && up                            ? Qt::SizeAllCursor
                          : across                                ? Qt::SizeHorCursor
                          : up                                    ? Qt::SizeVerCursor
                          : place && m_selection.contains(*place) ? Qt::OpenHandCursor
                                                                  : Qt::ArrowCursor);
}

/// What a click of the stamp covers.
CellRange ChartCanvas::stampRange(CellPlace at) const {
    return pattern::inside(shown(), {at.wale, at.course, m_module->part.width, m_module->part.height()});
}

void ChartCanvas::hover(std::optional<CellPlace> place) {
    if (place) {
        emit hovered(textOf(*place));
    }
    if (place != m_hovered) {
        m_hovered = place;
        if (m_tool == ChartTool::Stamp) {
            viewport()->update();
        }
    }
}

void ChartCanvas::moveCursor(int across, int up, bool selecting) {
    const Chart& chart = shown();
    m_cursor = {std::clamp(m_cursor.wale + across, 0, std::max(0, chart.width - 1)),
                std::clamp(m_cursor.course + up, 0, std::max(0, chart.height() - 1))};
    if (selecting) {
        select(pattern::rangeOf(m_anchor, m_cursor));
    } else {
        m_anchor = m_cursor;
        select({});
    }
    show(m_cursor);
    setAccessibleDescription(textOf(m_cursor));
    emit hovered(textOf(m_cursor));
    viewport()->update();
}

/// What is selected elsewhere comes into view.
void ChartCanvas::showSelected() {
    if (const auto cell = m_document.cellOfLoop(m_document.selection().loop)) {
        show(*cell);
    }
}

void ChartCanvas::show(CellPlace place) {
    scrollTo(rectOf({place.wale, place.course, 1, 1}), 0);
}

QString ChartCanvas::textOf(CellPlace place) const {
    const Chart& chart = shown();
    if (place.wale >= chart.width || place.course >= chart.height()) {
        return {};
    }
    const pattern::Cell& cell = chart.at(place.wale, place.course);
    QString text = tr("Needle %1, course %2: %3")
                       .arg(place.wale + m_project->firstNeedle)
                       .arg(place.course + 1)
                       .arg(stitchName(cell.stitch));
    if (pattern::isWorked(cell.stitch) && cell.yarn < chart.yarns.size()) {
        text += tr(", carrier %1").arg(QString::fromStdString(chart.yarns[cell.yarn].carrier));
    }
    for (const pattern::LoopMove& move : chart.course(place.course).moves) {
        if (move.from == place.wale) {
            text += tr("; before it the loop goes to wale %1").arg(move.to + 1);
        }
    }
    return text;
}

QColor ChartCanvas::colourOf(const pattern::Cell& cell) const {
    const Chart& chart = shown();
    if (cell.yarn >= chart.yarns.size()) {
        return QColor(Qt::gray);
    }
    const pattern::ChartYarn& own = chart.yarns[cell.yarn];
    for (const document::CarrierYarn& carrier : m_document.carriers()) {
        if (carrier.carrier == own.carrier) {
            const yarn::Colour c = carrier.yarn.colour;
            return {c.r, c.g, c.b};
        }
    }
    return {own.colour.r, own.colour.g, own.colour.b};
}

} // namespace knittsim::ui
