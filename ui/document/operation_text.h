#pragma once

#include "core/machine/timeline.h"
#include "ui/document/stitch_grid.h"

#include <QString>

namespace knittsim::document {

/// "front needle 5", "rear slider 3".
QString needleText(machine::Needle needle);

/// "1" or "1 + 4".
QString carrierText(const machine::Program& program, const machine::CarrierSet& carriers);

/// One operation in words, for example "Knit on front needle 5 with carrier 1, to the right".
QString operationText(const machine::Program& program, machine::OperationIndex operation);

/// The same as a sentence that needs no knowledge: "Transfer: the loop on front needle 5 moves to rear
/// needle 5."
QString operationSentence(const machine::Program& program, machine::OperationIndex operation);

/// The same where it is known what the needle holds: a first loop comes through nothing.
QString operationSentence(const machine::Timeline& timeline, machine::OperationIndex operation);

/// One stitch of the grid in words: "Front needle 5, course 12: knit with carrier 1, line 341".
QString stitchText(const machine::Program& program, const machine::LoopTable& loops, const StitchGrid& grid,
                   machine::LoopIndex loop);

/// A racking as the machine people write it: "0", "+1", "−0.75".
QString rackText(double rack);

} // namespace knittsim::document
