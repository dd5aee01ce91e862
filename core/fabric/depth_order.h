#pragma once

#include "core/fabric/fabric.h"

#include <vector>

namespace knittsim::fabric {

/// A bonding point merges two real crossings: the lower one, where the foot of the new loop meets the leg of
/// the old one, and the upper one, where the leg of the new loop meets the head of the old one.
enum class ClaspLevel : std::uint8_t { Lower, Upper };

/// Fills `row` with the feet and heads of an entry from the back to the front, as they lie at one of its two
/// crossings:
///  - a loop made on the front bed lies behind the heads it is drawn through at the lower crossing and in
///    front of them at the upper one; on the rear bed the other way round;
///  - heads lie in the order of their needle's stack, the first one nearest to its bed;
///  - of several yarns of one operation the leading one lies on the technical face of the loop, at both
///  levels
///    and on every needle, so that plated yarns never cross;
///  - feet of several operations on one side of the heads (after a split) lie in the order of time, the
///    earliest one farthest back.
void orderInDepth(const Fabric& fabric, EntryIndex entry, ClaspLevel level, std::vector<PointIndex>& row);

} // namespace knittsim::fabric
