#pragma once

#include "core/yarn/count.h"
#include "core/yarn/yarn.h"

#include <QPalette>
#include <QString>

namespace knittsim::ui {

/// "Nm 12.99", with the decimal point of the user's language.
QString countAsShown(yarn::CountSystem system, double tex);

/// Every number of a yarn with its unit and source, as rich text.
QString yarnDetails(const yarn::Yarn& yarn, const QPalette& palette);

} // namespace knittsim::ui
