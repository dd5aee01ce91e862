#include "core/fabric/braid_word.h"

#include <algorithm>
#include <deque>
#include <numeric>

namespace knittsim::fabric {

namespace {

struct Meeting {
    std::size_t other = 0;
    bool inFront = false;
    bool toTheRight = false;
    auto operator<=>(const Meeting&) const = default;
};

class Reader {
public:
    Reader(const Fabric& fabric, std::span<const std::vector<LoopIndex>> strands)
        : m_fabric(fabric), m_strandOf(fabric.loops.size(), kNone) {
        for (std::size_t s = 0; s < strands.size(); ++s) {
            for (const LoopIndex loop : strands[s]) {
                m_strandOf[static_cast<std::size_t>(loop)] = s;
            }
        }
    }

    /// What a strand meets from its feet upwards; nothing when its legs do not agree.
    std::optional<std::deque<Meeting>> meetings(const std::vector<LoopIndex>& strand,
                                                std::span<const std::vector<LoopIndex>> strands) const {
        std::optional<std::deque<Meeting>> all;
        for (const LoopIndex loop : strand) {
            for (const Piece piece : {Piece::LeftLeg, Piece::RightLeg}) {
                auto found = onLeg(loop, piece, strands);
                if (all && *all != found) {
                    return std::nullopt;
                }
                all = std::move(found);
            }
        }
        return all;
    }

private:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    /// Each strand is met once for the first of its legs that is crossed; the others lie right behind.
    std::deque<Meeting> onLeg(LoopIndex loop, Piece piece,
                              std::span<const std::vector<LoopIndex>> strands) const {
        std::deque<Meeting> legs;
        for (const PointIndex p : upwards(loop, piece)) {
            const BondingPoint& point = m_fabric.points[static_cast<std::size_t>(p)];
            const Crossing& crossing = m_fabric.crossings[static_cast<std::size_t>(point.crossing)];
            const bool over = crossing.over == p;
            const BondingPoint& other =
                m_fabric.points[static_cast<std::size_t>(over ? crossing.under : crossing.over)];
            const std::size_t strand = m_strandOf[static_cast<std::size_t>(other.loop)];
            if (strand != kNone && other.piece != Piece::Float &&
                strand != m_strandOf[static_cast<std::size_t>(loop)]) {
                legs.push_back({strand, over, over == (crossing.sign > 0)});
            }
        }
        std::deque<Meeting> met;
        while (!legs.empty()) {
            met.push_back(legs.front());
            std::size_t left = strands[met.back().other].size() * 2;
            while (left > 0 && !legs.empty() && legs.front() == met.back()) {
                legs.pop_front();
                --left;
            }
        }
        return met;
    }

    std::vector<PointIndex> upwards(LoopIndex loop, Piece piece) const {
        std::vector<PointIndex> on;
        const Loop& l = m_fabric.loops[static_cast<std::size_t>(loop)];
        const PointIndex head = piece == Piece::LeftLeg ? l.headLeft : l.headRight;
        const PointIndex otherHead = piece == Piece::LeftLeg ? l.headRight : l.headLeft;
        const PointIndex step = head < otherHead ? -1 : 1; // along the yarn away from the heads
        const auto isOnLeg = [&](PointIndex p) {
            const BondingPoint& point = m_fabric.points[static_cast<std::size_t>(p)];
            return point.loop == loop && point.role == Role::Crossing && point.piece == piece;
        };
        const auto count = static_cast<PointIndex>(m_fabric.points.size());
        for (PointIndex p = head + step; p >= 0 && p < count && isOnLeg(p); p += step) {
            on.push_back(p);
        }
        std::ranges::reverse(on);
        return on;
    }

    const Fabric& m_fabric;
    std::vector<std::size_t> m_strandOf; ///< by loop
};

} // namespace

std::optional<std::vector<int>> braidWord(const Fabric& fabric,
                                          std::span<const std::vector<LoopIndex>> strands) {
    const Reader reader(fabric, strands);
    std::vector<std::deque<Meeting>> next;
    for (const auto& strand : strands) {
        auto meetings = reader.meetings(strand, strands);
        if (!meetings) {
            return std::nullopt;
        }
        next.push_back(std::move(*meetings));
    }
    std::vector<std::size_t> order(strands.size());
    std::iota(order.begin(), order.end(), 0U);
    std::vector<int> word;
    for (std::size_t i = 0; i + 1 < order.size();) {
        auto& left = next[order[i]];
        auto& right = next[order[i + 1]];
        const bool meet = !left.empty() && !right.empty() && left.front().other == order[i + 1] &&
                          right.front().other == order[i] && left.front().toTheRight;
        if (!meet) {
            ++i;
            continue;
        }
        word.push_back((left.front().inFront ? 1 : -1) * static_cast<int>(i + 1));
        left.pop_front();
        right.pop_front();
        std::swap(order[i], order[i + 1]);
        i = i > 0 ? i - 1 : 0;
    }
    const bool allRead = std::ranges::all_of(next, [](const auto& meetings) { return meetings.empty(); });
    return allRead ? std::optional(word) : std::nullopt;
}

} // namespace knittsim::fabric
