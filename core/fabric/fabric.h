#pragma once

#include "core/base/vec3.h"
#include "core/machine/loop.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

/// The topology of a knitted fabric after Meissner & Eberhardt, "The Art of Knitted Fabrics" (1998), sections
/// 3 and 4: yarn courses of bonding points over a shared bonding point table.
namespace knittsim::fabric {

using machine::CarrierIndex;
using machine::Direction;
using machine::LoopIndex;
using machine::Needle;
using machine::OperationIndex;
using EntryIndex = std::int32_t; ///< row of the bonding point table
using PointIndex = std::int32_t; ///< index into Fabric::points

/// Foot: where a loop comes through the loops below it. Head: where the next loop comes through it.
/// Crossing: where two strands pass each other without being drawn through.
enum class Role : std::uint8_t { Foot, Head, Crossing };

enum class Side : std::uint8_t { Left, Right };

/// A piece of yarn that crossings lie on: a leg of a loop, or the float before it.
enum class Piece : std::uint8_t { LeftLeg, RightLeg, Float };

/// A bonding point with its history.
struct BondingPoint {
    EntryIndex entry = -1;         ///< its place in the bonding point table
    LoopIndex loop = -1;           ///< loop it belongs to; on a float: the loop it leads to
    OperationIndex operation = -1; ///< that made the loop or the crossing
    Needle needle;                 ///< where that happened
    Role role = Role::Head;
    Side side = Side::Left; ///< of the loop, seen from the front
    /// Crossing: +1 this strand lies in front (nearer to a viewer of the front bed), -1 behind.
    /// Foot and Head: 0, depth_order.h tells the order.
    std::int8_t front = 0;
    Piece piece = Piece::LeftLeg; ///< Crossing: on which it lies
    std::int32_t crossing = -1;   ///< index into Fabric::crossings, or -1
};

/// Part of a yarn made in one carriage pass (the paper's BPCourse): points [first, first + count).
struct YarnCourse {
    std::int32_t yarn = 0;
    PointIndex first = 0;
    std::int32_t count = 0;
    std::int32_t course = 0; ///< fabric course, 0 at the bottom
    Direction direction = Direction::Right;
};

/// A carrier's yarn from its `in` to its `out`: points [first, first + count).
struct Yarn {
    CarrierIndex carrier = 0;
    PointIndex first = 0;
    std::int32_t count = 0;
    double lengthMm = 0; ///< fed by the machine, sum of Fabric::lengths plus loose ends
};

/// One strand passes another: the bookkeeping of transfers, racks and floats.
/// `over` lies in front (towards a viewer of the front bed).
struct Crossing {
    PointIndex over = -1;
    PointIndex under = -1;
    OperationIndex operation = -1; ///< rack or stitch that made it
    /// +1 when the over strand goes from left to right of the under strand with time, else -1.
    std::int8_t sign = 1;
    float place = 0; ///< along the bed where a float met the other strand, needle pitches
};

/// A loop in the fabric. Points are -1 where a loop has none (no feet: it was hung on an empty needle).
struct Loop {
    PointIndex footLeft = -1;
    PointIndex headLeft = -1;
    PointIndex headRight = -1;
    PointIndex footRight = -1;
    std::int32_t course = 0;
    Needle bound;         ///< needle on which the next loop came through it, or where it is at the end
    double boundRack = 0; ///< racking then
    /// Its place in the stack of that needle: 0 lies nearest to the bed of the needle.
    std::int32_t stackPlace = 0;
    /// Its place among the yarns of its operation: 0 is the leading carrier, whose yarn lies on the technical
    /// face (the side to which the loop is pulled), 1 the next one behind it, and so on.
    std::int32_t plating = 0;
    enum class End : std::uint8_t { Bound, Held, Dropped } end = End::Held;
    bool crowded = false;  ///< it was made between loops of the other bed, a fraction of a pitch aside
    bool onNeedle = false; ///< hangs on a needle at the end; after a split a bound loop may still do so

    std::array<PointIndex, 4> corners() const { return {footLeft, headLeft, headRight, footRight}; }
};

/// Plain value; immutable once built.
struct Fabric {
    std::vector<BondingPoint> points; ///< yarn after yarn, along each yarn
    std::vector<double> lengths;      ///< mm of yarn between point i and i+1; 0 at the last point of a yarn
    std::vector<Yarn> yarns;
    std::vector<YarnCourse> courses;
    std::vector<Crossing> crossings;
    std::vector<Loop> loops;            ///< same index as machine::LoopTable
    machine::LoopTable made;            ///< how each loop was made
    std::int32_t entryCount = 0;        ///< rows of the bonding point table
    std::vector<Vec3> machinePositions; ///< by entry: where the machine leaves it, mm (needle pitch, bed gap)
    std::int32_t courseCount = 0;
    double pitchMm = 0;  ///< needle pitch of the machine
    double courseMm = 0; ///< height of a course in machinePositions

    std::size_t pointCount() const { return points.size(); }

    /// Loops drawn through a loop, from its feet upwards: one for each yarn of the operation that bound it.
    /// Two operations bind a loop when the first one is a split: then it goes on to another needle.
    std::span<const LoopIndex> drawnThrough(LoopIndex loop) const {
        const auto first = static_cast<std::size_t>(firstThrough[static_cast<std::size_t>(loop)]);
        const auto last = static_cast<std::size_t>(firstThrough[static_cast<std::size_t>(loop) + 1]);
        return {through.data() + first, last - first};
    }
    std::vector<LoopIndex> through;
    std::vector<std::int32_t> firstThrough; ///< by loop, into `through`

    /// Points that share an entry, in no particular order: pointsOfEntry[firstOfEntry[e] .. firstOfEntry[e +
    /// 1]).
    std::vector<PointIndex> pointsOfEntry;
    std::vector<std::int32_t> firstOfEntry;

    std::span<const PointIndex> at(EntryIndex entry) const {
        const auto first = static_cast<std::size_t>(firstOfEntry[static_cast<std::size_t>(entry)]);
        const auto last = static_cast<std::size_t>(firstOfEntry[static_cast<std::size_t>(entry) + 1]);
        return {pointsOfEntry.data() + first, last - first};
    }
};

/// Yarn between the four points of a plain loop and to its neighbour, as shares of the loop length
/// (measured on a relaxed rod model of plain knit; sum of one loop and one sinker is 1).
constexpr double kHeadShare = 0.281; ///< between the two heads
constexpr double kLegShare = 0.219;  ///< between foot and head
constexpr double kCourseShare =
    0.19; ///< height of one course; a parked yarn is drawn so far by the take-down
constexpr double kSinkerShare = 0.281; ///< between the feet of neighbouring loops

} // namespace knittsim::fabric
