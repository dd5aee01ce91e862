#pragma once

#include <QIcon>
#include <QString>

namespace knittsim::ui {

/// An icon of resources/icons, drawn in the text colour of the application's palette at the time of painting,
/// so that it follows the appearance and any pixel density.
QIcon icon(const QString& name);

/// The same drawing in a colour of its own (severities).
QIcon icon(const QString& name, const QColor& colour);

/// The application's icon.
QIcon applicationIcon();

} // namespace knittsim::ui
