// Mouse and keys of the canvas: strokes, the selection, the cursor.

#include "ui/views/chart_editor/chart_canvas.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>

#include <algorithm>

namespace knittsim::ui {

using pattern::CellPlace;
using pattern::CellRange;
using pattern::Chart;

void ChartCanvas::beginSelecting(QPoint position) {
    m_rangeAtPress = m_selection;
    m_cellAtPress = nearestPlace(position);
    m_dragged = edgesAt(position);
    if (m_dragged) {
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
        int left = from.wale;
        int right = from.wale + from.width - 1;
        int bottom = from.course;
        int top = from.course + from.height - 1;
        left = m_dragged & Qt::LeftEdge ? std::min(left, at.wale) : left;
        right = m_dragged & Qt::RightEdge ? std::max(right, at.wale) : right;
        bottom = m_dragged & Qt::BottomEdge ? std::min(bottom, at.course) : bottom;
        top = m_dragged & Qt::TopEdge ? std::max(top, at.course) : top;
        const CellRange range = pattern::rangeOf({left, bottom}, {right, top});
        m_moved = m_project->chart;
        pattern::repeatOver(*m_moved, range, from);
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
    hover(placeAt(position));
    if (event->buttons() == Qt::NoButton) {
        showGrip(position);
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

void ChartCanvas::leaveEvent(QEvent* event) {
    hover(std::nullopt);
    ChartArea::leaveEvent(event);
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

} // namespace knittsim::ui
