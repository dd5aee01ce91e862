#include "core/geometry/depth_fit.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace knittsim::geometry {

namespace {

constexpr int kRounds = 60;
constexpr float kEnough = 0.02F;     ///< of the least depth between strands, may be missing
constexpr float kLeastSlope = 0.02F; ///< keeps a flat piece from leaping
constexpr float kLongestMove = 0.1F; ///< of a piece's length, in one round

std::size_t at(std::int32_t i) {
    return static_cast<std::size_t>(i);
}

} // namespace

DepthFit::DepthFit(std::vector<Spline> splines, std::span<const std::array<float, 4>> weights,
                   std::span<const Vec3f> nodes)
    : m_splines(std::move(splines)), m_weights(weights.begin(), weights.end()),
      m_nodes(nodes.begin(), nodes.end()) {
    const std::size_t controls =
        m_splines.empty() ? 0 : at(m_splines.back().firstControl + m_splines.back().count) + 1;
    m_movedAt.assign(controls + 2, 0);
}

DepthFit::Place DepthFit::placeOf(std::int32_t node) const {
    const auto after = std::ranges::upper_bound(m_splines, node, {}, &Spline::firstNode);
    const Spline& spline = *(after - 1);
    const std::int32_t samples = static_cast<std::int32_t>(m_weights.size());
    const std::int32_t within = node - spline.firstNode;
    return {spline.firstControl + within / samples, within % samples, &spline};
}

void DepthFit::run(std::span<const YarnPiece> pieces, std::span<const Order> orders, float tolerance) {
    std::vector<YarnPiece> able;
    std::ranges::copy_if(pieces, std::back_inserter(able),
                         [&](const YarnPiece& p) { return canBeAsLong(p); });
    std::vector<std::uint64_t> seenPiece(able.size(), 0);
    std::vector<std::uint64_t> seenOrder(orders.size(), 0);
    const auto stretchAll = [&] {
        bool right = true;
        for (std::size_t i = 0; i < able.size(); ++i) {
            if (hasMoved(able[i].firstNode, able[i].lastNode, seenPiece[i])) {
                const bool fits = stretch(able[i], tolerance);
                seenPiece[i] = fits ? m_clock : 0;
                right = right && fits;
            }
        }
        return right;
    };
    const auto partAll = [&] {
        bool right = true;
        for (std::size_t i = 0; i < orders.size(); ++i) {
            const Order& order = orders[i];
            if (hasMoved(order.front, order.front + 1, seenOrder[i]) ||
                hasMoved(order.behind, order.behind + 1, seenOrder[i])) {
                const bool apart = part(order);
                seenOrder[i] = apart ? m_clock : 0;
                right = right && apart;
            }
        }
        return right;
    };
    for (int round = 0; round < kRounds && !able.empty(); ++round) {
        const bool fit = stretchAll();
        if (partAll() && fit) {
            return;
        }
    }
    for (int round = 0; round < kRounds && !partAll(); ++round) {
    }
}

/// Whether a control point has moved since `seen` that the nodes follow.
bool DepthFit::hasMoved(std::int32_t firstNode, std::int32_t lastNode, std::uint64_t seen) const {
    if (seen == 0) {
        return true;
    }
    const Place first = placeOf(firstNode);
    const auto samples = static_cast<std::int32_t>(m_weights.size());
    const std::int32_t end = first.control + (first.sample + lastNode - firstNode) / samples + 3;
    for (std::int32_t c = first.control - 1; c < end; ++c) {
        if (m_movedAt[at(c)] > seen) {
            return true;
        }
    }
    return false;
}

/// Its projection is not too long already.
bool DepthFit::canBeAsLong(const YarnPiece& piece) const {
    float flat = 0;
    for (std::int32_t n = piece.firstNode; n < piece.lastNode; ++n) {
        flat += (m_nodes[at(n + 1)] - m_nodes[at(n)]).head<2>().norm();
    }
    return flat < piece.storedMm;
}

/// Moves the control points of a piece along the slope of its length. Says whether it was right before.
bool DepthFit::stretch(const YarnPiece& piece, float tolerance) {
    const Place first = placeOf(piece.firstNode);
    const auto samples = static_cast<std::int32_t>(m_weights.size());
    m_slope.assign(at((first.sample + piece.lastNode - piece.firstNode) / samples) + 4, 0);
    const auto add = [&](std::int32_t node, float slope) {
        const std::int32_t within = first.sample + node - piece.firstNode;
        const std::array<float, 4>& w = m_weights[at(within % samples)];
        for (std::size_t k = 0; k < w.size(); ++k) {
            m_slope[at(within / samples) + k] += slope * w[k];
        }
    };
    float length = 0;
    for (std::int32_t n = piece.firstNode; n < piece.lastNode; ++n) {
        const Vec3f way = m_nodes[at(n + 1)] - m_nodes[at(n)];
        const float step = way.norm();
        length += step;
        if (step > 0) {
            add(n, -way.z() / step);
            add(n + 1, way.z() / step);
        }
    }
    const float missing = piece.storedMm - length;
    if (std::abs(missing) <= tolerance * piece.storedMm) {
        return true;
    }
    float squares = kLeastSlope;
    for (const float slope : m_slope) {
        squares += slope * slope;
    }
    const float most = kLongestMove * piece.storedMm;
    for (std::size_t k = 0; k < m_slope.size(); ++k) {
        move(*first.spline, first.control - 1 + static_cast<std::int32_t>(k),
             std::clamp(missing / squares * m_slope[k], -most, most));
    }
    return false;
}

/// Says whether the strands were far enough apart before.
bool DepthFit::part(const Order& order) {
    const auto depth = [&](std::int32_t node, float share) {
        return (1 - share) * m_nodes[at(node)].z() + share * m_nodes[at(node) + 1].z();
    };
    const float missing =
        order.leastMm - depth(order.front, order.frontShare) + depth(order.behind, order.behindShare);
    if (missing <= kEnough * order.leastMm) {
        return true;
    }
    push(order.front, order.frontShare, 0.5F * missing);
    push(order.behind, order.behindShare, -0.5F * missing);
    return false;
}

/// Moves the place after a node by about `by`.
void DepthFit::push(std::int32_t node, float share, float by) {
    const Place place = placeOf(node);
    const auto samples = static_cast<std::int32_t>(m_weights.size());
    std::array<float, 5> weights{};
    for (const auto& [within, part] : {std::pair{place.sample, 1 - share}, {place.sample + 1, share}}) {
        const std::array<float, 4>& w = m_weights[at(within % samples)];
        for (std::size_t k = 0; k < w.size(); ++k) {
            weights[at(within / samples) + k] += part * w[k];
        }
    }
    float squares = 0;
    for (const float w : weights) {
        squares += w * w;
    }
    for (std::size_t k = 0; k < weights.size(); ++k) {
        move(*place.spline, place.control - 1 + static_cast<std::int32_t>(k), by * weights[k] / squares);
    }
}

/// The control points that mirror the ends stay.
void DepthFit::move(const Spline& spline, std::int32_t control, float by) {
    const std::int32_t within = control - spline.firstControl;
    if (by == 0 || within < 0 || within >= spline.count) {
        return;
    }
    m_movedAt[at(control)] = ++m_clock;
    const auto samples = static_cast<std::int32_t>(m_weights.size());
    for (std::int32_t k = 0; k < 4; ++k) {
        // The nodes that begin two control points before it follow it with the last weight.
        const std::int32_t begins = within - 2 + k;
        if (begins < 0 || begins + 1 >= spline.count) {
            continue;
        }
        const std::int32_t node = spline.firstNode + begins * samples;
        for (std::int32_t i = 0; i < samples; ++i) {
            m_nodes[at(node + i)].z() += by * m_weights[at(i)][at(3 - k)];
        }
    }
    if (within + 1 == spline.count) {
        m_nodes[at(spline.firstNode + within * samples)].z() += by;
    }
}

} // namespace knittsim::geometry
