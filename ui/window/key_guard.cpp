#include "ui/window/key_guard.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QKeyEvent>
#include <QTextBrowser>

namespace knittsim::ui {

namespace {

bool isWalkKey(int key) {
    return (key >= Qt::Key_Left && key <= Qt::Key_Down) || key == Qt::Key_Home || key == Qt::Key_End;
}

bool needsKey(QObject* widget, int key) {
    if (key == Qt::Key_Space) {
        return qobject_cast<QAbstractButton*>(widget) || qobject_cast<QAbstractItemView*>(widget) ||
               qobject_cast<QComboBox*>(widget);
    }
    return isWalkKey(key) && (qobject_cast<QAbstractItemView*>(widget) || qobject_cast<QComboBox*>(widget) ||
                              qobject_cast<QTextBrowser*>(widget));
}

} // namespace

bool KeyGuard::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->modifiers() == Qt::NoModifier && needsKey(watched, key->key())) {
            event->accept();
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

} // namespace knittsim::ui
