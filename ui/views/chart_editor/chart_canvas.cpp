#include "ui/views/chart_editor/chart_canvas.h"

#include "ui/views/chart_editor/chart_clipboard.h"
#include "ui/views/chart_editor/stitch_picture.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QScrollBar>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace knittsim::ui {

using pattern::CellPlace;
using pattern::CellRange;
using pattern::Chart;

namespace {

constexpr int kLeastFitted = 5;
constexpr int kLargestFitted = 30;
constexpr int kHandle = 9; ///< pixels

} // namespace

ChartCanvas::ChartCanvas(document::Document& document, QWidget* parent)
    : QAbstractScrollArea(parent), m_document(document) {
    setObjectName(QStringLiteral("chartCanvas"));
    setAccessibleName(tr("Chart"));
    setWhatsThis(tr("Wales across, courses up. The left button draws, the right one picks stitch and yarn."));
    setFocusPolicy(Qt::StrongFocus);
    setFrameShape(QFrame::NoFrame);
    viewport()->setMouseTracking(true);
    horizontalScrollBar()->setSingleStep(24);
    verticalScrollBar()->setSingleStep(24);
    connect(&m_document, &document::Document::chartChanged, this, &ChartCanvas::takeChart);
    connect(&m_document, &document::Document::opened, this, [this] {
        select({});
        m_cursor = {};
        fit();
        verticalScrollBar()->setValue(verticalScrollBar()->maximum());
    });
    const auto repaint = [this] { viewport()->update(); };
    connect(&m_document, &document::Document::stepChanged, this, repaint);
    connect(&m_document, &document::Document::selectionChanged, this, repaint);
    connect(&m_document, &document::Document::yarnsChanged, this, repaint);
    connect(&m_document, &document::Document::problemsChanged, this, repaint);
    connect(&m_document, &document::Document::selectionChanged, this, &ChartCanvas::showSelected);
    takeChart();
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
    layout();
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

void ChartCanvas::layout() {
    const Chart& chart = shown();
    const QFontMetrics metrics(font());
    const int digits = std::max(3, static_cast<int>(QString::number(chart.height()).size()));
    m_geometry.columns = chart.width;
    m_geometry.courses = chart.height();
    m_geometry.tall = chart.beds == pattern::BedUse::Double;
    m_geometry.view = viewport()->size();
    m_geometry.header = {metrics.horizontalAdvance(QString(digits, u'8')) + 14, metrics.height() + 6};
    const QSize area = m_geometry.chartArea().size();
    const QSize content = m_geometry.content();
    horizontalScrollBar()->setRange(0, std::max(0, content.width() - area.width()));
    horizontalScrollBar()->setPageStep(std::max(1, area.width()));
    verticalScrollBar()->setRange(0, std::max(0, content.height() - area.height()));
    verticalScrollBar()->setPageStep(std::max(1, area.height()));
    m_geometry.scroll = {horizontalScrollBar()->value(), verticalScrollBar()->value()};
    viewport()->update();
}

void ChartCanvas::fit() {
    layout();
    m_geometry.cellWidth = m_geometry.fittingCell(kLeastFitted, kLargestFitted);
    layout();
    m_fitted = true;
}

void ChartCanvas::setCellWidth(int width, QPoint fixed) {
    const QPoint before = fixed - m_geometry.origin();
    const double factor = static_cast<double>(width) / m_geometry.cellWidth;
    const double factorY = static_cast<double>(m_geometry.cellHeightOf(width)) / m_geometry.cellHeight();
    m_geometry.cellWidth = width;
    layout();
    const QPoint way = fixed - m_geometry.chartArea().topLeft();
    horizontalScrollBar()->setValue(static_cast<int>(std::lround(before.x() * factor)) - way.x());
    verticalScrollBar()->setValue(static_cast<int>(std::lround(before.y() * factorY)) - way.y());
    layout();
}

void ChartCanvas::zoomAt(QPoint position, int direction) {
    m_fitted = false;
    setCellWidth(nextCellWidth(m_geometry.cellWidth, direction), position);
}

std::optional<CellPlace> ChartCanvas::placeAt(QPoint position) const {
    const ChartGeometry::Cell cell = m_geometry.cellAt(position);
    return cell.course < 0 ? std::nullopt : std::optional(CellPlace{cell.column, cell.course});
}

/// Of a position outside the chart: the cell at its edge.
CellPlace ChartCanvas::nearestPlace(QPoint position) const {
    const QPoint at = position - m_geometry.origin();
    const auto cell = [](int pixels, int size) {
        return static_cast<int>(std::floor(static_cast<double>(pixels) / size));
    };
    return {std::clamp(cell(at.x(), m_geometry.cellWidth), 0, std::max(0, m_geometry.columns - 1)),
            std::clamp(m_geometry.courses - 1 - cell(at.y(), m_geometry.cellHeight()), 0,
                       std::max(0, m_geometry.courses - 1))};
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
    const QRect low = m_geometry.cellRect(range.course, range.wale);
    const QRect high = m_geometry.cellRect(range.course + range.height - 1, range.wale + range.width - 1);
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
    m_pressed = position;
    m_scrollAtPress = m_geometry.scroll;
    if (event->button() == Qt::MiddleButton) {
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
        const QPoint way = position - m_pressed;
        horizontalScrollBar()->setValue(m_scrollAtPress.x() - way.x());
        verticalScrollBar()->setValue(m_scrollAtPress.y() - way.y());
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
    scrollTo(m_cursor);
    setAccessibleDescription(textOf(m_cursor));
    emit hovered(textOf(m_cursor));
    viewport()->update();
}

/// What is selected elsewhere comes into view.
void ChartCanvas::showSelected() {
    if (const auto cell = m_document.cellOfLoop(m_document.selection().loop)) {
        scrollTo(*cell);
    }
}

void ChartCanvas::scrollTo(CellPlace place) {
    const QRect cell = rectOf({place.wale, place.course, 1, 1});
    const QRect area = m_geometry.chartArea();
    const auto excess = [](int low, int high, int from, int to) {
        return low < from ? low - from : high > to ? high - to : 0;
    };
    horizontalScrollBar()->setValue(horizontalScrollBar()->value() +
                                    excess(cell.left(), cell.right(), area.left(), area.right()));
    verticalScrollBar()->setValue(verticalScrollBar()->value() +
                                  excess(cell.top(), cell.bottom(), area.top(), area.bottom()));
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
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return zoomIn();
    case Qt::Key_Minus:
        return zoomOut();
    default:
        break;
    }
    QAbstractScrollArea::keyPressEvent(event);
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
    return QAbstractScrollArea::event(event);
}

void ChartCanvas::wheelEvent(QWheelEvent* event) {
    if (event->modifiers() & Qt::ControlModifier) {
        if (event->angleDelta().y() != 0) {
            zoomAt(event->position().toPoint(), event->angleDelta().y() > 0 ? +1 : -1);
        }
        event->accept();
        return;
    }
    QAbstractScrollArea::wheelEvent(event);
}

void ChartCanvas::resizeEvent(QResizeEvent*) {
    m_fitted ? fit() : layout();
}

void ChartCanvas::scrollContentsBy(int, int) {
    m_geometry.scroll = {horizontalScrollBar()->value(), verticalScrollBar()->value()};
    viewport()->update();
}

bool ChartCanvas::viewportEvent(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const auto place = placeAt(help->pos());
        QToolTip::showText(help->globalPos(), place ? textOf(*place) : QString(), viewport());
        return true;
    }
    return QAbstractScrollArea::viewportEvent(event);
}

QString ChartCanvas::textOf(CellPlace place) const {
    const Chart& chart = shown();
    if (place.wale >= chart.width || place.course >= chart.height()) {
        return {};
    }
    const pattern::Cell& cell = chart.at(place.wale, place.course);
    QString text =
        tr("Wale %1, course %2: %3").arg(place.wale + 1).arg(place.course + 1).arg(stitchName(cell.stitch));
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
