#include "core/geometry/crossing_audit.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace knittsim::geometry {

using fabric::Fabric;
using fabric::Piece;
using fabric::PointIndex;
using fabric::Role;

namespace {

using Event = CrossingEvent;

constexpr PointIndex kBeyondBorder = 3;   ///< bonding points
constexpr PointIndex kPointsOnPiece = 64; ///< looked through on either side

class Auditor {
public:
    Auditor(const Fabric& fabric, const YarnCurves& curves, const std::vector<ProjectedCrossing>& crossings)
        : m_fabric(fabric), m_curves(curves), m_events(fabric, curves), m_wanted(m_events.wanted()),
          m_found(m_events.found(crossings)) {
        m_audit.order.assign(crossings.size(), 1);
        m_next.assign(fabric.loops.size(), -1);
        for (std::size_t i = 0; i < fabric.loops.size(); ++i) {
            for (const machine::LoopIndex parent :
                 fabric.made.parentsOf(static_cast<machine::LoopIndex>(i))) {
                m_next[static_cast<std::size_t>(parent)] = static_cast<machine::LoopIndex>(i);
            }
        }
    }

    CrossingAudit run(const std::vector<ProjectedCrossing>& crossings) {
        compare();
        matchBeside();
        judgeFurther();
        slideOffEnds(crossings);
        return std::move(m_audit);
    }

private:
    void compare() {
        std::size_t f = 0;
        std::size_t w = 0;
        while (f < m_found.size() || w < m_wanted.size()) {
            const auto key = [](const Event& e) { return std::tie(e.a, e.b); };
            const bool takeFound =
                w == m_wanted.size() || (f < m_found.size() && key(m_found[f]) <= key(m_wanted[w]));
            const Event& head = takeFound ? m_found[f] : m_wanted[w];
            std::size_t fEnd = f;
            while (fEnd < m_found.size() && key(m_found[fEnd]) == key(head)) {
                ++fEnd;
            }
            std::size_t wEnd = w;
            while (wEnd < m_wanted.size() && key(m_wanted[wEnd]) == key(head)) {
                ++wEnd;
            }
            comparePair(f, fEnd, w, wEnd);
            f = fEnd;
            w = wEnd;
        }
    }

    /// The wanted crossings of a pair must be there in their order; what is left over waits.
    void comparePair(std::size_t f, std::size_t fEnd, std::size_t w, std::size_t wEnd) {
        m_left.clear();
        for (std::size_t i = f; i < fEnd; ++i) {
            m_left.push_back(&m_found[i]);
        }
        m_asked.clear();
        for (std::size_t i = w; i < wEnd; ++i) {
            cancelOrPush(m_wanted[i], m_asked);
        }
        auto next = m_left.begin();
        for (const Event* wanted : m_asked) {
            const auto match = std::find_if(next, m_left.end(), [&](const Event* e) {
                return e->aOver == wanted->aOver && e->sign == wanted->sign;
            });
            if (wanted->kink) {
                next = match == m_left.end() ? next : m_left.erase(match);
                continue;
            }
            ++m_audit.expected;
            if (match == m_left.end()) {
                // Of a stitch the other strand is in front.
                const auto swapped = std::find_if(next, m_left.end(), [&](const Event* e) {
                    return wanted->place >= 0 && e->aOver != wanted->aOver && e->sign == -wanted->sign;
                });
                if (swapped == m_left.end()) {
                    m_missing.push_back(wanted);
                    continue;
                }
                m_audit.faults.push_back(
                    {CrossingFault::Kind::WrongOrder, wanted->a, wanted->b, (*swapped)->node});
                m_audit.order[(*swapped)->index] = -1;
                next = m_left.erase(swapped);
            } else {
                ++m_audit.found;
                next = m_left.erase(match);
            }
        }
        m_further.insert(m_further.end(), m_left.begin(), m_left.end());
    }

    /// A crossing cancels with the one before when the same strand is in front and the signs are opposite.
    static void cancelOrPush(const Event& e, std::vector<const Event*>& left) {
        const bool cancels = !left.empty() && left.back()->a == e.a && left.back()->b == e.b &&
                             left.back()->aOver == e.aOver && left.back()->sign == -e.sign;
        if (cancels) {
            left.pop_back();
        } else {
            left.push_back(&e);
        }
    }

    /// Where one piece of a yarn ends and the next begins is not sharp: a missing crossing may have been
    /// found on the pieces beside.
    void matchBeside() {
        std::ranges::sort(m_further, {}, [](const Event* e) { return e->over; });
        // The nearest first: a float meets legs of both beds at one needle.
        for (const PointIndex reach : {1, 3}) {
            std::erase_if(m_missing, [&](const Event* wanted) {
                const auto match =
                    findFurther(wanted->over, wanted->under, m_events.yarnSign(*wanted), reach);
                if (match == m_further.end()) {
                    return false;
                }
                ++m_audit.found;
                m_further.erase(match);
                return true;
            });
        }
        for (const Event* wanted : m_missing) {
            m_audit.faults.push_back({CrossingFault::Kind::Missing, wanted->a, wanted->b, wanted->node});
            const auto swapped = findFurther(wanted->under, wanted->over, -m_events.yarnSign(*wanted), 1);
            if (swapped != m_further.end()) {
                m_audit.order[(*swapped)->index] = -1;
                m_further.erase(swapped);
            }
        }
    }

    /// A crossing that no other explains, on these pieces, or within `reach` bonding points: of points of a
    /// float, else next to them.
    std::vector<const Event*>::iterator findFurther(PointIndex over, PointIndex under, int sign,
                                                    PointIndex reach) {
        const auto near = [&](PointIndex found, PointIndex wanted) {
            const fabric::BondingPoint& bp = m_fabric.points[static_cast<std::size_t>(wanted)];
            const bool onFloat = bp.role == Role::Crossing && bp.piece == Piece::Float;
            return std::abs(found - wanted) <= (onFloat ? reach : 1) ||
                   m_events.pieceOf(found) == m_events.pieceOf(wanted);
        };
        const auto place = [](const Event* e) { return e->over; };
        auto it = std::ranges::lower_bound(m_further, over - kPointsOnPiece, {}, place);
        for (; it != m_further.end() && (*it)->over <= over + kPointsOnPiece; ++it) {
            if (near((*it)->over, over) && near((*it)->under, under) && m_events.yarnSign(**it) == sign) {
                return it;
            }
        }
        return m_further.end();
    }

    void judgeFurther() {
        std::ranges::sort(m_further); // they lie in m_found, in the order of pieces and places
        m_left.clear();
        for (const Event* e : m_further) {
            cancelOrPush(*e, m_left);
        }
        std::vector<const Event*> unexplained;
        std::vector<const Event*> layered;
        for (const Event* e : m_left) {
            const int order = layerOrder(e->a, e->b);
            if (order == 0) {
                unexplained.push_back(e);
            } else if ((order > 0) != e->aOver) {
                m_audit.faults.push_back({CrossingFault::Kind::WrongOrder, e->a, e->b, e->node});
                m_audit.order[e->index] = -1;
            } else {
                layered.push_back(e);
            }
        }
        m_audit.layered = layered.size();
        judgeUnexplained(unexplained, layered);
    }

    /// Two crossings of the same strands also cancel over the border of two pieces, when they lie near each
    /// other along both. Where the layers say who is in front at one of them, so they do at the other.
    void judgeUnexplained(std::vector<const Event*>& events, std::vector<const Event*>& layered) {
        const auto place = [](const Event* e) { return e->over; };
        std::ranges::sort(events, {}, place);
        std::ranges::sort(layered, {}, place);
        while (!events.empty()) {
            const Event& e = *events.back();
            events.pop_back();
            if (takeNear(events, e.over, e.under, -m_events.yarnSign(e)) ||
                takeNear(layered, e.over, e.under, -m_events.yarnSign(e))) {
                continue;
            }
            if (takeNear(layered, e.under, e.over, m_events.yarnSign(e))) {
                m_audit.order[e.index] = -1;
                m_audit.faults.push_back({CrossingFault::Kind::WrongOrder, e.a, e.b, e.node});
            } else {
                m_audit.order[e.index] = 0;
                m_unexplained.push_back(&e);
            }
        }
    }

    /// Whatever lies beyond the last crossing that is explained slides off the end of its yarn.
    void slideOffEnds(const std::vector<ProjectedCrossing>& crossings) {
        if (m_unexplained.empty()) {
            return;
        }
        std::vector<std::pair<std::int32_t, std::int32_t>> explained(
            m_curves.yarns.size(),
            {std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::min()});
        for (std::size_t i = 0; i < crossings.size(); ++i) {
            for (const std::int32_t node : {crossings[i].over, crossings[i].under}) {
                auto& [first, last] = explained[yarnAt(m_curves, node)];
                first = m_audit.order[i] != 0 ? std::min(first, node) : first;
                last = m_audit.order[i] != 0 ? std::max(last, node) : last;
            }
        }
        const auto slidesOff = [&](std::int32_t node) {
            const auto& [first, last] = explained[yarnAt(m_curves, node)];
            return node < first || node > last;
        };
        for (const Event* e : m_unexplained) {
            const ProjectedCrossing& crossing = crossings[e->index];
            if (!slidesOff(crossing.over) && !slidesOff(crossing.under)) {
                m_audit.faults.push_back({CrossingFault::Kind::Unexplained, e->a, e->b, e->node});
            }
        }
    }

    /// Takes out one of `events`, sorted by place, of two strands near these points.
    bool takeNear(std::vector<const Event*>& events, PointIndex over, PointIndex under, int sign) const {
        const auto place = [](const Event* e) { return e->over; };
        auto it = std::ranges::lower_bound(events, over - kBeyondBorder, {}, place);
        for (; it != events.end() && (*it)->over <= over + kBeyondBorder; ++it) {
            if (std::abs((*it)->under - under) <= kBeyondBorder && m_events.yarnSign(**it) == sign) {
                events.erase(it);
                return true;
            }
        }
        return false;
    }

    /// +1 when the layers say that a lies in front of b, -1 behind, 0 when they say nothing.
    int layerOrder(const CurvePiece& a, const CurvePiece& b) const {
        if (a.loop == b.loop && a.piece != Piece::Float && b.piece != Piece::Float) {
            return 0;
        }
        if (const int order = stackOrder(a.loop, b.loop); order != 0) {
            return order;
        }
        const int bound = layer(a, &Auditor::bedBound) - layer(b, &Auditor::bedBound);
        if (bound != 0) {
            return bound > 0 ? 1 : -1;
        }
        const int first = layer(a, &Auditor::bedMade) - layer(b, &Auditor::bedMade);
        return isDrawnThrough(a.loop, b.loop) ? 0 : (first > 0) - (first < 0);
    }

    bool isDrawnThrough(machine::LoopIndex a, machine::LoopIndex b) const {
        return std::ranges::find(m_fabric.made.parentsOf(std::max(a, b)), std::min(a, b)) !=
               m_fabric.made.parentsOf(std::max(a, b)).end();
    }

    /// Loops on one needle lie over each other: the first of the stack is nearest to its bed.
    int stackOrder(machine::LoopIndex a, machine::LoopIndex b) const {
        const machine::LoopIndex next = m_next[static_cast<std::size_t>(a)];
        if (a == b || next < 0 || next != m_next[static_cast<std::size_t>(b)]) {
            return 0;
        }
        const fabric::Loop& first = m_fabric.loops[static_cast<std::size_t>(a)];
        const fabric::Loop& second = m_fabric.loops[static_cast<std::size_t>(b)];
        const int towardsBed = machine::isFront(first.bound.bed) ? 1 : -1;
        return first.stackPlace < second.stackPlace ? towardsBed : -towardsBed;
    }

    machine::Bed bedBound(machine::LoopIndex loop) const {
        return m_fabric.loops[static_cast<std::size_t>(loop)].bound.bed;
    }
    machine::Bed bedMade(machine::LoopIndex loop) const {
        return m_fabric.made.loops[static_cast<std::size_t>(loop)].needle.bed;
    }

    /// +1 on the front bed, 0 between the beds, -1 on the rear bed.
    int layer(const CurvePiece& piece, machine::Bed (Auditor::*bedOf)(machine::LoopIndex) const) const {
        if (piece.piece == Piece::Float) {
            return 0;
        }
        return machine::isFront((this->*bedOf)(piece.loop)) ? 1 : -1;
    }

    const Fabric& m_fabric;
    const YarnCurves& m_curves;
    std::vector<machine::LoopIndex> m_next; ///< by loop: the last one drawn through it, or -1
    CrossingEvents m_events;
    std::vector<Event> m_wanted;
    std::vector<Event> m_found;
    std::vector<const Event*> m_left, m_asked;
    std::vector<const Event*> m_missing, m_further, m_unexplained;
    CrossingAudit m_audit;
};

} // namespace

CrossingAudit auditCrossings(const Fabric& fabric, const YarnCurves& curves,
                             const std::vector<ProjectedCrossing>& crossings) {
    return Auditor(fabric, curves, crossings).run(crossings);
}

} // namespace knittsim::geometry
