#pragma once

#include "core/pattern/chart.h"

#include <string>
#include <vector>

namespace knittsim::pattern {

enum class ModuleGroup : std::uint8_t { Texture, Cable, Lace, TuckAndSlip, Shaping };

/// A piece of stitches with a name, to be stamped into a chart. It says nothing of yarns.
struct Module {
    std::string id;
    std::string name; ///< English, as the books call it
    ModuleGroup group = ModuleGroup::Texture;
    Chart part;
    /// Looks right when laid side by side and above each other.
    bool tiles = true;
};

/// The stitches that charts for one loop a wale can have, in the order of their groups. Each compiles when it
/// is tiled over a chart (those that do not tile: when stamped at its upper edge). Loops move by three
/// needles at most: for more a normal stitch has not yarn enough.
const std::vector<Module>& catalogue();

/// Null for an unknown id.
const Module* findModule(std::string_view id);

} // namespace knittsim::pattern
