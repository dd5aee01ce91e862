#pragma once

#include "ui/document/session.h"

#include <QColor>
#include <QPalette>

class QApplication;
class QWidget;

namespace knittsim::ui {

/// Own palettes for the Fusion style; every text has a contrast of 4.5 to 1 or more.
QPalette lightPalette();
QPalette darkPalette();

/// Told by the lightness of the window colour (Qt 6.4 knows no colour scheme).
bool isDark(const QPalette& palette);

/// Sets Fusion and the palette. The palette before the first call is taken as the system's.
void applyAppearance(QApplication& application, document::Appearance appearance);

/// Black on white, or white on black: what a projector in a bright room still shows. Keeps the appearance.
void applyContrast(QApplication& application, bool on);

/// Colours beyond the palette.
struct Accents {
    QColor good; ///< at rest
    QColor busy; ///< settling
    QColor warning;
    QColor error;
    QColor faintText; ///< secondary text, contrast of at least 4.5 to 1
    QColor line;      ///< separators and grids
};
Accents accentsOf(const QPalette& palette);

/// The ground of a card that lies over the fabric, for its paintEvent.
void paintCard(QWidget& card);

/// The colour of dark or light ink that reads best on `ground`.
QColor inkOn(const QColor& ground);

} // namespace knittsim::ui
