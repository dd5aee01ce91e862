#include "ui/views/pattern_editor/chart_area.h"

#include <QEvent>
#include <QScrollBar>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace knittsim::ui {

ChartArea::ChartArea(ChartLook& look, Cells cells, QWidget* parent)
    : QAbstractScrollArea(parent), m_look(look), m_cells(cells) {
    setFocusPolicy(Qt::StrongFocus);
    setFrameShape(QFrame::NoFrame);
    viewport()->setMouseTracking(true);
    horizontalScrollBar()->setSingleStep(24);
    verticalScrollBar()->setSingleStep(24);
    connect(&m_look, &ChartLook::changed, this, [this] { m_fitted ? fitChart() : layoutChart(); });
}

void ChartArea::setChart(int columns, int courses, bool tall, int firstNumber) {
    m_geometry.columns = columns;
    m_geometry.courses = courses;
    m_geometry.tall = tall;
    m_firstNumber = firstNumber;
}

void ChartArea::setNotes(std::vector<CourseNote> notes, bool severalYarns) {
    m_notes = std::move(notes);
    m_severalYarns = severalYarns;
    layoutChart();
}

void ChartArea::layoutChart() {
    m_geometry.view = viewport()->size();
    layoutSides();
    const QSize area = m_geometry.chartArea().size();
    const QSize content = m_geometry.content();
    horizontalScrollBar()->setRange(0, std::max(0, content.width() - area.width()));
    horizontalScrollBar()->setPageStep(std::max(1, area.width()));
    verticalScrollBar()->setRange(0, std::max(0, content.height() - area.height()));
    verticalScrollBar()->setPageStep(std::max(1, area.height()));
    m_geometry.scroll = {horizontalScrollBar()->value(), verticalScrollBar()->value()};
    viewport()->update();
}

void ChartArea::fitChart() {
    layoutChart();
    m_geometry.cellWidth = m_geometry.fittingCell(m_cells.leastFitted, m_cells.largestFitted);
    layoutChart();
    m_fitted = true;
}

void ChartArea::setCellWidth(int width, QPoint fixed) {
    const QPoint before = fixed - m_geometry.origin();
    const double factor = static_cast<double>(width) / m_geometry.cellWidth;
    const double factorY = static_cast<double>(m_geometry.cellHeightOf(width)) / m_geometry.cellHeight();
    m_geometry.cellWidth = width;
    layoutChart();
    const QPoint way = fixed - m_geometry.chartArea().topLeft();
    horizontalScrollBar()->setValue(static_cast<int>(std::lround(before.x() * factor)) - way.x());
    verticalScrollBar()->setValue(static_cast<int>(std::lround(before.y() * factorY)) - way.y());
    layoutChart();
}

void ChartArea::zoomAt(QPoint position, int direction) {
    m_fitted = false;
    setCellWidth(nextCellWidth(m_geometry.cellWidth, direction), position);
}

void ChartArea::scrollTo(const QRect& cell, int margin) {
    const QRect area = m_geometry.chartArea();
    const auto excess = [margin](int low, int high, int from, int to) {
        const int rim = std::min(margin, std::max(0, (to - from - (high - low)) / 2));
        return low - rim < from ? low - rim - from : high + rim > to ? high + rim - to : 0;
    };
    QScrollBar* across = horizontalScrollBar();
    QScrollBar* up = verticalScrollBar();
    across->setValue(across->value() + excess(cell.left(), cell.right(), area.left(), area.right()));
    up->setValue(up->value() + excess(cell.top(), cell.bottom(), area.top(), area.bottom()));
}

void ChartArea::scrollToFirstCourse() {
    verticalScrollBar()->setValue(verticalScrollBar()->maximum());
}

void ChartArea::beginScrolling(QPoint position) {
    m_pressed = position;
    m_scrollAtPress = m_geometry.scroll;
}

void ChartArea::scrollFrom(QPoint position) {
    horizontalScrollBar()->setValue(m_scrollAtPress.x() - (position - m_pressed).x());
    verticalScrollBar()->setValue(m_scrollAtPress.y() - (position - m_pressed).y());
}

bool ChartArea::zoomedByKey(int key) {
    if (key == Qt::Key_Plus || key == Qt::Key_Equal) {
        zoomIn();
        return true;
    }
    if (key == Qt::Key_Minus) {
        zoomOut();
        return true;
    }
    return false;
}

void ChartArea::resizeEvent(QResizeEvent*) {
    if (!m_fitted) {
        layoutChart();
        return;
    }
    const int fromBottom = verticalScrollBar()->maximum() - verticalScrollBar()->value();
    fitChart();
    verticalScrollBar()->setValue(verticalScrollBar()->maximum() - fromBottom);
}

void ChartArea::scrollContentsBy(int, int) {
    m_geometry.scroll = {horizontalScrollBar()->value(), verticalScrollBar()->value()};
    viewport()->update();
}

void ChartArea::wheelEvent(QWheelEvent* event) {
    if (event->modifiers() & Qt::ControlModifier) {
        if (event->angleDelta().y() != 0) {
            zoomAt(event->position().toPoint(), event->angleDelta().y() > 0 ? +1 : -1);
        }
        event->accept();
        return;
    }
    QAbstractScrollArea::wheelEvent(event);
}

void ChartArea::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange) {
        layoutChart();
    }
    QAbstractScrollArea::changeEvent(event);
}

} // namespace knittsim::ui
