#include "core/fabric/needle_hooks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>

namespace knittsim::fabric {

namespace {

/// Beds and their distances in the width of a wale.
constexpr double kAbove = 0.7;      ///< hooks above the highest loop that hangs from them
constexpr double kHalfGap = 0.8;    ///< from the middle to the hooks of a bed
constexpr double kHalfHead = 0.22;  ///< half the width of a loop in its hook
constexpr double kShaft = 2.2;      ///< visible part of a needle
constexpr double kLeastWidth = 0.2; ///< a wale is at least so wide, in pitches of the machine
constexpr double kStretched = 1;    ///< the fabric ends so far below its hooks at most

std::vector<std::size_t> headsOf(const Fabric& fabric, const HeldStack& stack) {
    std::vector<std::size_t> entries;
    for (const machine::LoopIndex index : stack.loops) {
        const Loop& loop = fabric.loops[static_cast<std::size_t>(index)];
        for (const PointIndex head : {loop.headLeft, loop.headRight}) {
            entries.push_back(static_cast<std::size_t>(fabric.points[static_cast<std::size_t>(head)].entry));
        }
    }
    return entries;
}

/// Straight line from needle positions to places in the fabric, by least squares.
struct Scale {
    double middlePitches = 0;
    double middleMm = 0;
    double width = 1; ///< mm of a wale

    double at(double pitches) const { return middleMm + width * (pitches - middlePitches); }
};

Scale scaleOf(const Fabric& fabric, const std::vector<HeldStack>& stacks,
              const std::vector<float>& positions) {
    Scale scale;
    std::vector<std::pair<double, double>> places;
    for (const HeldStack& stack : stacks) {
        const auto heads = headsOf(fabric, stack);
        double sum = 0;
        for (const std::size_t entry : heads) {
            sum += static_cast<double>(positions[3 * entry]);
        }
        // Where the loop belongs, not where racking has moved it.
        places.emplace_back(stack.needle.index, sum / static_cast<double>(heads.size()));
    }
    const auto count = static_cast<double>(places.size());
    for (const auto& [pitches, mm] : places) {
        scale.middlePitches += pitches / count;
        scale.middleMm += mm / count;
    }
    double product = 0;
    double square = 0;
    for (const auto& [pitches, mm] : places) {
        product += (pitches - scale.middlePitches) * (mm - scale.middleMm);
        square += std::pow(pitches - scale.middlePitches, 2);
    }
    scale.width = std::max(square > 0 ? product / square : fabric.pitchMm, kLeastWidth * fabric.pitchMm);
    return scale;
}

/// How far the fabric is lifted at places across it, so that it comes near its needles where it ends lower
/// than elsewhere. Nowhere farther than one wale beside allows, as layers hang side by side.
class Lift {
public:
    Lift(const Fabric& fabric, const std::vector<HeldStack>& stacks, double width, double top,
         const std::vector<float>& positions)
        : m_step(0.5 * width) {
        std::vector<std::pair<double, double>> wanted;
        for (const HeldStack& stack : stacks) {
            for (const std::size_t entry : headsOf(fabric, stack)) {
                const double low = top - static_cast<double>(positions[3 * entry + 1]);
                wanted.emplace_back(static_cast<double>(positions[3 * entry]),
                                    std::max(0.0, low - kStretched * width));
            }
        }
        const auto [left, right] = std::ranges::minmax(wanted | std::views::keys);
        m_left = left;
        m_any = std::ranges::any_of(wanted | std::views::values, [](double lift) { return lift > 0; });
        constexpr std::size_t kReach = 1; // cells: half a wale
        m_cells.assign(static_cast<std::size_t>((right - left) / m_step) + 2, kUnknown);
        for (const auto& [x, lift] : wanted) {
            const auto cell = static_cast<std::size_t>((x - left) / m_step);
            const std::size_t end = std::min(m_cells.size(), cell + kReach + 1);
            for (std::size_t i = cell - std::min(cell, kReach); i < end; ++i) {
                m_cells[i] = std::min(m_cells[i], lift);
            }
        }
        for (std::size_t i = 1; i < m_cells.size(); ++i) {
            m_cells[i] = m_cells[i] == kUnknown ? m_cells[i - 1] : m_cells[i];
        }
    }

    bool any() const { return m_any; }

    double at(double x) const {
        const auto last = static_cast<double>(m_cells.size() - 1);
        const double place = std::clamp((x - m_left) / m_step, 0.0, last);
        const auto cell = std::min(static_cast<std::size_t>(place), m_cells.size() - 2);
        return std::lerp(m_cells[cell], m_cells[cell + 1], place - static_cast<double>(cell));
    }

private:
    static constexpr double kUnknown = std::numeric_limits<double>::max();

    double m_step;
    double m_left = 0;
    bool m_any = false;
    std::vector<double> m_cells; ///< from m_left, m_step apart
};

} // namespace

std::vector<HeldStack> heldStacks(const machine::MachineState& state) {
    std::vector<HeldStack> stacks;
    for (int bed = 0; bed < machine::kBedCount; ++bed) {
        const machine::NeedleRow& row = state.beds[static_cast<std::size_t>(bed)];
        for (std::int32_t index = row.first(); index < row.end(); ++index) {
            const auto loops = row.at(index);
            if (!loops.empty()) {
                const machine::Needle needle{static_cast<machine::Bed>(bed), index};
                stacks.push_back({needle, positionPitches(needle, state.rack), {loops.begin(), loops.end()}});
            }
        }
    }
    return stacks;
}

std::vector<NeedleHook> hangOnNeedles(const Fabric& fabric, const std::vector<HeldStack>& stacks,
                                      const machine::Operation* working, std::vector<float>& positions) {
    if (stacks.empty()) {
        return {};
    }
    const Scale scale = scaleOf(fabric, stacks, positions);
    double top = -1e30;
    double depth = 0;
    std::size_t count = 0;
    for (const HeldStack& stack : stacks) {
        for (const std::size_t entry : headsOf(fabric, stack)) {
            top = std::max(top, static_cast<double>(positions[3 * entry + 1]));
            depth += static_cast<double>(positions[3 * entry + 2]);
            ++count;
        }
    }
    depth /= static_cast<double>(count);
    if (const Lift lift(fabric, stacks, scale.width, top, positions); lift.any()) {
        for (std::size_t entry = 0; 3 * entry < positions.size(); ++entry) {
            positions[3 * entry + 1] +=
                static_cast<float>(lift.at(static_cast<double>(positions[3 * entry])));
        }
    }
    std::vector<NeedleHook> hooks;
    for (const HeldStack& stack : stacks) {
        const double side = machine::isFront(stack.needle.bed) ? 1 : -1;
        const Vec3 place(scale.at(stack.pitches), top + kAbove * scale.width,
                         depth + side * kHalfGap * scale.width);
        bool left = true;
        for (const std::size_t entry : headsOf(fabric, stack)) {
            const Vec3f head = (place + Vec3((left ? -1 : 1) * kHalfHead * scale.width, 0, 0)).cast<float>();
            std::copy_n(head.data(), 3, positions.begin() + static_cast<std::ptrdiff_t>(3 * entry));
            left = !left;
        }
        const bool transfers = working && (working->kind == machine::OperationKind::Xfer ||
                                           working->kind == machine::OperationKind::Split);
        hooks.push_back(
            {stack.needle, place.cast<float>(),
             (kShaft * scale.width * Vec3(0, 0.8, 0.6 * side)).cast<float>(),
             working && (stack.needle == working->needle || (transfers && stack.needle == working->target))});
    }
    return hooks;
}

} // namespace knittsim::fabric
