#pragma once

#include <QObject>

namespace knittsim::ui {

/// Keeps the window's one-key shortcuts from taking the keys that a focused control needs: Space on buttons,
/// Up, Down, Home and End in lists. In a window with the property kStepsEverywhere these keys step the
/// machine wherever the focus is, but for fields where text is written. Install it on the application.
class KeyGuard : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    static constexpr const char* kStepsEverywhere = "stepsEverywhere";

    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace knittsim::ui
