#include "core/fabric/wale_places.h"

#include <cmath>

namespace knittsim::fabric {

namespace {

constexpr double kFacing = 0.2;      ///< pitches: needles of both beds nearer than this face each other
constexpr double kSame = 0.01;       ///< pitches
constexpr double kHalfPitch = 0.5;   ///< that they stand apart then
constexpr double kNarrowHalf = 0.12; ///< half width of the loops then

struct Stand {
    Needle needle;
    double rack = 0;
};

/// Loops of both beds that pass each other and face each other before (`way` -1) or after (+1) stand side by
/// side there: the rear one where it comes from or goes to.
void partFacing(const Fabric& fabric, std::vector<WalePlace>& places, const std::vector<Stand>& stands,
                double way) {
    std::vector<char> parted(places.size(), 0);
    const auto part = [&](std::size_t loop, double by) {
        if (parted[loop] == 0) {
            parted[loop] = 1;
            places[loop].centre += by;
            places[loop].halfWidth = kNarrowHalf;
        }
    };
    for (const Crossing& crossing : fabric.crossings) {
        if (crossing.over < 0 || crossing.under < 0) {
            continue;
        }
        const BondingPoint& over = fabric.points[static_cast<std::size_t>(crossing.over)];
        const BondingPoint& under = fabric.points[static_cast<std::size_t>(crossing.under)];
        const auto front = static_cast<std::size_t>(over.loop);
        const auto rear = static_cast<std::size_t>(under.loop);
        if (over.piece == Piece::Float || under.piece == Piece::Float ||
            !machine::isFront(stands[front].needle.bed) || machine::isFront(stands[rear].needle.bed)) {
            continue;
        }
        const double apart = machine::positionPitches(stands[front].needle, stands[front].rack) -
                             machine::positionPitches(stands[rear].needle, stands[rear].rack);
        if (std::abs(apart) < kSame) {
            part(front, 0.5 * kHalfPitch * way * crossing.sign);
            part(rear, -0.5 * kHalfPitch * way * crossing.sign);
        }
    }
}

std::vector<Stand> standsMade(const Fabric& fabric) {
    std::vector<Stand> stands;
    stands.reserve(fabric.loops.size());
    for (const machine::Loop& loop : fabric.made.loops) {
        stands.push_back({loop.needle, loop.rack});
    }
    return stands;
}

std::vector<Stand> standsBound(const Fabric& fabric) {
    std::vector<Stand> stands;
    stands.reserve(fabric.loops.size());
    for (const Loop& loop : fabric.loops) {
        stands.push_back({loop.bound, loop.boundRack});
    }
    return stands;
}

/// Where each loop would stand by its own pass.
std::vector<WalePlace> placesMade(const Fabric& fabric) {
    const auto& loops = fabric.made.loops;
    std::vector<WalePlace> places(loops.size());
    std::vector<LoopIndex> lastOfYarn;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const machine::Loop& loop = loops[i];
        places[i].centre = machine::positionPitches(loop.needle, loop.rack);
        if (fabric.loops[i].crowded) {
            places[i].halfWidth = kNarrowHalf;
            if (!machine::isFront(loop.needle.bed)) {
                places[i].centre = std::floor(places[i].centre) + kHalfPitch;
            }
        }
        const auto yarn = static_cast<std::size_t>(loop.yarn);
        lastOfYarn.resize(std::max(lastOfYarn.size(), yarn + 1), -1);
        const LoopIndex previous = lastOfYarn[yarn];
        lastOfYarn[yarn] = static_cast<LoopIndex>(i);
        if (previous < 0) {
            continue;
        }
        const auto p = static_cast<std::size_t>(previous);
        const double way = machine::sign(loop.direction) *
                           (places[i].centre - machine::positionPitches(loops[p].needle, loops[p].rack));
        if (loops[p].direction == loop.direction && std::abs(way) < kFacing &&
            machine::isFront(loops[p].needle.bed) != machine::isFront(loop.needle.bed)) {
            const double apart = machine::sign(loop.direction) * 0.5 * (kHalfPitch - way);
            places[p].centre -= apart;
            places[i].centre += apart;
            places[p].halfWidth = places[i].halfWidth = kNarrowHalf;
        }
    }
    partFacing(fabric, places, standsMade(fabric), -1);
    return places;
}

} // namespace

WalePlaces walePlaces(const Fabric& fabric) {
    WalePlaces places{placesMade(fabric), std::vector<WalePlace>(fabric.loops.size())};
    const std::vector<WalePlace>& made = places.made;
    for (std::size_t i = 0; i < made.size(); ++i) {
        const Loop& loop = fabric.loops[i];
        const machine::Loop& own = fabric.made.loops[i];
        const bool stays =
            loop.end != Loop::End::Bound && loop.bound == own.needle && loop.boundRack == own.rack;
        places.bound[i] = {stays ? made[i].centre : machine::positionPitches(loop.bound, loop.boundRack),
                           made[i].halfWidth};
    }
    for (std::size_t i = 0; i < made.size(); ++i) {
        for (const LoopIndex parent : fabric.made.parentsOf(static_cast<LoopIndex>(i))) {
            const auto p = static_cast<std::size_t>(parent);
            if (fabric.loops[p].bound == fabric.made.loops[i].needle) {
                places.bound[p] = made[i];
            }
        }
    }
    partFacing(fabric, places.bound, standsBound(fabric), 1);
    return places;
}

} // namespace knittsim::fabric
