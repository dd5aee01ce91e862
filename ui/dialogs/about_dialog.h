#pragma once

#include <QDialog>

namespace knittsim::ui {

/// Versions, the OpenGL renderer and the licence, with a button that copies them for a report.
class AboutDialog : public QDialog {
    Q_OBJECT

public:
    explicit AboutDialog(const QString& renderer, QWidget* parent = nullptr);

    /// The facts as lines of plain text.
    static QString facts(const QString& renderer);
};

} // namespace knittsim::ui
