#include "core/fabric/reduction.h"

#include "core/fabric/entry_index.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace knittsim::fabric {

namespace {

/// Which loops are gone, and how much yarn each of the others takes over.
struct Removal {
    std::vector<char> gone;     ///< by loop
    std::vector<double> gained; ///< by loop, mm
    std::vector<double> given;  ///< by loop: own yarn that went to neighbours, mm
};

double ownYarn(const machine::Loop& loop) {
    return loop.lengthMm * (1 - kSinkerShare);
}

/// Shares the yarn of a run of removed loops that follow each other along one yarn between the loops before
/// and after, as far as these lie in the same course.
void shareOut(const Fabric& fabric, std::span<const LoopIndex> run, LoopIndex before, LoopIndex after,
              Removal& removal) {
    for (const LoopIndex loop : run) {
        const auto courseOf = [&](LoopIndex l) { return fabric.loops[static_cast<std::size_t>(l)].course; };
        const bool left = before >= 0 && courseOf(before) == courseOf(loop);
        const bool right = after >= 0 && courseOf(after) == courseOf(loop);
        const double yarn = ownYarn(fabric.made.loops[static_cast<std::size_t>(loop)]);
        const double share = left && right ? yarn / 2 : yarn;
        if (left) {
            removal.gained[static_cast<std::size_t>(before)] += share;
        }
        if (right) {
            removal.gained[static_cast<std::size_t>(after)] += share;
        }
        removal.given[static_cast<std::size_t>(loop)] = left || right ? yarn : 0;
    }
}

Removal planRemoval(const Fabric& fabric, const Runs& runs, std::size_t steps) {
    Removal removal{std::vector<char>(fabric.loops.size(), 0), std::vector<double>(fabric.loops.size(), 0),
                    std::vector<double>(fabric.loops.size(), 0)};
    for (std::size_t s = 0; s < std::min(steps, runs.steps.size()); ++s) {
        for (const LoopIndex loop : runs.steps[s]) {
            removal.gone[static_cast<std::size_t>(loop)] = 1;
        }
    }
    std::vector<LoopIndex> lastKept;
    std::vector<std::vector<LoopIndex>> open; // removed loops since then, by yarn
    for (std::size_t i = 0; i < fabric.made.loops.size(); ++i) {
        const auto yarn = static_cast<std::size_t>(fabric.made.loops[i].yarn);
        if (yarn >= lastKept.size()) {
            lastKept.resize(yarn + 1, -1);
            open.resize(yarn + 1);
        }
        if (removal.gone[i] != 0) {
            open[yarn].push_back(static_cast<LoopIndex>(i));
            continue;
        }
        shareOut(fabric, open[yarn], lastKept[yarn], static_cast<LoopIndex>(i), removal);
        open[yarn].clear();
        lastKept[yarn] = static_cast<LoopIndex>(i);
    }
    for (std::size_t yarn = 0; yarn < open.size(); ++yarn) {
        shareOut(fabric, open[yarn], lastKept[yarn], -1, removal);
    }
    return removal;
}

class Remover {
public:
    Remover(const Fabric& before, const Removal& removal) : m_before(before), m_removal(removal) {}

    ReducedFabric run() {
        Fabric& after = m_result.fabric;
        after.loops = m_before.loops;
        after.made = m_before.made;
        after.courseCount = m_before.courseCount;
        after.pitchMm = m_before.pitchMm;
        after.through = m_before.through;
        after.firstThrough = m_before.firstThrough;
        m_newPoint.assign(m_before.points.size(), -1);
        m_newEntry.assign(static_cast<std::size_t>(m_before.entryCount), -1);
        for (const Yarn& yarn : m_before.yarns) {
            copyYarn(yarn);
        }
        after.entryCount = static_cast<std::int32_t>(m_result.entryBefore.size());
        for (const EntryIndex entry : m_result.entryBefore) {
            after.machinePositions.push_back(m_before.machinePositions[static_cast<std::size_t>(entry)]);
        }
        copyCourses();
        copyCrossings();
        for (Loop& loop : after.loops) {
            for (PointIndex* point : {&loop.footLeft, &loop.headLeft, &loop.headRight, &loop.footRight}) {
                *point = *point < 0 ? -1 : m_newPoint[static_cast<std::size_t>(*point)];
            }
        }
        indexEntries(after);
        return std::move(m_result);
    }

private:
    bool gone(PointIndex point) const {
        const BondingPoint& p = m_before.points[static_cast<std::size_t>(point)];
        const bool onRung = p.role == Role::Crossing && p.piece == Piece::Float;
        return !onRung && m_removal.gone[static_cast<std::size_t>(p.loop)] != 0;
    }

    bool kept(PointIndex point) const {
        const BondingPoint& p = m_before.points[static_cast<std::size_t>(point)];
        if (p.role != Role::Crossing) {
            return !gone(point);
        }
        const Crossing& crossing = m_before.crossings[static_cast<std::size_t>(p.crossing)];
        return !gone(crossing.over) && !gone(crossing.under);
    }

    void copyYarn(const Yarn& yarn) {
        Fabric& after = m_result.fabric;
        Yarn copy = yarn;
        copy.first = static_cast<PointIndex>(after.points.size());
        double pending = 0;
        LoopIndex taken = -1;
        for (PointIndex p = yarn.first; p < yarn.first + yarn.count; ++p) {
            const auto i = static_cast<std::size_t>(p);
            const LoopIndex loop = m_before.points[i].loop;
            if (kept(p)) {
                if (static_cast<PointIndex>(after.points.size()) > copy.first) {
                    after.lengths.back() = std::max(0.0, pending);
                }
                pending = 0;
                addPoint(p);
            } else if (gone(p) && loop != taken) {
                taken = loop;
                pending -= m_removal.given[static_cast<std::size_t>(loop)];
            }
            pending += m_before.lengths[i] * stretch(p);
        }
        copy.count = static_cast<std::int32_t>(after.points.size()) - copy.first;
        if (copy.count > 0) {
            after.lengths.back() = 0;
        }
        after.yarns.push_back(copy);
    }

    /// How much longer the yarn from this point to the next becomes: a loop takes what it gains over its
    /// whole round.
    double stretch(PointIndex point) const {
        const auto loop = static_cast<std::size_t>(m_before.points[static_cast<std::size_t>(point)].loop);
        const auto [first, last] = roundOf(m_before.loops[loop]);
        if (m_removal.gained[loop] <= 0 || point < first || point >= last) {
            return 1;
        }
        const auto lengths = m_before.lengths.begin();
        return 1 + m_removal.gained[loop] / std::accumulate(lengths + first, lengths + last, 0.0);
    }

    /// First and last point of a loop along its yarn.
    static std::pair<PointIndex, PointIndex> roundOf(const Loop& loop) {
        return loop.footLeft >= 0 ? std::minmax({loop.footLeft, loop.footRight})
                                  : std::minmax({loop.headLeft, loop.headRight});
    }

    void addPoint(PointIndex point) {
        Fabric& after = m_result.fabric;
        BondingPoint copy = m_before.points[static_cast<std::size_t>(point)];
        EntryIndex& entry = m_newEntry[static_cast<std::size_t>(copy.entry)];
        if (entry < 0) {
            entry = static_cast<EntryIndex>(m_result.entryBefore.size());
            m_result.entryBefore.push_back(copy.entry);
        }
        copy.entry = entry;
        m_newPoint[static_cast<std::size_t>(point)] = static_cast<PointIndex>(after.points.size());
        after.points.push_back(copy);
        after.lengths.push_back(0);
    }

    void copyCourses() {
        for (const YarnCourse& course : m_before.courses) {
            YarnCourse copy = course;
            copy.count = 0;
            for (PointIndex p = course.first; p < course.first + course.count; ++p) {
                const PointIndex now = m_newPoint[static_cast<std::size_t>(p)];
                if (now >= 0) {
                    copy.first = copy.count == 0 ? now : copy.first;
                    ++copy.count;
                }
            }
            if (copy.count > 0) {
                m_result.fabric.courses.push_back(copy);
            }
        }
    }

    void copyCrossings() {
        Fabric& after = m_result.fabric;
        for (const Crossing& crossing : m_before.crossings) {
            const PointIndex over = m_newPoint[static_cast<std::size_t>(crossing.over)];
            const PointIndex under = m_newPoint[static_cast<std::size_t>(crossing.under)];
            if (over < 0) {
                continue;
            }
            const auto number = static_cast<std::int32_t>(after.crossings.size());
            after.points[static_cast<std::size_t>(over)].crossing = number;
            after.points[static_cast<std::size_t>(under)].crossing = number;
            after.crossings.push_back({over, under, crossing.operation, crossing.sign});
        }
    }

    const Fabric& m_before;
    const Removal& m_removal;
    ReducedFabric m_result;
    std::vector<PointIndex> m_newPoint;
    std::vector<EntryIndex> m_newEntry;
};

} // namespace

std::size_t Runs::loopCount() const {
    std::size_t count = 0;
    for (const auto& step : steps) {
        count += step.size();
    }
    return count;
}

Runs findRuns(const Fabric& fabric, const ReductionOptions& options) {
    const auto isThere = [&](std::size_t loop) { return fabric.loops[loop].headLeft >= 0; };
    std::vector<std::int32_t> holders(fabric.loops.size(), 0); // loops drawn through it that are still there
    for (std::size_t i = 0; i < fabric.loops.size(); ++i) {
        if (!isThere(i)) {
            continue;
        }
        for (const LoopIndex parent : fabric.made.parentsOf(static_cast<LoopIndex>(i))) {
            ++holders[static_cast<std::size_t>(parent)];
        }
        holders[i] += options.stitchHolder && fabric.loops[i].onNeedle ? 1 : 0;
    }
    Runs runs;
    std::vector<LoopIndex> step;
    for (std::size_t i = 0; i < holders.size(); ++i) {
        if (holders[i] == 0 && isThere(i)) {
            step.push_back(static_cast<LoopIndex>(i));
        }
    }
    while (!step.empty()) {
        std::vector<LoopIndex> next;
        for (const LoopIndex loop : step) {
            for (const LoopIndex parent : fabric.made.parentsOf(loop)) {
                if (--holders[static_cast<std::size_t>(parent)] == 0) {
                    next.push_back(parent);
                }
            }
        }
        runs.steps.push_back(std::move(step));
        step = std::move(next);
    }
    return runs;
}

ReducedFabric removeRuns(const Fabric& fabric, const Runs& runs, int steps) {
    const std::size_t wanted = steps < 0 ? runs.steps.size() : static_cast<std::size_t>(steps);
    return Remover(fabric, planRemoval(fabric, runs, wanted)).run();
}

std::vector<EntryIndex> pairEntries(const ReducedFabric& more, const ReducedFabric& less) {
    std::vector<EntryIndex> pairs;
    pairs.reserve(more.entryBefore.size());
    std::unordered_map<EntryIndex, EntryIndex> known;
    for (std::size_t e = 0; e < less.entryBefore.size(); ++e) {
        known.emplace(less.entryBefore[e], static_cast<EntryIndex>(e));
    }
    for (const EntryIndex before : more.entryBefore) {
        pairs.push_back(known.at(before));
    }
    return pairs;
}

std::vector<float> pickPositions(std::span<const EntryIndex> entries, std::span<const float> positions) {
    std::vector<float> picked;
    picked.reserve(entries.size() * 3);
    for (const EntryIndex entry : entries) {
        const auto place = positions.subspan(3 * static_cast<std::size_t>(entry), 3);
        picked.insert(picked.end(), place.begin(), place.end());
    }
    return picked;
}

} // namespace knittsim::fabric
