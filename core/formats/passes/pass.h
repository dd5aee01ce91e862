#pragma once

#include "core/machine/operation.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace knittsim::formats::passes {

/// What the needle of one bed does.
enum class Work : std::uint8_t { None, Miss, Tuck, Knit, Transfer, Split };

/// The two needles at one slot; the bed that Transfer and Split are written at is the one that gives loops
/// away. Both None is a soft miss: the carriers pass, no needle works.
struct Cell {
    Work front = Work::None;
    Work rear = Work::None;

    bool operator==(const Cell&) const = default;
};

/// Stitch numbers of one slot, -1 where the bed does not work.
struct Sizes {
    int front = -1;
    int rear = -1;
};

enum class PassKind : std::uint8_t { Stitch, Amiss, Split, SliderSplit, Transfer, ToSliders, FromSliders };
enum class Gripper : std::uint8_t { None, In, Out };
enum class Hook : std::uint8_t { None, In, Release, Out };
enum class Presser : std::uint8_t { Unset, Off, On, Auto };

/// One carriage pass as a machine with pass-wise programs makes it. A slot is a front needle number; rear
/// needle B stands at slot B + floor(rack).
struct Pass {
    PassKind kind = PassKind::Stitch;
    std::optional<machine::Direction> direction; ///< nothing: either way (no yarn)
    machine::CarrierSet carriers;
    double rack = 0;                  ///< pitches
    std::optional<double> returnRack; ///< SliderSplit: where the sliders give the loops back
    int stitch = 0;                   ///< stitch number of the pass
    double speed = 0;                 ///< machine's own number
    double roller = 0;                ///< take-down, machine's own number
    bool fourPasses = false;          ///< Transfer: neighbours never in one carriage stroke
    Gripper gripper = Gripper::None;
    Hook hook = Hook::None;
    Presser presser = Presser::Unset;
    bool pause = false; ///< stop before the pass
    std::string message;
    Work frontWork = Work::None; ///< of the whole bed, where knits and tucks do not mix
    Work rearWork = Work::None;
    std::map<int, Cell> cells;  ///< by slot; never empty
    std::map<int, Sizes> sizes; ///< by slot

    int firstSlot() const { return cells.begin()->first; }
    int lastSlot() const { return cells.rbegin()->first; }
};

/// A needle of this bed makes a loop (a miss does not count).
bool worksFront(const Pass& pass);
bool worksRear(const Pass& pass);

} // namespace knittsim::formats::passes
