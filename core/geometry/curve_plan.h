#pragma once

#include "core/geometry/frame_field.h"
#include "core/geometry/strand_order.h"

#include <array>

namespace knittsim::geometry {

/// A control point of a yarn's spline: place x y z, height over the fabric's surface, normal of the fabric,
/// unused.
using ControlValue = std::array<float, 8>;

/// Which control points the yarns of a fabric have and how each of them follows from the positions of the
/// entries. The curve is the uniform cubic B-spline of these points: it stays inside their hull, so offsets
/// are a little larger than what the curve itself shall reach.
///
/// A foot or head gives two points, at its lower and its upper crossing, with the strand's depth there; the
/// new loop runs inside its parents. Between the heads one point makes the arc, between feet one makes the
/// sinker, on a leg one makes the belly; how far they stand out follows from the yarn's stored length. Long
/// floats and legs get points near both ends and in the middle instead.
class CurvePlan {
public:
    CurvePlan(const fabric::Fabric& fabric, std::span<const double> diameterMm);

    /// An entry, or a place below it: the base of a leg that has no foot.
    struct Anchor {
        fabric::EntryIndex entry = 0;
        float drop = 0;                 ///< in rises
        fabric::EntryIndex beside = -1; ///< when given, as low as this entry, and then down by `drop`
        float acrossMm = 0;             ///< set off to the right
    };

    /// Two unused places enclose the points of each yarn.
    struct YarnRange {
        std::int32_t first = 0; ///< first control point
        std::int32_t count = 0;
        machine::CarrierIndex carrier = 0;
    };
    const std::vector<YarnRange>& yarns() const { return m_yarns; }

    /// By control point: bonding point at or before it; -1 for the two beyond the ends.
    const std::vector<fabric::PointIndex>& pointOfControl() const { return m_pointOfControl; }

    /// By control point: bonding point whose leg, float or half sinker begins there.
    const std::vector<fabric::PointIndex>& pieceOfControl() const { return m_pieceOfControl; }

    /// By control point: mm that it is raised along the normal of the fabric, besides what its place asks
    /// for.
    std::vector<float>& lift() { return m_lift; }

    /// Makes arcs stand out more or less, so that the yarn between bonding points comes nearer to its stored
    /// length. `lengthMm` by bonding point: of the curve from there to the next one at the shape of `frames`.
    void fitArcs(const FrameField& frames, std::span<const double> lengthMm);

    /// Makes all arcs stand out and all turns and floats hang as little as they may.
    void drawIn();

    /// Writes all control points, the two beyond the ends of each yarn included.
    void place(const FrameField& frames, std::vector<ControlValue>& controls) const;

private:
    friend class CurvePlanner;

    struct Arc;
    static float amplitude(const FrameField& frames, const Arc& arc, float slackMm);
    static float slack(const FrameField& frames, const Arc& arc);
    void placeCorners(const FrameField& frames, std::vector<ControlValue>& controls) const;
    void placeArcs(const FrameField& frames, std::vector<ControlValue>& controls) const;
    void placeReaches(const FrameField& frames, std::vector<ControlValue>& controls) const;

    static Vec3f placeOf(const FrameField& frames, const Anchor& anchor);

    /// On an anchor, set off by `across`, `along` and `out` mm, the first two less where the loops are small.
    struct Corner {
        std::int32_t control = 0;
        Anchor anchor;
        float across = 0;
        float along = 0;
        float out = 0;
    };
    /// Between two anchors, standing out to a side as far as slack yarn lets it.
    struct Arc {
        std::int32_t control = 0;
        Anchor from;
        Anchor to;
        float share = 0.5F; ///< place between them
        float storedMm = 0; ///< yarn between them
        float gain = 0;     ///< of the root of stored^2 - distance^2
        float leastMm = 0;
        float mostRise = 0;   ///< limit in rises
        float mostFitted = 0; ///< the limit when it was fitted, if that is wider
        float acrossSide = 0; ///< direction in which it stands out
        float alongSide = 0;
        float out = 0;
    };
    /// Near the first of two anchors that lie far apart.
    struct Reach {
        std::int32_t control = 0;
        Anchor near;
        Anchor far;
        float reachMm = 0;
        float dipMm = 0;
        float across = 0;
        float out = 0;
        float storedMm = 0;  ///< yarn that it is fitted to, 0 for none
        float tightest = 0;  ///< least tightness
        float tightness = 1; ///< factor on dip and across, as fitted
    };

    std::vector<YarnRange> m_yarns;
    std::vector<fabric::PointIndex> m_pointOfControl;
    std::vector<fabric::PointIndex> m_pieceOfControl;
    std::vector<float> m_lift;
    std::vector<Corner> m_corners;
    std::vector<Arc> m_arcs;
    std::vector<Reach> m_reaches;
};

} // namespace knittsim::geometry
