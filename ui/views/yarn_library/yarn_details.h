#pragma once

#include "core/yarn/yarn.h"

#include <QPalette>
#include <QString>

namespace knittsim::ui {

/// Every number of a yarn with its unit and source, as rich text.
QString yarnDetails(const yarn::Yarn& yarn, const QPalette& palette);

} // namespace knittsim::ui
