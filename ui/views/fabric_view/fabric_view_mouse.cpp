#include "ui/views/fabric_view/fabric_view_implementation.h"

#include <QCursor>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>

#include <cmath>
#include <utility>

namespace knittsim::ui {

namespace {

constexpr int kClickPixels = 4;    ///< a press that moves farther is a drag
constexpr double kWheelStep = 1.2; ///< zoom of one notch

} // namespace

void FabricView::resizeEvent(QResizeEvent*) {
    m->placeChildren();
    if (m->followFit && m->content.scene) {
        m->fitCamera();
    }
}

void FabricView::mousePressEvent(QMouseEvent* event) {
    using Gesture = Implementation::Gesture;
    m->pressed = m->last = event->position();
    const bool pan = event->button() == Qt::MiddleButton || event->modifiers().testFlag(Qt::ShiftModifier);
    const bool pull = m->dragMode || event->modifiers().testFlag(Qt::ControlModifier);
    if (pan) {
        m->gesture = Gesture::Pan;
    } else if (event->button() != Qt::LeftButton) {
        QWidget::mousePressEvent(event);
    } else if (const auto pick = pull ? m->pickAt(event->position()) : std::nullopt) {
        m->gesture = Gesture::Pull;
        m->pulled = *pick;
        m->pullTarget.reset();
        setCursor(Qt::ClosedHandCursor);
    } else {
        m->gesture = Gesture::Press;
    }
}

void FabricView::mouseMoveEvent(QMouseEvent* event) {
    using Gesture = Implementation::Gesture;
    const QPointF moved = event->position() - m->last;
    const auto right = static_cast<float>(moved.x());
    const auto down = static_cast<float>(moved.y());
    if (m->gesture == Gesture::Press && (event->position() - m->pressed).manhattanLength() > kClickPixels) {
        m->gesture = Gesture::Orbit;
    }
    switch (m->gesture) {
    case Gesture::None: {
        const auto pick = m->pickAt(event->position());
        m->hover(pick ? pick->loop : -1);
        if (m->annotations.tape.size() == 1) {
            m->annotations.tapeEnd = m->tapePlaceAt(event->position());
            m->overlay->update();
        }
        break;
    }
    case Gesture::Press:
        return; // keeps `last`, so that nothing is lost when it becomes a drag
    case Gesture::Orbit:
        m->moveCamera([&](render::Camera& camera) { camera.orbit(right, down); });
        break;
    case Gesture::Pan:
        m->moveCamera([&](render::Camera& camera) { camera.pan(right, down); });
        break;
    case Gesture::Pull:
        m->pullTo(event->position());
        break;
    }
    m->last = event->position();
}

void FabricView::mouseReleaseEvent(QMouseEvent* event) {
    using Gesture = Implementation::Gesture;
    const Gesture gesture = std::exchange(m->gesture, Gesture::None);
    if (gesture == Gesture::Pull) {
        setDragMode(m->dragMode);
        m->placeMarks();
        emit dragEnded();
    } else if (gesture == Gesture::Press && isAligning()) {
        m->alignClick(event->position());
    } else if (gesture == Gesture::Press && m->annotations.taping) {
        m->tapeClick(event->position());
    } else if (gesture == Gesture::Press) {
        const auto pick = m->pickAt(event->position());
        emit loopClicked(pick ? pick->loop : -1);
        emit pointClicked(pick ? pick->point : -1);
    } else if (gesture == Gesture::None) {
        QWidget::mouseReleaseEvent(event);
    }
}

void FabricView::wheelEvent(QWheelEvent* event) {
    // With Alt the wheel turns to the side.
    if (event->modifiers().testFlag(Qt::AltModifier) && m->content.section && m->content.scene) {
        m->moveSection((event->angleDelta().x() + event->angleDelta().y()) / 120.0);
        event->accept();
        return;
    }
    const double notches = event->angleDelta().y() / 120.0;
    const QPointF where = event->position();
    m->moveCamera([&](render::Camera& camera) {
        camera.zoomAt(static_cast<float>(where.x()), static_cast<float>(where.y()),
                      static_cast<float>(std::pow(kWheelStep, notches)));
    });
    event->accept();
}

void FabricView::leaveEvent(QEvent*) {
    m->annotations.tapeEnd.reset();
    m->overlay->update();
    m->hover(-1);
}

bool FabricView::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const auto pick = m->pickAt(help->pos());
        QToolTip::showText(help->globalPos(), pick && pick->loop >= 0 ? m->describe(pick->loop) : QString(),
                           this);
        return true;
    }
    return QWidget::event(event);
}

} // namespace knittsim::ui
