#include "ui/render/hidden_sky.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace knittsim::render {

namespace {

constexpr float kReach =
    2.4F; ///< diameters, to where yarn hides anything; and along it, what is not looked at
constexpr float kStep = 0.8F; ///< diameters between two places that are looked at
constexpr float kMostAll = 8; ///< what a texel holds
constexpr float kMostWay = 4;

/// A short piece of yarn.
struct Place {
    Vec3f at;
    float arc;
    float size; ///< what it hides at a distance of 1 mm
    std::uint32_t yarn;
    std::uint32_t node;
};

/// Places in the cells of a plane grid, cell after cell.
class Grid {
public:
    Grid(std::vector<Place>& places, float cellMm) : m_scale(1 / cellMm) {
        geometry::Bounds box;
        for (const Place& place : places) {
            box.add(place.at);
        }
        m_low = box.low;
        constexpr float kMostCells = 1000; // a fabric that flies apart gets larger ones
        const float longest = std::max(box.size().x(), box.size().y());
        m_scale = std::min(m_scale, kMostCells / std::max(longest, 1e-6F));
        m_width = cellOf(box.high.x(), 0) + 1;
        m_height = cellOf(box.high.y(), 1) + 1;
        m_first.assign(static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height) + 1, 0);
        for (const Place& place : places) {
            ++m_first[indexOf(place) + 1];
        }
        for (std::size_t i = 1; i < m_first.size(); ++i) {
            m_first[i] += m_first[i - 1];
        }
        std::vector<std::size_t> next(m_first.begin(), m_first.end() - 1);
        std::vector<Place> sorted(places.size());
        for (const Place& place : places) {
            sorted[next[indexOf(place)]++] = place;
        }
        places = std::move(sorted);
    }

    /// Calls `visit(a, b)` once for every two places in the same or neighbouring cells.
    template<class Visit> void forEachPair(const Visit& visit) const {
        for (int y = 0; y < m_height; ++y) {
            for (int x = 0; x < m_width; ++x) {
                const std::size_t here = index(x, y);
                // The next cell to the right lies behind this one; so do the three above.
                const std::size_t end = x + 1 < m_width ? m_first[here + 2] : m_first[here + 1];
                const std::size_t above = y + 1 < m_height ? index(std::max(0, x - 1), y + 1) : 0;
                const std::size_t behind = y + 1 < m_height ? index(std::min(m_width - 1, x + 1), y + 1) : 0;
                for (std::size_t a = m_first[here]; a < m_first[here + 1]; ++a) {
                    for (std::size_t b = a + 1; b < end; ++b) {
                        visit(a, b);
                    }
                    for (std::size_t b = m_first[above]; above > 0 && b < m_first[behind + 1]; ++b) {
                        visit(a, b);
                    }
                }
            }
        }
    }

private:
    int cellOf(float coordinate, int axis) const {
        return static_cast<int>((coordinate - m_low[axis]) * m_scale);
    }
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(x);
    }
    std::size_t indexOf(const Place& place) const {
        return index(cellOf(place.at.x(), 0), cellOf(place.at.y(), 1));
    }

    float m_scale;
    Vec3f m_low;
    int m_width = 0;
    int m_height = 0;
    std::vector<std::size_t> m_first;
};

std::vector<Place> placesOf(const SceneFrame& frame) {
    std::vector<Place> places;
    for (std::uint32_t y = 0; y < frame.topology->yarns.size(); ++y) {
        const geometry::YarnCurves::Range& yarn = frame.topology->yarns[y];
        const float diameter = frame.diameters[yarn.carrier];
        float next = 0;
        for (std::int32_t n = yarn.first; n < yarn.first + yarn.count; ++n) {
            const auto& node = frame.nodes[static_cast<std::size_t>(n)];
            if (node[3] >= next || n + 1 == yarn.first + yarn.count) {
                const float step = std::min(node[3] - next + kStep * diameter, 4 * kStep * diameter);
                places.push_back({Vec3f::Map(node.data()), node[3],
                                  std::max(0.0F, step) * diameter / std::numbers::pi_v<float>, y,
                                  static_cast<std::uint32_t>(n)});
                next = node[3] + kStep * diameter;
            }
        }
    }
    return places;
}

/// Straight between the places that were looked at.
void fillBetween(const std::vector<Place>& places, const SceneFrame& frame, std::vector<HiddenSky>& hidden) {
    std::vector<std::uint32_t> looked;
    looked.reserve(places.size());
    for (const Place& place : places) {
        looked.push_back(place.node);
    }
    std::ranges::sort(looked);
    for (std::size_t i = 0; i + 1 < looked.size(); ++i) {
        const std::uint32_t from = looked[i];
        const std::uint32_t to = looked[i + 1];
        const float start = frame.nodes[from][3];
        const float length = frame.nodes[to][3] - start;
        for (std::uint32_t n = from + 1; n < to && length > 0; ++n) {
            const float share = (frame.nodes[n][3] - start) / length;
            hidden[n] = {(1 - share) * hidden[from].all + share * hidden[to].all,
                         (1 - share) * hidden[from].way + share * hidden[to].way};
        }
    }
}

/// Three times the way and once all, see nodes.glsl.
std::array<std::uint8_t, 4> packed(const HiddenSky& hidden) {
    const auto byte = [](float share) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(share, 0.0F, 1.0F) * 254));
    };
    const Vec3f way = (0.5F * hidden.way / kMostWay).array() + 0.5F;
    return {byte(way.x()), byte(way.y()), byte(way.z()), byte(hidden.all / kMostAll)};
}

} // namespace

std::vector<HiddenSky> hiddenSky(const SceneFrame& frame) {
    std::vector<HiddenSky> hidden(frame.nodes.size());
    std::vector<Place> places = placesOf(frame);
    std::erase_if(places, [](const Place& place) { return !place.at.allFinite(); });
    if (places.empty()) {
        return hidden;
    }
    float widest = 1e-3F;
    for (const geometry::YarnCurves::Range& yarn : frame.topology->yarns) {
        widest = std::max(widest, frame.diameters[yarn.carrier]);
    }
    const float reach = kReach * widest;
    const float nearest = 0.5F * widest * widest;
    Grid(places, reach).forEachPair([&](std::size_t i, std::size_t k) {
        const Place& a = places[i];
        const Place& b = places[k];
        const Vec3f way = b.at - a.at;
        const float square = way.squaredNorm();
        const bool own = a.yarn == b.yarn && std::abs(a.arc - b.arc) < reach;
        if (square >= reach * reach || own) {
            return;
        }
        const float fade = 1 - square / (reach * reach);
        const float much = fade * fade / std::max(square, nearest);
        const Vec3f unit = way / std::sqrt(std::max(square, 1e-12F));
        hidden[a.node].all += much * b.size;
        hidden[a.node].way += much * b.size * unit;
        hidden[b.node].all += much * a.size;
        hidden[b.node].way -= much * a.size * unit;
    });
    fillBetween(places, frame, hidden);
    return hidden;
}

void addHidden(SceneFrame& frame) {
    const HiddenSky usual{2, Vec3f::Zero()};
    frame.hidden.assign(frame.nodes.size(), packed(usual));
    if (frame.nodes.size() <= kMostShaded) {
        std::ranges::transform(hiddenSky(frame), frame.hidden.begin(), packed);
    }
}

} // namespace knittsim::render
