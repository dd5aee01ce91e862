#include "ui/views/pattern_editor/pattern_grid.h"

#include "ui/document/message_text.h"
#include "ui/document/operation_text.h"

#include <QAccessible>
#include <QApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QToolTip>

#include <algorithm>

namespace knittsim::ui {

using document::GridCell;
using document::GridPlace;
using machine::LoopIndex;

PatternGrid::PatternGrid(document::Document& document, ChartLook& look, QWidget* parent)
    : ChartArea(look, {.leastFitted = 9, .largestFitted = 26, .leastWithLines = 7}, parent),
      m_document(document) {
    setObjectName(QStringLiteral("patternGrid"));
    setAccessibleName(tr("Pattern grid"));
    setWhatsThis(tr(
        "Needles across, courses up, one cell a stitch. Click selects a stitch; Ctrl and the wheel zoom."));
    connect(&m_document, &document::Document::fileChanged, this, &PatternGrid::takeFile);
    connect(&m_document, &document::Document::stepChanged, this, &PatternGrid::takeStep);
    connect(&m_document, &document::Document::selectionChanged, this, &PatternGrid::takeSelection);
    connect(&m_document, &document::Document::yarnsChanged, this, &PatternGrid::takeYarns);
    connect(&m_document, &document::Document::problemsChanged, viewport(), qOverload<>(&QWidget::update));
    takeFile();
}

const document::StitchGrid* PatternGrid::grid() const {
    const auto file = m_document.file();
    return file ? file->grid.get() : nullptr;
}

namespace {

std::vector<document::CourseFacts> factsOf(const document::OpenedFile* file) {
    if (!file) {
        return {};
    }
    std::vector<int> courses(file->timeline->program().operations.size(), -1);
    const auto& loops = file->timeline->loops().loops;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        courses[static_cast<std::size_t>(loops[i].operation)] =
            file->grid->placeOf(static_cast<LoopIndex>(i)).course;
    }
    return document::courseFacts(
        file->timeline->program(), file->grid->courseCount(),
        [&](machine::OperationIndex operation) { return courses[static_cast<std::size_t>(operation)]; });
}

} // namespace

void PatternGrid::takeFile() {
    const document::StitchGrid* chart = grid();
    if (chart) {
        setChart(chart->columnCount(), chart->courseCount(), chart->usesBothBeds(), chart->firstColumn());
    } else {
        setChart(0, 0, false, 0);
    }
    m_hover = -1;
    m_facts = factsOf(m_document.file().get());
    takeYarns();
    takeStep();
    fitChart();
    scrollToFirstCourse();
}

void PatternGrid::takeStep() {
    const auto file = m_document.file();
    m_knitted = 0;
    m_currentCourse = -1;
    if (file) {
        const auto& loops = file->timeline->loops().loops;
        const auto end = std::lower_bound(
            loops.begin(), loops.end(), m_document.step(),
            [](const machine::Loop& loop, machine::OperationIndex step) { return loop.operation < step; });
        m_knitted = static_cast<LoopIndex>(end - loops.begin());
        m_currentCourse = m_knitted > 0 ? file->grid->placeOf(m_knitted - 1).course : -1;
    }
    viewport()->update();
}

void PatternGrid::takeSelection() {
    const LoopIndex loop = m_document.selection().loop;
    if (loop >= 0 && grid()) {
        showLoop(loop);
        const auto file = m_document.file();
        setAccessibleDescription(
            document::stitchText(file->timeline->program(), file->timeline->loops(), *grid(), loop));
        QAccessibleEvent changed(this, QAccessible::DescriptionChanged);
        QAccessible::updateAccessibility(&changed);
    }
    viewport()->update();
}

void PatternGrid::takeYarns() {
    m_colours.clear();
    for (const document::CarrierYarn& carrier : m_document.carriers()) {
        const yarn::Colour c = carrier.yarn.colour;
        m_colours.emplace_back(c.r, c.g, c.b);
    }
    takeNotes();
}

void PatternGrid::takeNotes() {
    std::vector<CourseNote> notes;
    std::optional<double> before;
    for (const document::CourseFacts& facts : m_facts) {
        CourseNote& note = notes.emplace_back();
        for (const document::CourseFacts::Feed& feed : facts.feeds) {
            const document::CarrierYarn* carrier =
                feed.carrier < m_document.carriers().size() ? &m_document.carriers()[feed.carrier] : nullptr;
            note.yarns.push_back(
                {carrier ? QString::fromStdString(carrier->carrier) : QString(),
                 feed.carrier < m_colours.size() ? m_colours[feed.carrier] : QColor(Qt::gray),
                 machine::sign(feed.direction)});
        }
        note.stitchSize = facts.stitchSize;
        note.ownStitchSize = facts.stitchSize != before;
        before = facts.stitchSize;
        note.racking = facts.racking;
    }
    setNotes(std::move(notes));
}

QColor PatternGrid::colourOf(LoopIndex loop) const {
    const auto& loops = m_document.file()->timeline->loops().loops;
    const std::size_t carrier = loops[static_cast<std::size_t>(loop)].carrier;
    return carrier < m_colours.size() ? m_colours[carrier] : QColor(Qt::gray);
}

QPoint PatternGrid::showLoop(LoopIndex loop) {
    const GridPlace place = grid()->placeOf(loop);
    scrollTo(geometryOfChart().cellRect(place.course, place.column - grid()->firstColumn()),
             2 * geometryOfChart().cellWidth);
    return rectOf(loop).center();
}

QRect PatternGrid::rectOf(LoopIndex loop) const {
    const GridPlace place = grid()->placeOf(loop);
    QRect rect = geometryOfChart().cellRect(place.course, place.column - grid()->firstColumn());
    const GridCell* cell = grid()->cellAt(place.course, place.column);
    if (cell && cell->front >= 0 && cell->rear >= 0) {
        rect.setHeight(rect.height() / 2);
        if (!place.rear) {
            rect.translate(0, rect.height());
        }
    }
    return rect;
}

LoopIndex PatternGrid::loopAt(QPoint position) const {
    const ChartGeometry::Cell at = geometryOfChart().cellAt(position);
    const GridCell* cell =
        at.course >= 0 ? grid()->cellAt(at.course, at.column + grid()->firstColumn()) : nullptr;
    if (!cell) {
        return -1;
    }
    if (cell->front >= 0 && cell->rear >= 0) {
        return at.upperHalf ? cell->rear : cell->front;
    }
    return std::max(cell->front, cell->rear);
}

QString PatternGrid::textAt(QPoint position) const {
    const auto file = m_document.file();
    if (!file) {
        return {};
    }
    const machine::Program& program = file->timeline->program();
    if (const LoopIndex loop = loopAt(position); loop >= 0) {
        const QString stitch = document::stitchText(program, file->timeline->loops(), *grid(), loop);
        const document::ProblemMarks& marks = m_document.problemMarks();
        const auto mark = marks.find(loop);
        return mark == marks.end() ? stitch
                                   : stitch + u'\n' + document::severityText(mark->second.severity) + u' ' +
                                         QString::fromStdString(mark->second.id) + QStringLiteral(": ") +
                                         document::causeText(mark->second);
    }
    const ChartGeometry::Cell at = geometryOfChart().cellAt(position);
    const std::int32_t column = at.column + grid()->firstColumn();
    const document::GridFloat* strand = at.course >= 0 ? grid()->floatAt(at.course, column) : nullptr;
    return strand ? tr("Needle %1, course %2: miss, carrier %3 floats past")
                        .arg(column)
                        .arg(at.course + 1)
                        .arg(document::carrierText(program, {strand->carrier}))
                  : QString();
}

void PatternGrid::setHover(LoopIndex loop) {
    if (loop != m_hover) {
        m_hover = loop;
        viewport()->update();
        emit loopHovered(loop);
    }
}

void PatternGrid::mousePressEvent(QMouseEvent* event) {
    m_pressed = event->position().toPoint();
    beginScrolling(m_pressed);
    m_dragging = false;
}

void PatternGrid::mouseMoveEvent(QMouseEvent* event) {
    const QPoint position = event->position().toPoint();
    if (event->buttons() & (Qt::LeftButton | Qt::MiddleButton)) {
        m_dragging =
            m_dragging || (position - m_pressed).manhattanLength() >= QApplication::startDragDistance();
        if (m_dragging) {
            scrollFrom(position);
        }
        return;
    }
    setHover(grid() ? loopAt(position) : -1);
}

void PatternGrid::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && !m_dragging && grid()) {
        m_document.selectLoop(loopAt(event->position().toPoint()));
    }
    m_dragging = false;
}

bool PatternGrid::moveSelection(int key) {
    const document::StitchGrid* chart = grid();
    if (!chart || chart->loopCount() == 0) {
        return false;
    }
    const LoopIndex loop = m_document.selection().loop;
    if (loop < 0) {
        m_document.selectLoop(std::max(0, m_knitted - 1));
        return true;
    }
    GridPlace place = chart->placeOf(loop);
    const int across = key == Qt::Key_Right ? 1 : key == Qt::Key_Left ? -1 : 0;
    const int up = key == Qt::Key_Up ? 1 : key == Qt::Key_Down ? -1 : 0;
    const GridCell* cell = chart->cellAt(place.course, place.column);
    if (up != 0 && cell->front >= 0 && cell->rear >= 0 && place.rear == (up < 0)) {
        m_document.selectLoop(up > 0 ? cell->rear : cell->front);
        return true;
    }
    const std::int32_t end = chart->firstColumn() + chart->columnCount();
    do {
        place.column += across;
        place.course += up;
        cell = chart->cellAt(place.course, place.column);
    } while (!cell && place.column > chart->firstColumn() && place.column < end && place.course > 0 &&
             place.course < chart->courseCount());
    if (cell) {
        const bool rear = up > 0       ? cell->front < 0
                          : up < 0     ? cell->rear >= 0
                          : place.rear ? cell->rear >= 0
                                       : cell->front < 0;
        m_document.selectLoop(rear ? cell->rear : cell->front);
    }
    return true;
}

void PatternGrid::keyPressEvent(QKeyEvent* event) {
    const bool arrow = event->key() >= Qt::Key_Left && event->key() <= Qt::Key_Down;
    if (arrow && event->modifiers() == Qt::NoModifier && moveSelection(event->key())) {
        return;
    }
    if (!zoomedByKey(event->key())) {
        ChartArea::keyPressEvent(event);
    }
}

bool PatternGrid::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        // The plain arrow keys step the machine elsewhere; in the chart they walk from stitch to stitch.
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool arrow = key->key() >= Qt::Key_Left && key->key() <= Qt::Key_Down;
        if (arrow && key->modifiers() == Qt::NoModifier) {
            event->accept();
            return true;
        }
    }
    return ChartArea::event(event);
}

bool PatternGrid::viewportEvent(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const QString side = sideText(help->pos());
        QToolTip::showText(help->globalPos(), side.isEmpty() ? textAt(help->pos()) : side, viewport());
        return true;
    }
    if (event->type() == QEvent::Leave) {
        setHover(-1);
    }
    return ChartArea::viewportEvent(event);
}

} // namespace knittsim::ui
