#include "core/geometry/measure.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <vector>

namespace knittsim::geometry {

namespace {

using fabric::Fabric;
using fabric::LoopIndex;

/// Mean of distances, weighted with the number of stitches between.
struct Mean {
    double distance = 0;
    double count = 0;

    void add(double d, double n) {
        distance += d;
        count += n;
    }
    double value() const { return count > 0 ? distance / count : 0; }
};

class Ruler {
public:
    Ruler(const Fabric& fabric, std::span<const float> positions, const Region& region)
        : m_fabric(fabric), m_positions(positions), m_region(region), m_wale(waleNumbers(fabric)) {}

    Measurement measure() {
        Measurement result;
        std::vector<char> wales;
        std::vector<char> courses;
        for (std::size_t i = 0; i < m_fabric.loops.size(); ++i) {
            const auto loop = static_cast<LoopIndex>(i);
            if (!inside(loop)) {
                continue;
            }
            ++result.loops;
            result.loopLengthMm += m_fabric.made.loops[i].lengthMm;
            mark(wales, m_wale[i]);
            mark(courses, course(loop));
        }
        result.loopLengthMm /= std::max(1, result.loops);
        result.wales = static_cast<int>(std::ranges::count(wales, 1));
        result.courses = static_cast<int>(std::ranges::count(courses, 1));
        result.waleSpacingMm = alongCourses().value();
        result.courseSpacingMm = alongWales().value();
        result.widthMm = result.waleSpacingMm * result.wales;
        result.heightMm = result.courseSpacingMm * result.courses;
        return result;
    }

private:
    static void mark(std::vector<char>& seen, int index) {
        const auto i = static_cast<std::size_t>(index);
        if (seen.size() <= i) {
            seen.resize(i + 1, 0);
        }
        seen[i] = 1;
    }

    int course(LoopIndex loop) const { return m_fabric.loops[static_cast<std::size_t>(loop)].course; }
    int wale(LoopIndex loop) const { return m_wale[static_cast<std::size_t>(loop)]; }

    bool inside(LoopIndex loop) const {
        const bool there = m_fabric.loops[static_cast<std::size_t>(loop)].headLeft >= 0; // not run down
        return there && wale(loop) >= m_region.firstWale && wale(loop) <= m_region.lastWale &&
               course(loop) >= m_region.firstCourse && course(loop) <= m_region.lastCourse;
    }

    Vec3 head(LoopIndex loop) const {
        const fabric::Loop& l = m_fabric.loops[static_cast<std::size_t>(loop)];
        return 0.5 * (place(l.headLeft) + place(l.headRight));
    }

    Vec3 place(fabric::PointIndex point) const {
        const auto at = static_cast<std::size_t>(m_fabric.points[static_cast<std::size_t>(point)].entry) * 3;
        return {m_positions[at], m_positions[at + 1], m_positions[at + 2]};
    }

    /// From the first to the last stitch of each yarn course inside the region.
    Mean alongCourses() const {
        Mean mean;
        for (const fabric::YarnCourse& yarnCourse : m_fabric.courses) {
            LoopIndex low = -1;
            LoopIndex high = -1;
            for (fabric::PointIndex p = yarnCourse.first; p < yarnCourse.first + yarnCourse.count; ++p) {
                const LoopIndex loop = m_fabric.points[static_cast<std::size_t>(p)].loop;
                if (inside(loop)) {
                    low = low < 0 || wale(loop) < wale(low) ? loop : low;
                    high = high < 0 || wale(loop) > wale(high) ? loop : high;
                }
            }
            if (low >= 0 && wale(high) > wale(low)) {
                mean.add((head(high) - head(low)).norm(), wale(high) - wale(low));
            }
        }
        return mean;
    }

    /// From each topmost stitch inside the region down through the loops it was drawn through.
    Mean alongWales() const {
        std::vector<char> hasChild(m_fabric.loops.size(), 0);
        for (std::size_t i = 0; i < m_fabric.loops.size(); ++i) {
            const auto parents = m_fabric.made.parentsOf(static_cast<LoopIndex>(i));
            if (inside(static_cast<LoopIndex>(i)) && !parents.empty()) {
                hasChild[static_cast<std::size_t>(parents[0])] = 1;
            }
        }
        Mean mean;
        for (std::size_t i = 0; i < m_fabric.loops.size(); ++i) {
            const auto top = static_cast<LoopIndex>(i);
            if (hasChild[i] != 0 || !inside(top)) {
                continue;
            }
            LoopIndex bottom = top;
            for (auto parents = m_fabric.made.parentsOf(bottom); !parents.empty() && inside(parents[0]);
                 parents = m_fabric.made.parentsOf(bottom)) {
                bottom = parents[0];
            }
            if (course(top) > course(bottom)) {
                mean.add((head(top) - head(bottom)).norm(), course(top) - course(bottom));
            }
        }
        return mean;
    }

    const Fabric& m_fabric;
    std::span<const float> m_positions;
    const Region& m_region;
    std::vector<int> m_wale;
};

} // namespace

std::vector<int> waleNumbers(const Fabric& fabric) {
    std::int32_t low = std::numeric_limits<std::int32_t>::max();
    std::int32_t high = std::numeric_limits<std::int32_t>::min();
    for (const machine::Loop& loop : fabric.made.loops) {
        low = std::min(low, loop.needle.index);
        high = std::max(high, loop.needle.index);
    }
    std::vector<int> number(high >= low ? static_cast<std::size_t>(high - low) + 1 : 0, 0);
    for (const machine::Loop& loop : fabric.made.loops) {
        number[static_cast<std::size_t>(loop.needle.index - low)] = 1;
    }
    int next = 0;
    for (int& wale : number) {
        wale = wale == 1 ? next++ : -1;
    }
    std::vector<int> waleOfLoop;
    waleOfLoop.reserve(fabric.made.loops.size());
    for (const machine::Loop& loop : fabric.made.loops) {
        waleOfLoop.push_back(number[static_cast<std::size_t>(loop.needle.index - low)]);
    }
    return waleOfLoop;
}

Measurement measure(const Fabric& fabric, std::span<const float> positions, const Region& region) {
    return Ruler(fabric, positions, region).measure();
}

} // namespace knittsim::geometry
