#pragma once

#include "ui/document/document.h"

#include <QString>

namespace knittsim::ui {

/// "24 loops would run", "5 of 24 loops have run", ...; empty when all loops hold and none has run.
QString ladderText(const document::Document& document);

/// Why removing ladders had nothing to do.
QString nothingRunsText(const document::Document& document);

/// What removing ladders does, for tooltips.
QString removeLaddersHelp();
QString stitchHolderHelp();

} // namespace knittsim::ui
