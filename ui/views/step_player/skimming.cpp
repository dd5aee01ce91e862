#include "ui/views/step_player/skimming.h"

#include <algorithm>

namespace knittsim::ui {

namespace {

constexpr int kOfLate = 16; ///< operations that are remembered
constexpr int kNew = 2;     ///< so many of one sort are watched,
constexpr int kKnown = 4;   ///< and so many gone through
constexpr double kGoingThrough = 3;

bool sameSort(const machine::Operation& a, const machine::Operation& b) {
    return a.kind == b.kind && a.needle.bed == b.needle.bed;
}

} // namespace

double skimmingHaste(const machine::Program& program, int operation, double speed) {
    const auto& operations = program.operations;
    if (operation < 0 || operation >= static_cast<int>(operations.size())) {
        return 1;
    }
    const auto here = operations.begin() + operation;
    const auto seen = std::count_if(here - std::min(operation, kOfLate), here,
                                    [&](const auto& op) { return sameSort(op, *here); });
    const double most = std::max(1.0, kSkimmingSpeed / speed);
    return seen < kNew ? 1 : seen < kKnown ? std::min(kGoingThrough, most) : most;
}

} // namespace knittsim::ui
