#pragma once

#include "core/base/vec3.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace knittsim::geometry {

/// Pairs of boxes that share a cell of a plane grid. Memory and time grow with the number of boxes as long as
/// they are not much larger than a cell.
class SegmentGrid {
public:
    /// Bounds in the plane, mm.
    struct Box {
        float left = 0;
        float bottom = 0;
        float right = 0;
        float top = 0;
    };

    SegmentGrid(std::span<const Box> boxes, float cellMm) : m_scale(1 / cellMm) {
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const Box& box = boxes[i];
            for (std::int32_t x = cell(box.left); x <= cell(box.right); ++x) {
                for (std::int32_t y = cell(box.bottom); y <= cell(box.top); ++y) {
                    m_members.push_back({key(x, y), static_cast<std::int32_t>(i)});
                }
            }
        }
        std::ranges::sort(m_members);
    }

    /// Calls `visit(a, b)` once for every two boxes that share a cell.
    template<class Visit> void forEachPair(std::span<const Box> boxes, const Visit& visit) const {
        for (std::size_t first = 0; first < m_members.size();) {
            std::size_t last = first + 1;
            while (last < m_members.size() && m_members[last].cell == m_members[first].cell) {
                ++last;
            }
            for (std::size_t i = first; i < last; ++i) {
                for (std::size_t k = i + 1; k < last; ++k) {
                    const auto a = static_cast<std::size_t>(m_members[i].box);
                    const auto b = static_cast<std::size_t>(m_members[k].box);
                    // Boxes that share several cells meet in the first of them only.
                    const std::uint64_t shared = key(std::max(cell(boxes[a].left), cell(boxes[b].left)),
                                                     std::max(cell(boxes[a].bottom), cell(boxes[b].bottom)));
                    if (shared == m_members[first].cell) {
                        visit(a, b);
                    }
                }
            }
            first = last;
        }
    }

private:
    struct Member {
        std::uint64_t cell;
        std::int32_t box;
        auto operator<=>(const Member&) const = default;
    };

    std::int32_t cell(float coordinate) const {
        constexpr float kFarthest = 1e9F;
        return static_cast<std::int32_t>(std::clamp(std::floor(coordinate * m_scale), -kFarthest, kFarthest));
    }
    static std::uint64_t key(std::int32_t x, std::int32_t y) {
        return static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32 |
               static_cast<std::uint32_t>(y);
    }

    float m_scale;
    std::vector<Member> m_members;
};

} // namespace knittsim::geometry
