#include "ui/window/key_guard.h"

#include "ui/views/pattern_editor/chart_area.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QMenuBar>
#include <QVariant>
#include <QWidget>

namespace knittsim::ui {

namespace {

bool isArrow(int key) {
    return key >= Qt::Key_Left && key <= Qt::Key_Down;
}

bool isStepKey(int key) {
    return key == Qt::Key_Space || isArrow(key) || key == Qt::Key_Home || key == Qt::Key_End;
}

/// Of the window that a widget is in, also of a panel that floats: kSteps.
QVariant stepsOf(const QWidget* widget) {
    const QWidget* window = widget->window();
    if (window->windowType() == Qt::Tool && window->parentWidget()) {
        window = window->parentWidget()->window();
    }
    return window->property(KeyGuard::kSteps);
}

/// Its keys step the machine.
bool yields(const QWidget* widget, int key) {
    const QVariant steps = stepsOf(widget);
    if (!steps.isValid() || qobject_cast<const QMenuBar*>(widget)) {
        return false;
    }
    const bool writes =
        widget->testAttribute(Qt::WA_InputMethodEnabled) && !qobject_cast<const QAbstractItemView*>(widget);
    const bool walks = isArrow(key) && qobject_cast<const ChartArea*>(widget);
    return steps.toBool() || !(writes || walks);
}

bool takesOverride(const QWidget* widget, QKeyEvent* key) {
    if (!isStepKey(key->key()) || !stepsOf(widget).isValid()) {
        return false;
    }
    if (qobject_cast<const QMenuBar*>(widget)) {
        key->accept();
        return true;
    }
    const Qt::KeyboardModifiers pressed = key->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
    if (!yields(widget, key->key()) || (pressed && pressed != Qt::ControlModifier)) {
        return false;
    }
    key->setAccepted(pressed == Qt::ControlModifier); // accepted: it is for the control
    return true;
}

} // namespace

bool KeyGuard::takesPress(QWidget* widget, const QKeyEvent& key) {
    const bool presses = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
    if (presses && key.modifiers() == Qt::NoModifier && stepsOf(widget).isValid() &&
        (qobject_cast<QAbstractButton*>(widget) || qobject_cast<QComboBox*>(widget))) {
        send(widget, QEvent::KeyPress, Qt::Key_Space, {});
        send(widget, QEvent::KeyRelease, Qt::Key_Space, {});
        return true;
    }
    if (key.modifiers().testFlag(Qt::ControlModifier) && isStepKey(key.key()) && yields(widget, key.key())) {
        send(widget, QEvent::KeyPress, key.key(), key.modifiers() & ~Qt::ControlModifier);
        return true;
    }
    return false;
}

void KeyGuard::send(QWidget* to, QEvent::Type type, int key, Qt::KeyboardModifiers modifiers) {
    m_sending = true;
    QKeyEvent event(type, key, modifiers, key == Qt::Key_Space ? QStringLiteral(" ") : QString());
    QCoreApplication::sendEvent(to, &event);
    m_sending = false;
}

bool KeyGuard::eventFilter(QObject* watched, QEvent* event) {
    const bool overrides = event->type() == QEvent::ShortcutOverride;
    if (overrides && m_sending) {
        event->accept();
        return true;
    }
    if (!overrides && event->type() != QEvent::KeyPress) {
        return false;
    }
    auto* widget = qobject_cast<QWidget*>(watched);
    // What a control leaves goes on to those it lies in; it is for the control to say.
    if (QWidget* focus = QApplication::focusWidget(); widget && focus && widget->isAncestorOf(focus)) {
        widget = focus;
    }
    auto* key = static_cast<QKeyEvent*>(event);
    return widget && (overrides ? takesOverride(widget, key) : takesPress(widget, *key));
}

} // namespace knittsim::ui
