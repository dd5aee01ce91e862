#pragma once

#include "core/base/diagnostic.h"

#include <QString>

namespace knittsim::ui {

/// Why something failed, as sentences for a person.
QString reasonText(const Diagnostics& diagnostics);

} // namespace knittsim::ui
