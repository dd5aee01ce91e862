#include "core/fabric/crossing_places.h"

#include "core/fabric/pass_levels.h"

#include <algorithm>
#include <cmath>

namespace knittsim::fabric {

namespace {

constexpr double kSamePlace = 0.1;   ///< pitches
constexpr double kSameNeedle = 0.25; ///< pitches
constexpr double kStill = 0.3;       ///< pitches
constexpr double kLeastSpan = 0.1;   ///< courses

/// Puts the crossings where their two strands can meet.
class Placer {
public:
    Placer(Fabric& fabric, const CourseHeights& heights, const std::vector<WalePlace>& wales)
        : m_fabric(fabric), m_heights(heights), m_wales(wales), m_level(passLevels(fabric)) {}

    void run() {
        m_wish.assign(m_fabric.points.size(), Vec3::Zero());
        m_span.assign(m_fabric.points.size(), 0);
        wishAll();
        for (const Crossing& crossing : m_fabric.crossings) {
            if (crossing.over >= 0 && crossing.under >= 0) {
                place(crossing.over) = meet(crossing.over, crossing.under);
            }
        }
        for (const Yarn& yarn : m_fabric.yarns) {
            sortFloats(yarn.first, yarn.first + yarn.count);
            levelFloats(yarn.first, yarn.first + yarn.count);
        }
    }

private:
    /// A float meets all legs of a needle in one moment: in the order in which they stand there now.
    void sortFloats(PointIndex first, PointIndex end) {
        const auto crossingOf = [&](PointIndex p) -> const Crossing& {
            return m_fabric.crossings[static_cast<std::size_t>(point(p).crossing)];
        };
        while (first < end) {
            PointIndex last = first + 1;
            if (onFloat(first)) {
                const Crossing& here = crossingOf(first);
                while (last < end && onFloat(last) && point(last).loop == point(first).loop &&
                       crossingOf(last).operation == here.operation &&
                       std::abs(crossingOf(last).place - here.place) < kSameNeedle) {
                    ++last;
                }
                sortAlong(first, last, (here.sign > 0) == (here.over == first) ? 1 : -1);
            }
            first = last;
        }
    }

    /// `direction`: +1 where the yarn runs to the right.
    void sortAlong(PointIndex first, PointIndex last, double direction) {
        std::stable_sort(m_fabric.points.begin() + first, m_fabric.points.begin() + last,
                         [&](const BondingPoint& a, const BondingPoint& b) {
                             const auto x = [&](const BondingPoint& p) {
                                 return m_fabric.machinePositions[static_cast<std::size_t>(p.entry)].x();
                             };
                             return direction * x(a) < direction * x(b);
                         });
        for (PointIndex p = first; p < last; ++p) {
            Crossing& crossing = m_fabric.crossings[static_cast<std::size_t>(point(p).crossing)];
            (point(p).front > 0 ? crossing.over : crossing.under) = p;
        }
    }

    bool onFloat(PointIndex p) const {
        return point(p).role == Role::Crossing && point(p).piece == Piece::Float;
    }

    /// Between the wishes of the two strands, nearer to that of a short leg; a float meets a leg where the
    /// leg is.
    Vec3 meet(PointIndex a, PointIndex b) const {
        const Vec3& wishA = m_wish[static_cast<std::size_t>(a)];
        const Vec3& wishB = m_wish[static_cast<std::size_t>(b)];
        const bool floatA = point(a).piece == Piece::Float;
        const bool floatB = point(b).piece == Piece::Float;
        if (!floatA && !floatB) {
            const double spanA = m_span[static_cast<std::size_t>(a)];
            const double spanB = m_span[static_cast<std::size_t>(b)];
            Vec3 place = (spanB * wishA + spanA * wishB) / (spanA + spanB);
            place.x() = (spanA * wishA.x() + spanB * wishB.x()) / (spanA + spanB);
            return place;
        }
        Vec3 place = 0.5 * (wishA + wishB);
        if (floatA != floatB) {
            const Vec3& onFloat = floatA ? wishA : wishB;
            place.x() = floatA ? wishB.x() : wishA.x();
            place.y() = std::clamp(place.y(), onFloat.y() - 0.5 * m_heights.courseMm(),
                                   onFloat.y() + 0.5 * m_heights.courseMm());
        }
        return place;
    }

    /// A float crosses legs that stand behind each other at one height.
    void levelFloats(PointIndex first, PointIndex end) {
        while (first < end) {
            PointIndex last = first + 1;
            double y = place(first).y();
            while (last < end && onFloat(first) && onFloat(last) && point(last).loop == point(first).loop &&
                   std::abs(place(last).x() - place(first).x()) < kSamePlace * m_fabric.pitchMm) {
                y += place(last++).y();
            }
            if (last - first > 1) {
                for (PointIndex p = first; p < last; ++p) {
                    place(p).y() = y / static_cast<double>(last - first);
                }
            }
            first = last;
        }
    }

    /// Where each strand would have its crossings.
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
                while (last < end && point(last).role == Role::Crossing &&
                       point(last).piece == point(p).piece && point(last).loop == point(p).loop) {
                    ++last;
                }
                wishRun(p, last);
                p = last;
            }
        }
    }

    const BondingPoint& point(PointIndex p) const { return m_fabric.points[static_cast<std::size_t>(p)]; }
    Vec3& place(PointIndex p) { return m_fabric.machinePositions[static_cast<std::size_t>(point(p).entry)]; }
    const Loop& loop(LoopIndex index) const { return m_fabric.loops[static_cast<std::size_t>(index)]; }

    void wishRun(PointIndex first, PointIndex last) {
        const LoopIndex own = point(first).loop;
        const bool rightward =
            m_fabric.made.loops[static_cast<std::size_t>(own)].direction == Direction::Right;
        const Side in = rightward ? Side::Left : Side::Right;
        Vec3 from = foot(own, in);
        Vec3 to = from;
        if (point(first).piece == Piece::Float) {
            if (m_previous >= 0 && m_previous != own) {
                from = foot(m_previous, outOf(m_previous));
            }
            for (PointIndex p = first; p < last; ++p) {
                wishOnFloat(p, from.y(), to.y());
            }
        } else {
            wishOnLeg(first, last, point(first).piece == Piece::LeftLeg ? Side::Left : Side::Right, in);
        }
    }

    void wishOnLeg(PointIndex first, PointIndex last, Side side, Side in) {
        const LoopIndex own = point(first).loop;
        const Vec3 base = foot(own, side);
        const Vec3& head = place(side == Side::Left ? loop(own).headLeft : loop(own).headRight);
        for (PointIndex p = first; p < last; ++p) {
            const double share = static_cast<double>(p - first + 1) / static_cast<double>(last - first + 1);
            const double t = side == in ? share : 1 - share;
            Vec3& wish = m_wish[static_cast<std::size_t>(p)];
            m_span[static_cast<std::size_t>(p)] =
                std::max(kLeastSpan * m_heights.courseMm(), head.y() - base.y());
            wish = (1 - t) * base + t * head;
            switch (whereMet(p)) {
            case Met::Made:
                wish.x() = baseX(own, side);
                break;
            case Met::Bound:
                wish.x() = head.x();
                break;
            case Met::Between:
                break;
            }
        }
    }

    /// Where a float met a leg: where its loop was made, where it was bound, or on the way.
    enum class Met { Made, Bound, Between };
    Met whereMet(PointIndex onLeg) const {
        const Crossing& crossing = m_fabric.crossings[static_cast<std::size_t>(point(onLeg).crossing)];
        const PointIndex other = crossing.over == onLeg ? crossing.under : crossing.over;
        if (point(other).piece != Piece::Float) {
            return Met::Between;
        }
        const LoopIndex own = point(onLeg).loop;
        const machine::Loop& made = m_fabric.made.loops[static_cast<std::size_t>(own)];
        const auto place = static_cast<double>(crossing.place);
        const double fromMade = std::abs(place - machine::positionPitches(made.needle, made.rack));
        const double fromBound =
            std::abs(place - machine::positionPitches(loop(own).bound, loop(own).boundRack));
        if (std::min(fromMade, fromBound) > kStill) {
            return Met::Between;
        }
        return fromMade <= fromBound ? Met::Made : Met::Bound;
    }

    double baseX(LoopIndex index, Side side) const {
        const WalePlace& wale = m_wales[static_cast<std::size_t>(index)];
        return (wale.centre + (side == Side::Left ? -1 : 1) * wale.halfWidth) * m_fabric.pitchMm;
    }

    /// Where the machine was, in the course that was made then, between the ends of the float.
    void wishOnFloat(PointIndex p, double fromY, double toY) {
        const Crossing& crossing = m_fabric.crossings[static_cast<std::size_t>(point(p).crossing)];
        const auto latest = static_cast<std::size_t>(latestLoop(m_fabric, crossing.operation));
        const double level = m_fabric.loops[latest].course + static_cast<double>(m_level[latest]);
        m_wish[static_cast<std::size_t>(p)] = {
            static_cast<double>(crossing.place) * m_fabric.pitchMm,
            std::clamp(m_heights.at(level), std::min(fromY, toY), std::max(fromY, toY)), 0};
    }

    Side outOf(LoopIndex index) const {
        return m_fabric.made.loops[static_cast<std::size_t>(index)].direction == Direction::Right
                   ? Side::Right
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
        below.x() = baseX(index, side);
        below.y() = std::min(m_heights.at(level), below.y() - 0.5 * m_heights.courseMm());
        return below;
    }

    Fabric& m_fabric;
    const CourseHeights& m_heights;
    const std::vector<WalePlace>& m_wales; ///< by loop, where the yarn was laid
    std::vector<Vec3> m_wish;              ///< by point
    std::vector<double> m_span;            ///< by point: height of its leg, mm
    std::vector<float> m_level;
    LoopIndex m_previous = -1; ///< loop of the last corner
};

} // namespace

void placeCrossings(Fabric& fabric, const CourseHeights& heights, const std::vector<WalePlace>& wales) {
    Placer(fabric, heights, wales).run();
}

} // namespace knittsim::fabric
