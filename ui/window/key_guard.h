#pragma once

#include <QEvent>
#include <QObject>

class QKeyEvent;
class QWidget;

namespace knittsim::ui {

/// Keeps the keys that step the machine (Space, the arrows, Home and End, also with Shift) working wherever
/// the focus is in a window with the property kSteps: no control takes them. With Ctrl they go to the control
/// that has the focus, and Enter presses a button. Where the property is false, fields in which text is
/// written keep all of these keys and charts keep the arrows; where it is true nothing does. The menu bar
/// keeps them always. Install it on the application.
class KeyGuard : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    static constexpr const char* kSteps = "stepsEverywhere";

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool takesPress(QWidget* widget, const QKeyEvent& key);
    void send(QWidget* to, QEvent::Type type, int key, Qt::KeyboardModifiers modifiers);

    bool m_sending = false; ///< a key to a control
};

} // namespace knittsim::ui
