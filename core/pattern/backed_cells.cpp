#include "core/pattern/backed_cells.h"

#include "core/pattern/backing.h"
#include "core/pattern/course_works.h"

#include <algorithm>
#include <cmath>

namespace knittsim::pattern {

using machine::Operation;
using machine::OperationKind;

namespace {

/// What is left of a stitch on both beds when the rear stitch belongs to the back.
Stitch withoutRearStitch(Stitch stitch) {
    return stitch == Stitch::Both ? Stitch::Knit : stitch == Stitch::TuckKnit ? Stitch::Tuck : stitch;
}

bool isSameWork(const Work& work, const Operation& op) {
    return work.kind == op.kind && work.needle == op.needle;
}

/// The yarn does in the course what the pass does.
bool isPassOf(const std::vector<Work>& works, std::span<const Operation> pass) {
    return pass.front().direction == machine::Direction::Right
               ? std::equal(works.begin(), works.end(), pass.begin(), pass.end(), isSameWork)
               : std::equal(works.rbegin(), works.rend(), pass.begin(), pass.end(), isSameWork);
}

} // namespace

std::optional<Cell> cellOnTwoBeds(const WaleWork& work, bool backed) {
    const auto is = [&](std::size_t bed, OperationKind kind) { return work[bed] && work[bed]->kind == kind; };
    const auto cell = [&](Stitch stitch, std::size_t bed) {
        return Cell{stitch, static_cast<std::uint8_t>(work[bed]->yarn)};
    };
    using enum OperationKind;
    if (is(0, Knit)) {
        return cell(is(1, Knit) ? Stitch::Both : is(1, Tuck) ? Stitch::KnitTuck : Stitch::Knit, 0);
    }
    if (is(0, Tuck)) {
        return cell(is(1, Knit) ? Stitch::TuckKnit : is(1, Tuck) ? Stitch::TuckBoth : Stitch::Tuck, 0);
    }
    if (is(1, Knit) && !(backed && is(0, Miss))) {
        return cell(Stitch::Purl, 1);
    }
    if (is(1, Tuck)) {
        return cell(Stitch::RearTuck, 1);
    }
    if (is(0, Miss)) {
        return cell(Stitch::Miss, 0);
    }
    return is(1, Miss) ? std::optional(cell(Stitch::RearMiss, 1)) : std::nullopt;
}

void takeBacked(Chart& chart, int course, const std::vector<Cell>& cells,
                const std::vector<std::uint64_t>& rear) {
    const auto width = static_cast<std::size_t>(chart.width);
    for (std::size_t w = 0; w < width; ++w) {
        chart.at(static_cast<int>(w), course) = {withoutRearStitch(cells[w].stitch), cells[w].yarn};
    }
    std::vector<std::uint64_t> back(width);
    for (const int yarn : yarnsOf(chart, course)) {
        for (const int wale : backingOf(chart, course, yarn)) {
            back[static_cast<std::size_t>(wale)] |= std::uint64_t{1} << yarn;
        }
    }
    for (std::size_t w = 0; w < width; ++w) {
        Cell& cell = chart.at(static_cast<int>(w), course);
        if (cell != cells[w] && rear[w] != back[w] && rear[w] == std::uint64_t{1} << cells[w].yarn) {
            cell = cells[w];
        }
    }
}

bool areBackedCourse(Chart& chart, int course, double rack,
                     std::span<const std::span<const Operation>> passes) {
    const auto width = static_cast<std::size_t>(chart.width);
    std::vector<WaleWork> works(width);
    std::vector<std::uint64_t> rear(width);
    for (const auto pass : passes) {
        for (const Operation& op : pass) {
            const auto wale = static_cast<std::size_t>(op.needle.index);
            const std::size_t bed = machine::isFront(op.needle.bed) ? 0 : 1;
            const int yarn = op.carriers[0];
            const bool knitsRear = bed == 1 && op.kind == OperationKind::Knit;
            if (works[wale][bed] && !knitsRear) {
                return false; // only a back has several yarns on one needle
            }
            works[wale][bed] = NeedleWork{op.kind, yarn};
            rear[wale] |= knitsRear ? std::uint64_t{1} << yarn : 0;
        }
    }
    std::vector<Cell> cells(width, Cell{Stitch::Rest, 0});
    for (std::size_t w = 0; w < width; ++w) {
        cells[w] = cellOnTwoBeds(works[w], true).value_or(cells[w]);
    }
    chart.course(course).rack = static_cast<int>(std::floor(rack));
    const HeldLoops held(chart.width);
    for (const ColourMethod colours : {ColourMethod::Birdseye, ColourMethod::LadderBack}) {
        chart.course(course).colours = colours;
        takeBacked(chart, course, cells, rear);
        const std::vector<int> yarns = yarnsOf(chart, course);
        const bool hasBack =
            std::ranges::any_of(yarns, [&](int yarn) { return !backingOf(chart, course, yarn).empty(); });
        const bool fits = std::ranges::all_of(passes, [&](std::span<const Operation> pass) {
            return isPassOf(worksOf(chart, course, pass.front().carriers[0], held), pass);
        });
        if (hasBack && fits && yarns.size() == passes.size() && rackOf(chart, course) == rack) {
            return true;
        }
    }
    return false;
}

} // namespace knittsim::pattern
