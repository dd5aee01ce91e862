#include "core/fabric/machine_shape.h"

#include "core/fabric/pass_levels.h"
#include "core/fabric/wale_places.h"

#include <algorithm>

namespace knittsim::fabric {

namespace {

/// Height of one course under take-down: the legs of a loop that spans a needle pitch.
double courseHeight(const Fabric& fabric) {
    double sum = 0;
    for (const machine::Loop& loop : fabric.made.loops) {
        sum += loop.lengthMm;
    }
    const double length = sum / static_cast<double>(std::max<std::size_t>(1, fabric.made.loops.size()));
    return std::clamp((length - fabric.pitchMm) / 2, 0.15 * length, 0.4 * length);
}

constexpr double kGapInCourses = 0.7;
constexpr double kTurnPitches = 0.4; ///< from the last leg to the yarn that turns round it

/// By loop: how high its heads lie, in courses. A held loop stretches up to the loop that comes through it.
std::vector<std::int32_t> topCourses(const Fabric& fabric) {
    std::vector<std::int32_t> tops;
    tops.reserve(fabric.loops.size());
    for (const Loop& loop : fabric.loops) {
        tops.push_back(loop.end == Loop::End::Bound ? loop.course : loop.course + 1);
    }
    for (std::size_t i = 0; i < fabric.loops.size(); ++i) {
        for (const LoopIndex parent : fabric.made.parentsOf(static_cast<LoopIndex>(i))) {
            std::int32_t& top = tops[static_cast<std::size_t>(parent)];
            top = std::max(top, fabric.loops[i].course);
        }
    }
    return tops;
}

void placeHeads(Fabric& fabric, const machine::MachineProfile& profile, double height,
                const std::vector<WalePlace>& wales) {
    // Below the beds the take-down draws the two sides together.
    const double gap = std::min(profile.bedGapMm, kGapInCourses * height);
    const std::vector<std::int32_t> tops = topCourses(fabric);
        for (std::size_t i = 0; i < fabric.loops.size(); ++i) {
        const Loop& loop = fabric.loops[i];
        const double z = (machine::isFront(loop.bound.bed) ? 0.5 : -0.5) * gap;
        for (const auto& [point, side] : {std::pair{loop.headLeft, -1.0}, {loop.headRight, 1.0}}) {
            Vec3& place = fabric.machinePositions[static_cast<std::size_t>(
                fabric.points[static_cast<std::size_t>(point)].entry)];
            // Heads that share a place lie at the height of the highest there.
            const double y = std::max(place.y(), tops[i] * height);
            place = {(wales[i].centre + side * wales[i].halfWidth) * fabric.pitchMm, y, z};
        }
    }
}

/// Puts the crossings where their two strands can meet.
class CrossingPlacer {
public:
    CrossingPlacer(Fabric& fabric, double height, const std::vector<WalePlace>& wales)
        : m_fabric(fabric), m_height(height), m_wales(wales), m_level(passLevels(fabric)) {}

    void run() {
        m_wish.assign(m_fabric.points.size(), Vec3::Zero());
        wishAll();
        for (const Crossing& crossing : m_fabric.crossings) {
            if (crossing.over >= 0 && crossing.under >= 0) {
                place(crossing.over) = meet(crossing.over, crossing.under);
            }
        }
    }

private:
    /// Between the wishes of the two strands; a float meets a leg where the leg is.
    Vec3 meet(PointIndex a, PointIndex b) const {
        const Vec3& wishA = m_wish[static_cast<std::size_t>(a)];
        const Vec3& wishB = m_wish[static_cast<std::size_t>(b)];
        Vec3 place = 0.5 * (wishA + wishB);
        const bool floatA = point(a).piece == Piece::Float;
        if (floatA != (point(b).piece == Piece::Float)) {
            const Vec3& onFloat = floatA ? wishA : wishB;
            place.x() = floatA ? wishB.x() : wishA.x();
            place.y() = std::clamp(place.y(), onFloat.y() - 0.5 * m_height, onFloat.y() + 0.5 * m_height);
        }
        return place;
    }

    /// Where each strand would have its crossings: at equal distances along its piece.
    void wishAll() {
        for (const Yarn& yarn : m_fabric.yarns) {
            m_previous = -1;
            const PointIndex end = yarn.first + yarn.count;
            for (PointIndex p = yarn.first; p < end;) {
                if (point(p).role != Role::Crossing) {
                    m_previous = point(p).loop;
                    ++p;
                    continue;
                }
                PointIndex last = p;
                while (last < end && point(last).role == Role::Crossing && point(last).piece == point(p).piece &&
                       point(last).loop == point(p).loop) {
                    ++last;
                }
                placeRun(p, last);
                p = last;
            }
        }
    }

    const BondingPoint& point(PointIndex p) const { return m_fabric.points[static_cast<std::size_t>(p)]; }
    Vec3& place(PointIndex p) { return m_fabric.machinePositions[static_cast<std::size_t>(point(p).entry)]; }
    const Loop& loop(LoopIndex index) const { return m_fabric.loops[static_cast<std::size_t>(index)]; }

    void placeRun(PointIndex first, PointIndex last) {
        const LoopIndex own = point(first).loop;
        const bool rightward =
            m_fabric.made.loops[static_cast<std::size_t>(own)].direction == Direction::Right;
        const Side in = rightward ? Side::Left : Side::Right;
        Vec3 from = foot(own, in);
        Vec3 to = from;
        double outward = 0;
        if (point(first).piece == Piece::Float) {
            if (m_previous >= 0 && m_previous != own) {
                const Side out = outOf(m_previous);
                from = foot(m_previous, out);
                // A yarn that turns runs past the selvedge.
                if (out == in && std::abs(from.x() - to.x()) < m_fabric.pitchMm) {
                    outward = (in == Side::Right ? kTurnPitches : -kTurnPitches) * m_fabric.pitchMm;
                }
            }
        } else {
            const Side side = point(first).piece == Piece::LeftLeg ? Side::Left : Side::Right;
            from = foot(own, side);
            to = place(side == Side::Left ? loop(own).headLeft : loop(own).headRight);
            if (side != in) {
                std::swap(from, to);
            }
        }
        for (PointIndex p = first; p < last; ++p) {
            const double t = static_cast<double>(p - first + 1) / static_cast<double>(last - first + 1);
            Vec3& wish = m_wish[static_cast<std::size_t>(p)];
            wish = (1 - t) * from + t * to;
            wish.x() += outward;
        }
    }

    Side outOf(LoopIndex index) const {
        return m_fabric.made.loops[static_cast<std::size_t>(index)].direction == Direction::Right ? Side::Right
                                                                                                  : Side::Left;
    }

    /// Where a leg begins: at its foot, or as far below its head as a foot would be. Of the yarns of one
    /// course that have no feet, those that came later lie higher.
    Vec3 foot(LoopIndex index, Side side) {
        const Loop& l = loop(index);
        const PointIndex p = side == Side::Left ? l.footLeft : l.footRight;
        if (p >= 0) {
            return place(p);
        }
        Vec3 below = place(side == Side::Left ? l.headLeft : l.headRight);
        const double level = l.course + static_cast<double>(m_level[static_cast<std::size_t>(index)]);
        const WalePlace& wale = m_wales[static_cast<std::size_t>(index)];
        below.x() = (wale.centre + (side == Side::Left ? -1 : 1) * wale.halfWidth) * m_fabric.pitchMm;
        below.y() = std::min(level * m_height, below.y() - 0.5 * m_height);
        return below;
    }

    Fabric& m_fabric;
    double m_height;
    const std::vector<WalePlace>& m_wales; ///< by loop, where the yarn was laid
    std::vector<Vec3> m_wish;              ///< by point
    std::vector<float> m_level;
    LoopIndex m_previous = -1; ///< loop of the last corner
};

} // namespace

void layOutOnMachine(Fabric& fabric, const machine::MachineProfile& profile) {
    fabric.machinePositions.assign(static_cast<std::size_t>(fabric.entryCount), Vec3::Zero());
    const double height = courseHeight(fabric);
    const WalePlaces wales = walePlaces(fabric);
    placeHeads(fabric, profile, height, wales.bound);
    CrossingPlacer(fabric, height, wales.made).run();
}

} // namespace knittsim::fabric
