#include "ui/window/key_guard.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QKeyEvent>
#include <QTextBrowser>
#include <QWidget>

namespace knittsim::ui {

namespace {

bool isWalkKey(int key) {
    return (key >= Qt::Key_Left && key <= Qt::Key_Down) || key == Qt::Key_Home || key == Qt::Key_End;
}

bool needsKey(QObject* widget, int key) {
    if (key == Qt::Key_Space) {
        return qobject_cast<QAbstractButton*>(widget) || qobject_cast<QComboBox*>(widget);
    }
    if (qobject_cast<QAbstractItemView*>(widget)) {
        return isWalkKey(key) && key != Qt::Key_Left && key != Qt::Key_Right; // lists are walked up and down
    }
    return isWalkKey(key) && (qobject_cast<QComboBox*>(widget) || qobject_cast<QTextBrowser*>(widget));
}

bool stepsMachine(const QKeyEvent& key) {
    const bool plain = !(key.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier));
    return plain && (key.key() == Qt::Key_Space || isWalkKey(key.key()));
}

/// Text is still written where it is asked for.
bool stepsFrom(QObject* watched) {
    const auto* widget = qobject_cast<QWidget*>(watched);
    return widget && widget->window()->property(KeyGuard::kStepsEverywhere).toBool() &&
           !widget->testAttribute(Qt::WA_InputMethodEnabled);
}

} // namespace

bool KeyGuard::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (stepsMachine(*key) && stepsFrom(watched)) {
            event->ignore();
            return true;
        }
        if (key->modifiers() == Qt::NoModifier && needsKey(watched, key->key())) {
            event->accept();
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

} // namespace knittsim::ui
