#include "core/pattern/course_works.h"

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
    if (stitch == Stitch::Knit || stitch == Stitch::Both) {
        works.push_back({OperationKind::Knit, {Bed::Front, wale}});
    }
    if (stitch == Stitch::Purl || stitch == Stitch::Both) {
        works.push_back({OperationKind::Knit, {Bed::Rear, wale}});
    }
    if (stitch == Stitch::Tuck) {
        works.push_back({OperationKind::Tuck, {loopBed, wale}});
    }
    if (stitch == Stitch::Miss) {
        works.push_back({OperationKind::Miss, {loopBed, wale}});
    }
}

} // namespace

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
    bool both = false;
    for (int wale = 0; wale < chart.width && !both; ++wale) {
        both = chart.at(wale, course).stitch == Stitch::Both;
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
            addWorks(works, cell.stitch, wale, held.bedOf(wale));
        }
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
