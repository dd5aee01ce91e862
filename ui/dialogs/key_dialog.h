#pragma once

#include <QDialog>

class QMenuBar;

namespace knittsim::ui {

/// All keys, read from the menus.
class KeyDialog : public QDialog {
    Q_OBJECT

public:
    KeyDialog(const QMenuBar* menus, QWidget* parent = nullptr);
};

} // namespace knittsim::ui
