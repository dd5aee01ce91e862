#pragma once

#include "core/base/diagnostic.h"
#include "core/machine/timeline.h"

#include <map>

namespace knittsim::document {

/// The worst error or warning at each stitch that has one; notes are left out. What an operation without
/// stitch did wrong (a transfer) belongs to the latest stitch of its needle before it, if that is not long
/// ago.
using ProblemMarks = std::map<machine::LoopIndex, Diagnostic>;

ProblemMarks problemMarks(const machine::Timeline& timeline, const Diagnostics& problems);

} // namespace knittsim::document
