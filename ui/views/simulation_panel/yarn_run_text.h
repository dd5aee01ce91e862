#pragma once

#include "ui/document/yarn_run.h"

#include <QString>

namespace knittsim::ui {

/// One short line: how far the yarn is, or what has come out.
QString yarnRunText(const document::YarnRun& run);

bool isAtRest(const document::YarnRun& run);   ///< it has ended, and well
bool isBalanced(const document::YarnRun& run); ///< and because its forces are in balance

/// Sizes and audit of a finished run, for a tooltip; else empty.
QString yarnRunDetails(const document::YarnRun& run);

/// What the button does now, and what it is for.
QString settleYarnText(const document::YarnRun& run);
QString settleYarnHelp();

/// English names of the surroundings in the language of the window.
QString surroundingsName(const simulation::SurroundingsInfo& info);
QString surroundingsPurpose(const simulation::SurroundingsInfo& info);

} // namespace knittsim::ui
