#include "core/geometry/topology_certificate.h"

#include "core/geometry/strand_order.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace knittsim::geometry {

namespace {

using fabric::PointIndex;
using machine::LoopIndex;

/// Nodes [first, last] of a loop's legs and head; `middle` is the first of its second half.
struct Nodes {
    std::int32_t first = -1;
    std::int32_t middle = -1;
    std::int32_t last = -1;
    std::int32_t footFirst = -1; ///< first ones of its feet
    std::int32_t footLast = -1;
    std::int32_t spanFirst = -1; ///< of the part that is closed with a chord
    std::int32_t spanLast = -1;
};

/// Does the segment cross the triangle? +1 along the normal (b - a) x (c - a), -1 against it, 0 not.
int pierce(const Vec3& from, const Vec3& to, const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto volume = [](const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
        return (q - p).cross(r - p).dot(s - p);
    };
    const double below = volume(a, b, c, from);
    const double above = volume(a, b, c, to);
    if ((below > 0) == (above > 0)) {
        return 0;
    }
    const bool u = volume(from, to, a, b) > 0;
    const bool v = volume(from, to, b, c) > 0;
    const bool w = volume(from, to, c, a) > 0;
    if (u != v || v != w) {
        return 0;
    }
    return above > 0 ? 1 : -1;
}

class Certifier {
public:
    Certifier(const fabric::Fabric& fabric, const YarnCurves& curves)
        : m_fabric(fabric), m_curves(curves), m_nodes(fabric.loops.size()) {
        for (std::size_t n = 0; n < curves.piece.size(); ++n) {
            add(static_cast<std::int32_t>(n));
        }
        for (Nodes& nodes : m_nodes) {
            trim(nodes);
        }
    }

    TopologyCertificate run() const {
        TopologyCertificate certificate;
        for (std::size_t i = 0; i < m_fabric.loops.size(); ++i) {
            if (m_fabric.loops[i].footLeft < 0) {
                continue;
            }
            const auto loop = static_cast<LoopIndex>(i);
            for (const LoopIndex parent : m_fabric.made.parentsOf(loop)) {
                ++certificate.pairs;
                const int sign = pullSign(m_fabric, loop);
                const PullThrough found = test(loop, parent);
                if (found.in != sign || found.out != -sign) {
                    certificate.failures.push_back(found);
                }
            }
        }
        return certificate;
    }

private:
    void add(std::int32_t node) {
        const PointIndex p = m_curves.piece[static_cast<std::size_t>(node)];
        const fabric::BondingPoint& point = m_fabric.points[static_cast<std::size_t>(p)];
        if (point.role == fabric::Role::Crossing && point.piece == fabric::Piece::Float) {
            return;
        }
        Nodes& nodes = m_nodes[static_cast<std::size_t>(point.loop)];
        nodes.first = nodes.first < 0 ? node : nodes.first;
        nodes.last = node;
        const fabric::Loop& loop = m_fabric.loops[static_cast<std::size_t>(point.loop)];
        const PointIndex at = m_curves.point[static_cast<std::size_t>(node)];
        if (nodes.footFirst < 0 && at == std::min(loop.footLeft, loop.footRight)) {
            nodes.footFirst = node;
        }
        if (nodes.footLast < 0 && at == std::max(loop.footLeft, loop.footRight)) {
            nodes.footLast = node;
        }
        if (nodes.middle < 0 && p >= std::max(loop.headLeft, loop.headRight)) {
            nodes.middle = node;
        }
    }

    /// The span of a loop ends at its legs: the yarn that turns or floats on from there does not belong to
    /// it, so that the longer half counts up to the length of the shorter one.
    void trim(Nodes& nodes) const {
        if (nodes.middle < 0) {
            return;
        }
        const auto arc = [&](std::int32_t n) { return m_curves.arc[static_cast<std::size_t>(n)]; };
        nodes.spanFirst = nodes.first;
        nodes.spanLast = nodes.last;
        const float leg = std::min(arc(nodes.middle) - arc(nodes.first), arc(nodes.last) - arc(nodes.middle));
        while (arc(nodes.middle) - arc(nodes.spanFirst) > leg) {
            ++nodes.spanFirst;
        }
        while (arc(nodes.spanLast) - arc(nodes.middle) > leg) {
            --nodes.spanLast;
        }
    }

    Vec3 at(std::int32_t node) const { return m_curves.nodes[static_cast<std::size_t>(node)].cast<double>(); }

    PullThrough test(LoopIndex loop, LoopIndex parent) const {
        const Nodes& own = m_nodes[static_cast<std::size_t>(loop)];
        const Nodes& old = m_nodes[static_cast<std::size_t>(parent)];
        PullThrough found{.loop = loop, .parent = parent};
        if (own.middle < 0 || old.middle < 0) {
            return found;
        }
        // Where a loop is twisted a fan can fold: another apex spans it as well. Where it has no feet the
        // yarn may turn up beside it, which does not belong to it. A yarn from bed to bed can come through
        // the fan before its own half of the sinker begins.
        const int sign = pullSign(m_fabric, loop);
        for (const Nodes& span : {old, shortened(old)}) {
            for (const Nodes& strands : {own, withSinkers(own)}) {
                for (const Vec3& apex : apexes(span)) {
                    count(found, strands, span, apex);
                    if (found.in == sign && found.out == -sign) {
                        return found;
                    }
                }
            }
        }
        return found;
    }

    std::array<Vec3, 4> apexes(const Nodes& span) const {
        Vec3 centre = Vec3::Zero();
        for (std::int32_t n = span.spanFirst; n <= span.spanLast; ++n) {
            centre += at(n);
        }
        centre /= static_cast<double>(span.spanLast - span.spanFirst + 1);
        const Vec3 chord = 0.5 * (at(span.spanFirst) + at(span.spanLast));
        const Vec3 head = at(span.middle);
        return {centre, 0.5 * (chord + head), chord, head};
    }

    Nodes shortened(const Nodes& loop) const {
        Nodes shorter = loop;
        shorter.spanFirst += (loop.middle - loop.spanFirst) / 4;
        shorter.spanLast -= (loop.spanLast - loop.middle) / 4;
        return shorter;
    }

    /// With the whole sinkers, as far as its own halves tell how long they are.
    Nodes withSinkers(const Nodes& loop) const {
        const YarnCurves::Range& yarn = m_curves.yarns[yarnAt(m_curves, loop.first)];
        Nodes longer = loop;
        if (loop.footFirst >= 0 && loop.footLast >= 0) {
            longer.first = std::max(yarn.first, loop.first - (loop.footFirst - loop.first));
            longer.last = std::min(yarn.first + yarn.count - 1, loop.last + (loop.last - loop.footLast));
        }
        return longer;
    }

    void count(PullThrough& found, const Nodes& own, const Nodes& old, const Vec3& apex) const {
        // The fan turns clockwise seen from the front when the yarn ran rightward.
        const bool rightward = m_fabric.made.loops[static_cast<std::size_t>(found.parent)].direction ==
                               machine::Direction::Right;
        const int front = rightward ? -1 : 1;
        found.in = found.out = 0;
        for (std::int32_t n = own.first; n < own.last; ++n) {
            int& sum = n + 1 < own.middle ? found.in : found.out;
            for (std::int32_t k = old.spanFirst; k <= old.spanLast; ++k) {
                const Vec3 next = k == old.spanLast ? at(old.spanFirst) : at(k + 1);
                sum += front * pierce(at(n), at(n + 1), apex, at(k), next);
            }
        }
    }

    const fabric::Fabric& m_fabric;
    const YarnCurves& m_curves;
    std::vector<Nodes> m_nodes; ///< by loop
};

} // namespace

TopologyCertificate certifyTopology(const fabric::Fabric& fabric, const YarnCurves& curves) {
    return Certifier(fabric, curves).run();
}

} // namespace knittsim::geometry
