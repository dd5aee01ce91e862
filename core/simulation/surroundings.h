#pragma once

#include "core/physics/yarn_model/yarn_model.h"
#include "core/simulation/fabric_yarns.h"

#include <cstdint>
#include <span>

namespace knittsim::simulation {

/// What a fabric of yarn lies on or hangs from.
enum class Surroundings : std::uint8_t {
    Flat,    ///< pressed between two soft plates, as far apart as the fabric is thick
    Table,   ///< its weight, on a plane
    Hanging, ///< its weight, from its last course
    Pinned,  ///< the loops at its edges stay where they are
    Free,    ///< nothing at all, and shaken: it may curl, and it has no friction
};

/// Names for files and command lines.
struct SurroundingsInfo {
    Surroundings value;
    const char* id;
    const char* name;    ///< English; the window translates it
    const char* purpose; ///< one English sentence
};
std::span<const SurroundingsInfo> surroundingsKinds(); ///< in the order of the enumeration

/// Both ends of every course, the cast-on and the loops on the stitch holder.
std::vector<physics::Entry> edgeNodes(const fabric::Fabric& fabric, const FabricYarns& yarns);

/// The loops on the stitch holder, or of the last course where none are.
std::vector<physics::Entry> topNodes(const fabric::Fabric& fabric, const FabricYarns& yarns);

/// Adds plates, plane, weight and pins to a model of these yarns at x. `halfGap` between the plates, d.
void surround(physics::YarnModel& model, const fabric::Fabric& fabric, const FabricYarns& yarns,
              const physics::Vector& x, Surroundings surroundings, double halfGap);

} // namespace knittsim::simulation
