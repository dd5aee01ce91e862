#include "core/pattern/course_works.h"

#include "core/pattern/backing.h"

#include <algorithm>

namespace knittsim::pattern {

using machine::Bed;
using machine::Direction;
using machine::Needle;
using machine::OperationKind;

namespace {

bool isWorkOf(Cell cell, int yarn) {
    return isWorked(cell.stitch) && cell.yarn == yarn;
}

void addWorks(std::vector<Work>& works, Stitch stitch, int wale, Bed loopBed) {
    for (const Bed bed : {Bed::Front, Bed::Rear}) {
        if (const auto kind = workOn(bed, stitch, loopBed)) {
            works.push_back({*kind, {bed, wale}});
        }
    }
}

} // namespace

std::optional<OperationKind> workOn(Bed bed, Stitch stitch, Bed loopBed) {
    const bool front = bed == Bed::Front;
    const auto here = [](bool is, OperationKind kind) { return is ? std::optional(kind) : std::nullopt; };
    switch (stitch) {
    case Stitch::Knit:
        return here(front, OperationKind::Knit);
    case Stitch::Purl:
        return here(!front, OperationKind::Knit);
    case Stitch::Both:
        return OperationKind::Knit;
    case Stitch::KnitTuck:
        return front ? OperationKind::Knit : OperationKind::Tuck;
    case Stitch::TuckKnit:
        return front ? OperationKind::Tuck : OperationKind::Knit;
    case Stitch::TuckBoth:
        return OperationKind::Tuck;
    case Stitch::Tuck:
        return here(bed == loopBed, OperationKind::Tuck);
    case Stitch::Miss:
        return here(bed == loopBed, OperationKind::Miss);
    case Stitch::RearTuck:
        return here(!front, OperationKind::Tuck);
    case Stitch::RearMiss:
        return here(!front, OperationKind::Miss);
    case Stitch::Rest:
    case Stitch::Empty:
    case Stitch::Drop:
        break;
    }
    return std::nullopt;
}

Bed loopBedOf(const Chart& chart, const HeldLoops& held, int wale) {
    return chart.beds == BedUse::Double ? Bed::Front : held.bedOf(wale);
}

std::vector<Work> worksOf(const Cell& cell, int wale, Bed loopBed) {
    std::vector<Work> works;
    addWorks(works, cell.stitch, wale, loopBed);
    return works;
}

std::vector<int> yarnsOf(const Chart& chart, int course) {
    std::vector<bool> used(chart.yarns.size(), false);
    for (int wale = 0; wale < chart.width; ++wale) {
        const Cell cell = chart.at(wale, course);
        if (isWorked(cell.stitch)) {
            used[cell.yarn] = true;
        }
    }
    std::vector<int> yarns;
    for (std::size_t y = 0; y < used.size(); ++y) {
        if (used[y]) {
            yarns.push_back(static_cast<int>(y));
        }
    }
    return yarns;
}

bool worksBothBeds(const Chart& chart, int course) {
    bool both = isBacked(chart.course(course).colours);
    for (int wale = 0; wale < chart.width && !both; ++wale) {
        both = isOnBothBeds(chart.at(wale, course).stitch);
    }
    return both;
}

double rackOf(const Chart& chart, int course) {
    return chart.course(course).rack + (worksBothBeds(chart, course) ? 0.25 : 0.0);
}

std::vector<Work> worksOf(const Chart& chart, int course, int yarn, const HeldLoops& held) {
    std::vector<Work> works;
    for (int wale = 0; wale < chart.width; ++wale) {
        if (const Cell cell = chart.at(wale, course); isWorkOf(cell, yarn)) {
            addWorks(works, cell.stitch, wale, loopBedOf(chart, held, wale));
        }
    }
    for (const int wale : backingOf(chart, course, yarn)) {
        works.push_back({OperationKind::Knit, {Bed::Rear, wale}});
    }
    const double rack = rackOf(chart, course);
    std::ranges::stable_sort(works, {}, [&](const Work& work) { return positionPitches(work.needle, rack); });
    return works;
}

void addJoin(std::vector<Work>& works, const Chart& chart, int course, Direction direction,
             const HeldLoops& held) {
    const bool right = direction == Direction::Right;
    const int next = (right ? works.back() : works.front()).needle.index + sign(direction);
    if (next < 0 || next >= chart.width || !isWorked(chart.at(next, course).stitch) || !held.any(next)) {
        return;
    }
    works.insert(right ? works.end() : works.begin(), {OperationKind::Tuck, Needle{held.bedOf(next), next}});
}

int firstWaleOf(const Chart& chart, int course, int yarn) {
    int wale = 0;
    while (!isWorkOf(chart.at(wale, course), yarn)) {
        ++wale;
    }
    return wale;
}

} // namespace knittsim::pattern
