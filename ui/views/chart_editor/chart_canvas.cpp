#include "ui/views/chart_editor/chart_canvas.h"

#include "ui/views/chart_editor/chart_clipboard.h"
#include "ui/views/chart_editor/stitch_picture.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace knittsim::ui {

using pattern::CellPlace;
using pattern::CellRange;
using pattern::Chart;

namespace {

constexpr int kHandle = 9; ///< pixels

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

void ChartCanvas::copy() const {
    if (m_project) {
        copyToClipboard(pattern::copyOf(m_project->chart, target()));
    }
}

void ChartCanvas::cut() {
    copy();
    m_document.editChart(tr("cut"), [range = target()](Chart& chart) { pattern::clear(chart, range); });
}

void ChartCanvas::paste() {
    const auto part = partOnClipboard();
    if (!part || !m_project) {
        return;
    }
    const CellPlace at = m_selection.empty() ? m_cursor : CellPlace{m_selection.wale, m_selection.course};
    m_document.editChart(tr("paste"), [&](Chart& chart) { pattern::paste(chart, at, *part); });
    select({at.wale, at.course, part->width, part->height()});
}

void ChartCanvas::clearSelected() {
    m_document.editChart(tr("clear"), [range = target()](Chart& chart) { pattern::clear(chart, range); });
}

void ChartCanvas::mirror(pattern::Mirror how) {
    const CellRange all{0, 0, shown().width, shown().height()};
    const CellRange range = m_selection.empty() ? all : m_selection;
    m_document.editChart(tr("mirror"), [&](Chart& chart) { pattern::mirror(chart, range, how); });
}

void ChartCanvas::rotate() {
    m_document.editChart(tr("rotate"), [this](Chart& chart) { pattern::rotate(chart, m_selection); });
}

void ChartCanvas::repeat() {
    if (m_selection.empty()) {
        return;
    }
    m_document.editChart(tr("repeat"), [this](Chart& chart) {
        const Chart part = pattern::copyOf(chart, m_selection);
        // The selection stays where it is; the repeats reach from it to all sides.
        const auto start = [](int at, int size) { return at - (at + size - 1) / size * size; };
        const int left = start(m_selection.wale, part.width);
        const int bottom = start(m_selection.course, part.height());
        for (int c = bottom; c < chart.height(); c += part.height()) {
            for (int w = left; w < chart.width; w += part.width) {
                pattern::paste(chart, {w, c}, part);
            }
        }
    });
}

void ChartCanvas::insertCourses() {
    m_document.editChart(tr("insert courses"), [range = target()](Chart& chart) {
        pattern::insertCourses(chart, range.course, range.height);
    });
}

void ChartCanvas::removeCourses() {
    m_document.editChart(tr("remove courses"), [range = target()](Chart& chart) {
        pattern::removeCourses(chart, range.course, range.height);
    });
}

void ChartCanvas::insertWales() {
    m_document.editChart(tr("insert wales"), [range = target()](Chart& chart) {
        pattern::insertWales(chart, range.wale, range.width);
    });
}

void ChartCanvas::removeWales() {
    m_document.editChart(tr("remove wales"), [range = target()](Chart& chart) {
        pattern::removeWales(chart, range.wale, range.width);
    });
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

void ChartCanvas::beginSelecting(QPoint position) {
    m_rangeAtPress = m_selection;
    m_cellAtPress = nearestPlace(position);
    if (handle().adjusted(-3, -3, 3, 3).contains(position)) {
        m_drag = Drag::Tile;
    } else if (!m_selection.empty() && m_selection.contains(m_cellAtPress)) {
        m_drag = Drag::Move;
    } else {
        m_drag = Drag::Select;
        select({m_cellAtPress.wale, m_cellAtPress.course, 1, 1});
    }
}

void ChartCanvas::dragSelection(CellPlace at) {
    const CellRange& from = m_rangeAtPress;
    if (m_drag == Drag::Select) {
        select(pattern::rangeOf(m_cellAtPress, at));
    } else if (m_drag == Drag::Move) {
        m_moved = m_project->chart;
        const Chart part = pattern::copyOf(*m_moved, from);
        pattern::clear(*m_moved, from);
        const CellPlace to{from.wale + at.wale - m_cellAtPress.wale,
                           from.course + at.course - m_cellAtPress.course};
        pattern::paste(*m_moved, to, part);
        select({to.wale, to.course, from.width, from.height});
    } else if (m_drag == Drag::Tile) {
        const CellRange range{from.wale, from.course, std::max(from.width, at.wale - from.wale + 1),
                              std::max(from.height, at.course - from.course + 1)};
        m_moved = m_project->chart;
        pattern::tile(*m_moved, range, pattern::copyOf(m_project->chart, from));
        select(range);
    }
    viewport()->update();
}

void ChartCanvas::endSelecting() {
    if (m_moved) {
        const Chart after = *m_moved;
        const QString text = m_drag == Drag::Tile ? tr("repeat") : tr("move");
        m_moved.reset();
        m_document.editChart(text, [&](Chart& chart) { chart = after; });
    } else if (m_drag == Drag::Move ||
               (m_drag == Drag::Select && m_selection.width * m_selection.height == 1)) {
        // A click: the stitch is selected in all views.
        select({});
        m_document.selectLoop(m_document.loopOfCell(m_cellAtPress));
    }
    m_drag = Drag::None;
}

void ChartCanvas::mousePressEvent(QMouseEvent* event) {
    const QPoint position = event->position().toPoint();
    const auto place = placeAt(position);
    if (m_stroke || m_drag != Drag::None) {
        return; // another button is at work
    }
    if (event->button() == Qt::MiddleButton) {
        beginScrolling(position);
        m_drag = Drag::Scroll;
        return;
    }
    if (event->button() == Qt::RightButton && place) {
        emit picked(shown().at(place->wale, place->course));
        return;
    }
    if (event->button() != Qt::LeftButton || !m_project) {
        return;
    }
    if (const auto side = sideAt(position)) {
        editSide(*side, position);
        return;
    }
    if (place) {
        m_cursor = *place;
        m_anchor = *place;
    }
    if (m_tool == ChartTool::Select) {
        beginSelecting(position);
    } else if (place) {
        beginStroke(*place);
    }
}

void ChartCanvas::mouseMoveEvent(QMouseEvent* event) {
    const QPoint position = event->position().toPoint();
    if (m_drag == Drag::Scroll) {
        scrollFrom(position);
        return;
    }
    if (const auto place = placeAt(position)) {
        emit hovered(textOf(*place));
    }
    if (m_stroke) {
        m_stroke->moveTo(nearestPlace(position));
        viewport()->update();
    } else if (m_drag != Drag::None) {
        const CellPlace at = nearestPlace(position);
        if (m_moved || at != m_cellAtPress) {
            dragSelection(at);
        }
    }
}

void ChartCanvas::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::MiddleButton && m_drag == Drag::Scroll) {
        m_drag = Drag::None;
    } else if (event->button() == Qt::LeftButton) {
        endStroke();
        if (m_drag != Drag::None && m_drag != Drag::Scroll) {
            endSelecting();
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

void ChartCanvas::keyPressEvent(QKeyEvent* event) {
    const bool selecting = event->modifiers() == Qt::ShiftModifier;
    switch (event->key()) {
    case Qt::Key_Left:
        return moveCursor(-1, 0, selecting);
    case Qt::Key_Right:
        return moveCursor(+1, 0, selecting);
    case Qt::Key_Up:
        return moveCursor(0, +1, selecting);
    case Qt::Key_Down:
        return moveCursor(0, -1, selecting);
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (m_tool == ChartTool::Select) {
            m_document.selectLoop(m_document.loopOfCell(m_cursor));
        } else {
            beginStroke(m_cursor);
            endStroke();
        }
        return;
    case Qt::Key_Escape:
        m_stroke.reset();
        m_moved.reset();
        m_drag = Drag::None;
        select({});
        viewport()->update();
        return;
    default:
        break;
    }
    if (!zoomedByKey(event->key())) {
        ChartArea::keyPressEvent(event);
    }
}

bool ChartCanvas::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        // Arrow keys step the machine elsewhere; here they move the cursor. Escape ends what is under way.
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool arrow = key->key() >= Qt::Key_Left && key->key() <= Qt::Key_Down;
        const bool plain = key->modifiers() == Qt::NoModifier || key->modifiers() == Qt::ShiftModifier;
        const bool busy = m_stroke || m_drag != Drag::None || !m_selection.empty();
        if ((arrow && plain) || (key->key() == Qt::Key_Escape && busy)) {
            event->accept();
            return true;
        }
    }
    return ChartArea::event(event);
}

bool ChartCanvas::viewportEvent(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const auto place = placeAt(help->pos());
        QToolTip::showText(help->globalPos(), place ? textOf(*place) : sideText(help->pos()), viewport());
        return true;
    }
    return ChartArea::viewportEvent(event);
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
