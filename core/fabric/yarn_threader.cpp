#include "core/fabric/yarn_threader.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <ranges>

namespace knittsim::fabric {

namespace {

class Threader {
public:
    Threader(Fabric& fabric, const CourseNumbers& numbers, const LegCrossings& crossings, EntryTable& entries)
        : m_fabric(fabric), m_numbers(numbers), m_crossings(crossings), m_entries(entries) {
        fabric.points.reserve(fabric.loops.size() * 4 + crossings.all().size() * 2);
        fabric.lengths.reserve(fabric.points.capacity());
        fabric.crossings.resize(crossings.all().size());
        for (std::size_t i = 0; i < crossings.all().size(); ++i) {
            fabric.crossings[i].operation = crossings.all()[i].operation;
            fabric.crossings[i].sign = crossings.all()[i].sign;
            fabric.crossings[i].place = crossings.all()[i].place;
        }
        m_rowOfCrossing.assign(crossings.all().size(), -1);
    }

    void run() {
        std::vector<std::vector<LoopIndex>> loopsOfYarn;
        for (std::size_t i = 0; i < m_fabric.made.loops.size(); ++i) {
            const auto yarn = static_cast<std::size_t>(m_fabric.made.loops[i].yarn);
            if (loopsOfYarn.size() <= yarn) {
                loopsOfYarn.resize(yarn + 1);
            }
            loopsOfYarn[yarn].push_back(static_cast<LoopIndex>(i));
        }
        for (const std::vector<LoopIndex>& loops : loopsOfYarn) {
            if (!loops.empty()) {
                threadYarn(loops);
            }
        }
        m_fabric.entryCount = m_entries.rowCount();
    }

private:
    const machine::Loop& made(LoopIndex loop) const {
        return m_fabric.made.loops[static_cast<std::size_t>(loop)];
    }

    void threadYarn(const std::vector<LoopIndex>& loops) {
        Yarn yarn{.carrier = made(loops[0]).carrier,
                  .first = static_cast<PointIndex>(m_fabric.points.size())};
        m_yarnFirst = yarn.first;
        m_pending = 0;
        m_loose = 0;
        m_previous = -1;
        m_pass = -1;
        const auto yarnIndex = static_cast<std::int32_t>(m_fabric.yarns.size());
        for (const LoopIndex loop : loops) {
            startCourse(loop, yarnIndex);
            threadLoop(loop);
            m_fabric.courses.back().count =
                static_cast<std::int32_t>(m_fabric.points.size()) - m_fabric.courses.back().first;
        }
        yarn.count = static_cast<std::int32_t>(m_fabric.points.size()) - yarn.first;
        const auto first = m_fabric.lengths.begin() + yarn.first;
        yarn.lengthMm = m_loose + m_pending;
        yarn.lengthMm = std::accumulate(first, m_fabric.lengths.end(), yarn.lengthMm);
        m_fabric.yarns.push_back(yarn);
    }

    void startCourse(LoopIndex loop, std::int32_t yarn) {
        const std::int32_t pass = m_numbers.passOfOperation[static_cast<std::size_t>(made(loop).operation)];
        if (pass == m_pass) {
            return;
        }
        m_pass = pass;
        m_fabric.courses.push_back({.yarn = yarn,
                                    .first = static_cast<PointIndex>(m_fabric.points.size()),
                                    .count = 0,
                                    .course = m_numbers.courseOfPass[static_cast<std::size_t>(pass)],
                                    .direction = made(loop).direction});
    }

    void threadLoop(LoopIndex index) {
        const machine::Loop& loop = made(index);
        const double floatLength = m_previous < 0 ? 0 : yarnBetween(m_previous, index);
        const double leg = kLegShare * loop.lengthMm;
        const bool rightward = loop.direction == Direction::Right;
        const Side in = rightward ? Side::Left : Side::Right;
        const Side out = rightward ? Side::Right : Side::Left;

        addPiece(index, Piece::Float, floatLength, false);
        m_previous = index;
        addFoot(index, in);
        addPiece(index, in == Side::Left ? Piece::LeftLeg : Piece::RightLeg, leg, false);
        addHead(index, in);
        m_pending += kHeadShare * loop.lengthMm;
        addHead(index, out);
        addPiece(index, out == Side::Left ? Piece::LeftLeg : Piece::RightLeg, leg, true);
        addFoot(index, out);
    }

    /// Sinker or float from one loop of a yarn to the next: the way along and between the beds, and courses
    /// passed while the carrier stood.
    double yarnBetween(LoopIndex from, LoopIndex to) const {
        const machine::Loop& loop = made(to);
        const auto courseOf = [&](LoopIndex l) { return m_fabric.loops[static_cast<std::size_t>(l)].course; };
        const int courses = std::abs(courseOf(to) - courseOf(from));
        return kSinkerShare * loop.lengthMm + loop.floatMm +
               std::max(0, courses - 1) * kCourseShare * loop.lengthMm;
    }

    /// A float or leg: its crossings at equal distances. `downwards`: the yarn runs against the order of
    /// time.
    void addPiece(LoopIndex loop, Piece piece, double length, bool downwards) {
        const auto crossings = m_crossings.on(loop, piece);
        const double share = length / static_cast<double>(crossings.size() + 1);
        for (std::size_t i = 0; i < crossings.size(); ++i) {
            m_pending += share;
            addCrossing(loop, piece, crossings[downwards ? crossings.size() - 1 - i : i]);
        }
        m_pending += share;
    }

    void addCrossing(LoopIndex loop, Piece piece, std::int32_t number) {
        const auto i = static_cast<std::size_t>(number);
        const LegCrossings::Crossing& crossing = m_crossings.all()[i];
        const bool over = crossing.over == LegCrossings::number(loop, piece);
        if (m_rowOfCrossing[i] < 0) {
            m_rowOfCrossing[i] = m_entries.newRow();
        }
        const PointIndex point = addPoint({.entry = m_rowOfCrossing[i],
                                           .loop = loop,
                                           .operation = crossing.operation,
                                           .needle = made(loop).needle,
                                           .role = Role::Crossing,
                                           .side = piece == Piece::RightLeg ? Side::Right : Side::Left,
                                           .front = static_cast<std::int8_t>(over ? 1 : -1),
                                           .piece = piece,
                                           .crossing = number});
        (over ? m_fabric.crossings[i].over : m_fabric.crossings[i].under) = point;
    }

    void addFoot(LoopIndex loop, Side side) {
        const auto parents = m_fabric.made.parentsOf(loop);
        if (parents.empty()) {
            return;
        }
        Loop& own = m_fabric.loops[static_cast<std::size_t>(loop)];
        (side == Side::Left ? own.footLeft : own.footRight) =
            addPoint(point(loop, side, Role::Foot, m_entries.rowOf(EntryTable::head(parents[0], side))));
    }

    void addHead(LoopIndex loop, Side side) {
        Loop& own = m_fabric.loops[static_cast<std::size_t>(loop)];
        (side == Side::Left ? own.headLeft : own.headRight) =
            addPoint(point(loop, side, Role::Head, m_entries.rowOf(EntryTable::head(loop, side))));
    }

    BondingPoint point(LoopIndex loop, Side side, Role role, EntryIndex entry) const {
        return {.entry = entry,
                .loop = loop,
                .operation = made(loop).operation,
                .needle = made(loop).needle,
                .role = role,
                .side = side};
    }

    PointIndex addPoint(const BondingPoint& point) {
        const auto index = static_cast<PointIndex>(m_fabric.points.size());
        if (index > m_yarnFirst) {
            m_fabric.lengths.back() = m_pending;
        } else {
            m_loose = m_pending;
        }
        m_pending = 0;
        m_fabric.points.push_back(point);
        m_fabric.lengths.push_back(0);
        return index;
    }

    Fabric& m_fabric;
    const CourseNumbers& m_numbers;
    const LegCrossings& m_crossings;
    EntryTable& m_entries;
    std::vector<EntryIndex> m_rowOfCrossing;
    PointIndex m_yarnFirst = 0;
    double m_pending = 0;      ///< mm of yarn since the last point
    double m_loose = 0;        ///< mm of yarn before the first point
    LoopIndex m_previous = -1; ///< of the same yarn
    std::int32_t m_pass = -1;
};

} // namespace

void threadYarns(Fabric& fabric, const CourseNumbers& numbers, const LegCrossings& crossings,
                 EntryTable& entries) {
    Threader(fabric, numbers, crossings, entries).run();
}

} // namespace knittsim::fabric
