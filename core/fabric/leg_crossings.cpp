#include "core/fabric/leg_crossings.h"

#include <algorithm>
#include <array>

namespace knittsim::fabric {

namespace {

/// Pieces of a strand in the order in which a strand that comes from the left meets them.
std::span<const Piece> fromLeft(Strand::Kind kind) {
    static constexpr std::array kLoop{Piece::LeftLeg, Piece::RightLeg};
    static constexpr std::array kFloat{Piece::Float};
    if (kind == Strand::Kind::Loop) {
        return kLoop;
    }
    return kFloat;
}

/// Of a leg from the middle of its needle, pitches; little, so that wales a fraction of a pitch apart stay
/// apart.
float offset(Piece piece) {
    return piece == Piece::Float ? 0 : piece == Piece::LeftLeg ? -0.1F : 0.1F;
}

} // namespace

LegCrossings::LegCrossings(const StrandTracker& tracker, std::size_t loopCount)
    : m_first(loopCount * 3 + 1, 0) {
    const auto loopOf = [&](Strand strand) {
        return strand.kind == Strand::Kind::Loop ? strand.index : tracker.loopAfterFloat(strand.index);
    };
    for (const Passing& passing : tracker.passings()) {
        const LoopIndex over = loopOf(passing.over);
        const LoopIndex under = loopOf(passing.under);
        // A float that leads to no loop is not part of the fabric.
        if (!passing.undone && over >= 0 && under >= 0) {
            add(passing, over, under);
        }
    }
    for (const Crossing& crossing : m_crossings) {
        ++m_first[static_cast<std::size_t>(crossing.over) + 1];
        ++m_first[static_cast<std::size_t>(crossing.under) + 1];
    }
    for (std::size_t i = 1; i < m_first.size(); ++i) {
        m_first[i] += m_first[i - 1];
    }
    m_onPiece.resize(m_crossings.size() * 2);
    std::vector<std::int32_t> next(m_first.begin(), m_first.end() - 1);
    for (std::size_t c = 0; c < m_crossings.size(); ++c) {
        for (const std::int32_t piece : {m_crossings[c].over, m_crossings[c].under}) {
            m_onPiece[static_cast<std::size_t>(next[static_cast<std::size_t>(piece)]++)] =
                static_cast<std::int32_t>(c);
        }
    }
    orderFloats();
}

/// A float meets the legs of loops that face each other in the order in which they stand along the bed.
void LegCrossings::orderFloats() {
    for (std::size_t piece = 0; piece + 1 < m_first.size(); ++piece) {
        if (static_cast<Piece>(piece % 3) != Piece::Float) {
            continue;
        }
        const auto along = [&](std::int32_t c) {
            const Crossing& crossing = m_crossings[static_cast<std::size_t>(c)];
            const bool over = crossing.over == static_cast<std::int32_t>(piece);
            const bool rightward = (crossing.sign > 0) == over;
            return std::pair(crossing.operation, rightward ? crossing.place : -crossing.place);
        };
        std::stable_sort(m_onPiece.begin() + m_first[piece], m_onPiece.begin() + m_first[piece + 1],
                         [&](std::int32_t a, std::int32_t b) { return along(a) < along(b); });
    }
}

void LegCrossings::add(const Passing& passing, LoopIndex over, LoopIndex under) {
    // The over strand goes right past the under one (sign +1): its right leg meets the left leg of the other
    // first.
    const auto overs = fromLeft(passing.over.kind);
    const auto unders = fromLeft(passing.under.kind);
    for (std::size_t i = 0; i < overs.size(); ++i) {
        for (std::size_t k = 0; k < unders.size(); ++k) {
            const Piece a = passing.sign > 0 ? overs[overs.size() - 1 - i] : overs[i];
            const Piece b = passing.sign > 0 ? unders[k] : unders[unders.size() - 1 - k];
            const float aside = offset(a) + offset(b);
            m_crossings.push_back(
                {number(over, a), number(under, b), passing.operation, passing.sign, passing.place + aside});
        }
    }
}

} // namespace knittsim::fabric
