#include "ui/document/stitch_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knittsim::document {

namespace {

std::size_t at(std::int32_t index) {
    return static_cast<std::size_t>(index);
}

StitchMark makeMark(const machine::Loop& made, const fabric::Loop& loop) {
    StitchMark mark;
    mark.rear = !machine::isFront(made.needle.bed);
    if (made.kind == machine::OperationKind::Tuck) {
        mark.kind = StitchKind::Tuck;
    } else if (made.parentCount == 0) {
        mark.kind = StitchKind::CastOn;
    } else if (made.kind == machine::OperationKind::Split) {
        mark.kind = StitchKind::Split;
    }
    const int moved = columnOf(loop.bound, loop.boundRack) - columnOf(made.needle, made.rack);
    mark.moved = static_cast<std::int8_t>(std::clamp(moved, -127, 127));
    mark.otherBed = machine::isFront(loop.bound.bed) == mark.rear;
    mark.dropped = loop.end == fabric::Loop::End::Dropped;
    mark.parents = static_cast<std::uint8_t>(std::min(made.parentCount, 255));
    return mark;
}

/// Turns counts by course into first indices, with the end at the back.
void accumulate(std::vector<std::int32_t>& counts) {
    std::int32_t sum = 0;
    for (std::int32_t& count : counts) {
        const std::int32_t own = count;
        count = sum;
        sum += own;
    }
}

void addLoop(GridCell& cell, LoopIndex loop, bool rear) {
    LoopIndex& first = rear ? cell.rear : cell.front;
    std::uint8_t& count = rear ? cell.rearCount : cell.frontCount;
    if (first < 0) {
        first = loop;
    }
    if (count < std::numeric_limits<std::uint8_t>::max()) {
        ++count;
    }
}

} // namespace

std::int32_t columnOf(machine::Needle needle, double rack) {
    return static_cast<std::int32_t>(std::ceil(machine::positionPitches(needle, rack) - 0.5));
}

StitchGrid::StitchGrid(const machine::LoopTable& made, const fabric::Fabric& fabric) {
    const std::size_t count = std::min(made.loops.size(), fabric.loops.size());
    m_marks.reserve(count);
    m_places.reserve(count);
    std::int32_t courses = 0;
    std::int32_t low = std::numeric_limits<std::int32_t>::max();
    std::int32_t high = std::numeric_limits<std::int32_t>::min();
    for (std::size_t i = 0; i < count; ++i) {
        const machine::Loop& loop = made.loops[i];
        const std::int32_t column = columnOf(loop.needle, loop.rack);
        const StitchMark mark = makeMark(loop, fabric.loops[i]);
        m_marks.push_back(mark);
        m_places.push_back({std::max(fabric.loops[i].course, 0), column, mark.rear});
        courses = std::max(courses, m_places.back().course + 1);
        low = std::min(low, column);
        high = std::max(high, column);
    }
    m_firstCell.assign(at(courses) + 1, 0);
    m_firstFloat.assign(at(courses) + 1, 0);
    if (count > 0) {
        m_firstColumn = low;
        m_columnCount = high - low + 1;
        fillCells();
        fillFloats(made);
    }
}

void StitchGrid::fillCells() {
    std::vector<LoopIndex> order(m_places.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = static_cast<LoopIndex>(i);
    }
    std::stable_sort(order.begin(), order.end(), [this](LoopIndex a, LoopIndex b) {
        const GridPlace& left = m_places[at(a)];
        const GridPlace& right = m_places[at(b)];
        return left.course != right.course ? left.course < right.course : left.column < right.column;
    });
    m_cells.reserve(order.size());
    const GridPlace* previous = nullptr;
    for (const LoopIndex loop : order) {
        const GridPlace& place = m_places[at(loop)];
        if (!previous || previous->course != place.course || previous->column != place.column) {
            m_cells.push_back({.column = place.column});
            ++m_firstCell[at(place.course)];
        }
        addLoop(m_cells.back(), loop, place.rear);
        previous = &place;
    }
    accumulate(m_firstCell);
    m_usesBothBeds = std::any_of(m_cells.begin(), m_cells.end(),
                                 [](const GridCell& cell) { return cell.front >= 0 && cell.rear >= 0; });
}

void StitchGrid::fillFloats(const machine::LoopTable& made) {
    std::vector<std::pair<std::int32_t, GridFloat>> found;
    std::vector<LoopIndex> last; // by yarn
    for (std::size_t i = 0; i < m_places.size(); ++i) {
        const std::size_t yarn = at(std::max(made.loops[i].yarn, 0));
        if (yarn >= last.size()) {
            last.resize(yarn + 1, -1);
        }
        const LoopIndex before = last[yarn];
        last[yarn] = static_cast<LoopIndex>(i);
        if (before < 0 || m_places[at(before)].course != m_places[i].course) {
            continue;
        }
        const auto [left, right] = std::minmax(m_places[at(before)].column, m_places[i].column);
        if (right - left > 1) {
            found.push_back({m_places[i].course, {left + 1, right - 1, made.loops[i].carrier, before}});
            ++m_firstFloat[at(m_places[i].course)];
        }
    }
    accumulate(m_firstFloat);
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    m_floats.reserve(found.size());
    for (const auto& [course, strand] : found) {
        m_floats.push_back(strand);
    }
}

std::span<const GridCell> StitchGrid::row(std::int32_t course) const {
    if (course < 0 || course >= courseCount()) {
        return {};
    }
    const auto first = at(m_firstCell[at(course)]);
    return {m_cells.data() + first, at(m_firstCell[at(course) + 1]) - first};
}

std::span<const GridFloat> StitchGrid::floats(std::int32_t course) const {
    if (course < 0 || course >= courseCount()) {
        return {};
    }
    const auto first = at(m_firstFloat[at(course)]);
    return {m_floats.data() + first, at(m_firstFloat[at(course) + 1]) - first};
}

const GridCell* StitchGrid::cellAt(std::int32_t course, std::int32_t column) const {
    const std::span<const GridCell> cells = row(course);
    const auto found =
        std::lower_bound(cells.begin(), cells.end(), column,
                         [](const GridCell& cell, std::int32_t key) { return cell.column < key; });
    return found != cells.end() && found->column == column ? &*found : nullptr;
}

const GridFloat* StitchGrid::floatAt(std::int32_t course, std::int32_t column) const {
    for (const GridFloat& strand : floats(course)) {
        if (strand.first <= column && column <= strand.last) {
            return &strand;
        }
    }
    return nullptr;
}

} // namespace knittsim::document
