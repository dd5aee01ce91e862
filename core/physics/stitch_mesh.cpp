#include "core/physics/stitch_mesh.h"

#include <algorithm>

namespace knittsim::physics {

using fabric::BondingPoint;
using fabric::Fabric;
using fabric::LoopIndex;
using fabric::PointIndex;
using fabric::Role;
using fabric::Side;

namespace {

/// A float slides through its crossings, so it must not be held at equal shares of its length; this much
/// keeps a crossing of slack floats in their line.
constexpr double kSlidingShare = 0.02;

class Finder {
public:
    Finder(const Fabric& f, const Strands& strands, std::span<const yarn::Yarn> yarns,
           const PreviewOptions& options)
        : m_fabric(f), m_strands(strands), m_yarns(yarns), m_options(options) {}

    StitchMesh run() {
        for (std::size_t p = 0; p < m_fabric.points.size(); ++p) {
            const auto point = static_cast<PointIndex>(p);
            if (m_fabric.points[p].role == Role::Foot) {
                joinAt(point);
            } else if (m_fabric.points[p].role == Role::Head) {
                bareHead(point);
            }
        }
        for (const Strand& s : m_strands.all) {
            strandThroughCrossings(s);
        }
        return std::move(m_mesh);
    }

private:
    /// A strand seen from one of its ends.
    struct Arm {
        Entry end = -1;
        double rest = 1;
        double arc = 1;
        double bending = 0; ///< EI, mN mm^2
        bool there = false;
    };

    const BondingPoint& point(PointIndex p) const { return m_fabric.points[static_cast<std::size_t>(p)]; }
    const Strand& strand(std::int32_t s) const { return m_strands.all[static_cast<std::size_t>(s)]; }

    double bending(const Strand& s) const {
        return s.carrier < m_yarns.size() ? m_yarns[s.carrier].bendingStiffness
                                          : yarn::Yarn{}.bendingStiffness;
    }

    Arm arm(std::int32_t s, PointIndex from) const {
        if (s < 0 || strand(s).kind == Strand::Kind::Float || strand(s).rest <= 0) {
            return {};
        }
        const Entry end = point(m_strands.across(s, from)).entry;
        return {end, strand(s).rest, strand(s).length, bending(strand(s)), end != point(from).entry};
    }

    Arm legArm(PointIndex p) const { return arm(m_strands.legAt(p), p); }
    Arm sideArm(PointIndex p) const { return arm(m_strands.otherAt(p), p); }

    static double stiffness(double factor, const Arm& a, const Arm& b) {
        return factor * (a.bending + b.bending) / (a.arc + b.arc);
    }

    void runOn(Entry middle, const Arm& a, const Arm& b) {
        if (a.there && b.there && a.end != b.end) {
            m_mesh.straights.push_back(
                {a.end, middle, b.end, a.rest, b.rest, stiffness(m_options.bendStiffness, a, b)});
        }
    }

    void standAcross(Entry corner, const Arm& a, const Arm& b) {
        if (a.there && b.there && a.end != b.end) {
            m_mesh.corners.push_back(
                {corner, a.end, b.end, a.rest, b.rest, stiffness(m_options.shearStiffness, a, b)});
        }
    }

    /// A foot and every head it shares its place with.
    void joinAt(PointIndex foot) {
        const Entry entry = point(foot).entry;
        const Arm up = legArm(foot);
        const Arm sinker = sideArm(foot);
        standAcross(entry, sinker, up);
        for (const PointIndex head : m_fabric.at(entry)) {
            if (point(head).role != Role::Head) {
                continue;
            }
            const Arm down = legArm(head);
            const Arm heads = sideArm(head);
            runOn(entry, down, up);
            standAcross(entry, heads, down.there ? down : up);
            const double turn = curlAt(foot, head);
            if (turn != 0 && heads.there && sinker.there && up.there) {
                m_mesh.curls.push_back({heads.end, entry, sinker.end, up.end, heads.rest, sinker.rest,
                                        up.rest, turn, stiffness(m_options.bendStiffness, heads, sinker)});
            } else {
                runOn(entry, heads, sinker);
            }
        }
    }

    void bareHead(PointIndex head) {
        if (loopThrough(m_fabric, head) < 0) {
            standAcross(point(head).entry, sideArm(head), legArm(head));
        }
    }

    /// The face of the loop across the sinker of this foot, 0 where there is none.
    int faceBeside(PointIndex foot) const {
        const std::int32_t s = foot < 0 ? -1 : m_strands.otherAt(foot);
        if (s < 0 || strand(s).kind != Strand::Kind::Sinker) {
            return 0;
        }
        return faceOf(m_fabric, point(m_strands.across(s, foot)).loop);
    }

    /// Turn of the course from the heads below to the sinker at `foot`, in the sense of Curl::turn.
    double curlAt(PointIndex foot, PointIndex head) const {
        const LoopIndex index = point(foot).loop;
        const int face = faceOf(m_fabric, index);
        if (faceOf(m_fabric, point(head).loop) != face) {
            return 0;
        }
        const fabric::Loop& loop = m_fabric.loops[static_cast<std::size_t>(index)];
        const bool left = point(foot).side == Side::Left;
        const int here = faceBeside(foot);
        const int there = faceBeside(left ? loop.footRight : loop.footLeft);
        if (here != -face && there != -face) {
            return 0;
        }
        const double angle = here == -face ? kCurlTowardsOther : kCurlTowardsSame;
        // t x u points to the front on the right side of a loop, to the rear on the left one.
        return (left ? 1.0 : -1.0) * face * angle;
    }

    void strandThroughCrossings(const Strand& s) {
        for (PointIndex p = s.first + 1; p < s.last; ++p) {
            const Entry before = point(p - 1).entry;
            const Entry middle = point(p).entry;
            const Entry after = point(p + 1).entry;
            const double restBefore = restOf(s, p - 1);
            const double restAfter = restOf(s, p);
            if (before != middle && middle != after && before != after) {
                const double share = s.kind == Strand::Kind::Float ? kSlidingShare : 1;
                const double b = share * m_options.bendStiffness * bending(s) / s.length;
                m_mesh.straights.push_back({before, middle, after, restBefore, restAfter, b});
            }
        }
    }

    double restOf(const Strand& s, PointIndex p) const {
        const double share = m_fabric.lengths[static_cast<std::size_t>(p)] / std::max(s.length, 1e-9);
        return std::max(share, 0.02) * s.rest;
    }

    const Fabric& m_fabric;
    const Strands& m_strands;
    std::span<const yarn::Yarn> m_yarns;
    const PreviewOptions& m_options;
    StitchMesh m_mesh;
};

} // namespace

StitchMesh findStitchMesh(const Fabric& fabric, const Strands& strands, std::span<const yarn::Yarn> yarns,
                          const PreviewOptions& options) {
    return Finder(fabric, strands, yarns, options).run();
}

} // namespace knittsim::physics
