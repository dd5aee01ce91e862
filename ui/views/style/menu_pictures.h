#pragma once

class QMenu;

namespace knittsim::ui {

/// The icons of the menu are as large as pictures, `pixels` on their longer side, not as letters.
void showPictures(QMenu* menu, int pixels);

} // namespace knittsim::ui
