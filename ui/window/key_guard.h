#pragma once

#include <QObject>

namespace knittsim::ui {

/// Keeps the window's one-key shortcuts from taking the keys that a focused control needs: Space on buttons,
/// arrows, Home and End in lists. Install it on the application.
class KeyGuard : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace knittsim::ui
