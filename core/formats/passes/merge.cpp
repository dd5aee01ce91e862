#include "core/formats/passes/merge.h"

#include <algorithm>
#include <cmath>

namespace knittsim::formats::passes {

using machine::Direction;

namespace {

bool makesLoop(Work work) {
    return work == Work::Knit || work == Work::Tuck;
}

bool isStitch(Work work) {
    return makesLoop(work) || work == Work::Miss;
}

/// `left` then `right` at one slot, going right. Two beds fit only where their needles interleave: the front
/// needle lies left of the rear one.
std::optional<Cell> together(const Cell& left, const Cell& right, bool interleaved) {
    if (left == Cell{}) {
        return right;
    }
    if (right == Cell{}) {
        return left;
    }
    const bool fits = interleaved && isStitch(left.front) && left.rear == Work::None &&
                      isStitch(right.rear) && right.front == Work::None;
    return fits ? std::optional<Cell>({left.front, right.rear}) : std::nullopt;
}

/// The cell after `next` at `slot`, or nothing when it does not fit in.
std::optional<Cell> cellAfter(const Pass& pass, int slot, const Cell& next) {
    const bool interleaved = pass.rack != std::floor(pass.rack);
    if (pass.direction == Direction::Right && slot < pass.lastSlot()) {
        return std::nullopt;
    }
    if (pass.direction == Direction::Left && slot > pass.firstSlot()) {
        return std::nullopt;
    }
    const auto found = pass.cells.find(slot);
    if (found == pass.cells.end()) {
        return next;
    }
    const auto rightwards = together(found->second, next, interleaved);
    const auto leftwards = together(next, found->second, interleaved);
    if (pass.direction) {
        return pass.direction == Direction::Right ? rightwards : leftwards;
    }
    return rightwards ? rightwards : leftwards;
}

/// What a bed does in a pass that does both, or nothing.
std::optional<Work> bedWork(Work a, Work b) {
    if (a == b || b == Work::None) {
        return a;
    }
    if (a == Work::None) {
        return b;
    }
    const bool splits = (a == Work::Knit && b == Work::Split) || (a == Work::Split && b == Work::Knit);
    return splits ? std::optional(Work::Split) : std::nullopt;
}

bool bedsFit(const Pass& pass, const Pass& next) {
    const auto front = bedWork(pass.frontWork, next.frontWork);
    const auto rear = bedWork(pass.rearWork, next.rearWork);
    if (!front || !rear) {
        return false;
    }
    // A bed that receives loops cannot work at the same time.
    return (*front != Work::Split || *rear == Work::None) && (*rear != Work::Split || *front == Work::None);
}

bool presserFits(const Pass& pass, const Pass& next) {
    if (pass.presser != Presser::Unset && next.presser != Presser::Unset && pass.presser != next.presser) {
        return false;
    }
    if (pass.presser != Presser::On) {
        return true;
    }
    // The presser holds down one bed only.
    return !(worksFront(pass) && worksRear(next)) && !(worksRear(pass) && worksFront(next)) &&
           next.hook == Hook::None;
}

/// Yarns come in at the beginning of a pass and go out at its end.
bool endsFit(const Pass& pass, const Pass& next) {
    const bool hookBefore = pass.hook == Hook::In || pass.hook == Hook::Release || pass.hook == Hook::None;
    const bool hookFits =
        (hookBefore && next.hook == Hook::None) || (pass.hook == Hook::None && next.hook == Hook::Out);
    const bool gripperFits = (pass.gripper != Gripper::Out && next.gripper == Gripper::None) ||
                             (pass.gripper == Gripper::None && next.gripper == Gripper::Out);
    return hookFits && gripperFits;
}

bool sizesFit(const Pass& pass, const Pass& next) {
    const auto differ = [](int a, int b) { return a >= 0 && b >= 0 && a != b; };
    return std::none_of(next.sizes.begin(), next.sizes.end(), [&](const auto& entry) {
        const auto found = pass.sizes.find(entry.first);
        return found != pass.sizes.end() && (differ(found->second.front, entry.second.front) ||
                                             differ(found->second.rear, entry.second.rear));
    });
}

bool alike(const Pass& pass, const Pass& next, const PassRules& rules) {
    return pass.kind == next.kind && pass.rack == next.rack && pass.speed == next.speed &&
           pass.direction == next.direction && pass.carriers == next.carriers &&
           pass.fourPasses == next.fourPasses && !pass.returnRack &&
           (!rules.oneStitchNumber || pass.stitch == next.stitch);
}

void merge(Pass& pass, const Pass& next) {
    if (next.presser != Presser::Unset) {
        pass.presser = next.presser;
    }
    if (next.hook != Hook::None) {
        pass.hook = next.hook;
    }
    if (next.gripper != Gripper::None) {
        pass.gripper = next.gripper;
    }
    pass.frontWork = *bedWork(pass.frontWork, next.frontWork);
    pass.rearWork = *bedWork(pass.rearWork, next.rearWork);
    for (const auto& [slot, sizes] : next.sizes) {
        Sizes& mine = pass.sizes[slot];
        mine.front = std::max(mine.front, sizes.front);
        mine.rear = std::max(mine.rear, sizes.rear);
    }
}

} // namespace

bool worksFront(const Pass& pass) {
    return std::any_of(pass.cells.begin(), pass.cells.end(),
                       [](const auto& entry) { return makesLoop(entry.second.front); });
}

bool worksRear(const Pass& pass) {
    return std::any_of(pass.cells.begin(), pass.cells.end(),
                       [](const auto& entry) { return makesLoop(entry.second.rear); });
}

bool append(Pass& pass, const Pass& next, const PassRules& rules) {
    if (next.pause || !alike(pass, next, rules) || !endsFit(pass, next) || !sizesFit(pass, next) ||
        !presserFits(pass, next) || !bedsFit(pass, next)) {
        return false;
    }
    const auto& [slot, cell] = *next.cells.begin();
    const std::optional<Cell> merged = cellAfter(pass, slot, cell);
    if (!merged) {
        return false;
    }
    pass.cells[slot] = *merged;
    merge(pass, next);
    return true;
}

} // namespace knittsim::formats::passes
