#pragma once

#include "core/fabric/strand_tracker.h"

#include <cstdint>
#include <span>
#include <vector>

namespace knittsim::fabric {

/// Passings of strands as crossings of single legs and floats: two loops cross with four pairs of legs, a
/// float crosses a loop with two.
class LegCrossings {
public:
    struct Crossing {
        std::int32_t over = 0; ///< piece number, see number()
        std::int32_t under = 0;
        OperationIndex operation = 0;
        std::int8_t sign = 1;
        float place = 0; ///< along the bed where a float meets the other strand, pitches
    };

    /// `tracker` must outlive it.
    LegCrossings(const StrandTracker& tracker, std::size_t loopCount);

    static std::int32_t number(LoopIndex loop, Piece piece) {
        return loop * 3 + static_cast<std::int32_t>(piece);
    }

    const std::vector<Crossing>& all() const { return m_crossings; }

    /// Crossings on a piece in their order along it: upwards on a leg, along the way of the yarn on a float.
    std::span<const std::int32_t> on(LoopIndex loop, Piece piece) const {
        const auto p = static_cast<std::size_t>(number(loop, piece));
        return {m_onPiece.data() + m_first[p], static_cast<std::size_t>(m_first[p + 1] - m_first[p])};
    }

private:
    LoopIndex loopOf(Strand strand) const;
    void add(const Passing& passing);
    void list(Strand strand);
    void orderFloats();
    void sortUnordered(Strand strand, std::vector<std::int32_t>& on) const;

    const StrandTracker& m_tracker;
    std::vector<Crossing> m_crossings;
    std::vector<std::int32_t> m_firstOfPassing; ///< its first crossing, or -1
    std::vector<std::int32_t> m_first;          ///< by piece
    std::vector<std::int32_t> m_onPiece;
};

} // namespace knittsim::fabric
