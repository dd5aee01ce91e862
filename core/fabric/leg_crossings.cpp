#include "core/fabric/leg_crossings.h"

#include <algorithm>
#include <array>
#include <utility>

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

/// Place `i` in the order in which the pieces of a strand meet those of one that it passes.
Piece pieceAt(Strand::Kind kind, std::size_t i, bool fromTheLeft) {
    const auto pieces = fromLeft(kind);
    return pieces[fromTheLeft ? i : pieces.size() - 1 - i];
}

/// Of a leg from the middle of its needle, pitches; little, so that wales a fraction of a pitch apart stay
/// apart.
float offset(Piece piece) {
    return piece == Piece::Float ? 0 : piece == Piece::LeftLeg ? -0.1F : 0.1F;
}

} // namespace

LegCrossings::LegCrossings(const StrandTracker& tracker, std::size_t loopCount)
    : m_tracker(tracker), m_first(loopCount * 3 + 1, 0) {
    const auto& passings = tracker.book().passings();
    m_firstOfPassing.assign(passings.size(), -1);
    for (std::size_t p = 0; p < passings.size(); ++p) {
        // A float that leads to no loop is not part of the fabric.
        if (!passings[p].undone && loopOf(passings[p].over) >= 0 && loopOf(passings[p].under) >= 0) {
            m_firstOfPassing[p] = static_cast<std::int32_t>(m_crossings.size());
            add(passings[p]);
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
    for (std::size_t loop = 0; loop < loopCount; ++loop) {
        list({Strand::Kind::Loop, static_cast<std::int32_t>(loop)});
    }
    for (std::int32_t number = 0; number < tracker.floatCount(); ++number) {
        list({Strand::Kind::Float, number});
    }
    orderFloats();
}

/// A float meets the legs of loops that face each other in the order in which they stand along the bed.
void LegCrossings::orderFloats() {
    for (std::size_t piece = 0; piece + 1 < m_first.size(); ++piece) {
        if (static_cast<Piece>(piece % 3) != Piece::Float) {
            continue;
        }
        const auto crossing = [&](std::int32_t c) -> const Crossing& {
            return m_crossings[static_cast<std::size_t>(c)];
        };
        const auto along = [&](std::int32_t c) {
            const bool over = crossing(c).over == static_cast<std::int32_t>(piece);
            return (crossing(c).sign > 0) == over ? crossing(c).place : -crossing(c).place;
        };
        const auto end = m_onPiece.begin() + m_first[piece + 1];
        for (auto first = m_onPiece.begin() + m_first[piece]; first != end;) {
            const auto last = std::find_if(first, end, [&](std::int32_t c) {
                return crossing(c).operation != crossing(*first).operation;
            });
            std::stable_sort(first, last,
                             [&](std::int32_t a, std::int32_t b) { return along(a) < along(b); });
            first = last;
        }
    }
}

LoopIndex LegCrossings::loopOf(Strand strand) const {
    return strand.kind == Strand::Kind::Loop ? strand.index : m_tracker.loopAfterFloat(strand.index);
}

void LegCrossings::add(const Passing& passing) {
    // The over strand goes right past the under one (sign +1): its right leg meets the left leg of the other
    // first.
    const bool overFromLeft = passing.sign < 0;
    for (std::size_t i = 0; i < fromLeft(passing.over.kind).size(); ++i) {
        const Piece over = pieceAt(passing.over.kind, i, overFromLeft);
        for (std::size_t k = 0; k < fromLeft(passing.under.kind).size(); ++k) {
            const Piece under = pieceAt(passing.under.kind, k, !overFromLeft);
            m_crossings.push_back({number(loopOf(passing.over), over), number(loopOf(passing.under), under),
                                   passing.operation, passing.sign,
                                   passing.place + offset(over) + offset(under)});
        }
    }
}

/// Passings that have no order get that in which they were made.
void LegCrossings::sortUnordered(Strand strand, std::vector<std::int32_t>& on) const {
    for (std::size_t i = 1; i < on.size(); ++i) {
        for (std::size_t k = i; k > 0 && on[k] < on[k - 1]; --k) {
            if (!m_tracker.book().areUnordered(strand, on[k - 1], on[k])) {
                break;
            }
            std::swap(on[k], on[k - 1]);
        }
    }
}

/// Enters the crossings on the pieces of a strand in their order along it.
void LegCrossings::list(Strand strand) {
    const LoopIndex loop = loopOf(strand);
    std::vector<std::int32_t> on = m_tracker.book().on(strand);
    if (loop < 0 || on.empty()) {
        return;
    }
    sortUnordered(strand, on);
    for (const Piece piece : fromLeft(strand.kind)) {
        auto slot = m_onPiece.begin() + m_first[static_cast<std::size_t>(number(loop, piece))];
        for (const std::int32_t p : on) {
            if (PassingBook::isBar(p) || m_firstOfPassing[static_cast<std::size_t>(p)] < 0) {
                continue;
            }
            const Passing& passing = m_tracker.book().passings()[static_cast<std::size_t>(p)];
            const std::size_t all = fromLeft(passing.over.kind).size() * fromLeft(passing.under.kind).size();
            for (std::size_t c = 0; c < all; ++c) {
                const auto crossing =
                    m_firstOfPassing[static_cast<std::size_t>(p)] + static_cast<std::int32_t>(c);
                const Crossing& here = m_crossings[static_cast<std::size_t>(crossing)];
                if ((strand == passing.over ? here.over : here.under) == number(loop, piece)) {
                    *slot++ = crossing;
                }
            }
        }
    }
}

} // namespace knittsim::fabric
