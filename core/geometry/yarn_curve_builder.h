#pragma once

#include "core/geometry/curve_plan.h"
#include "core/geometry/depth_fit.h"
#include "core/geometry/frame_field.h"
#include "core/geometry/projected_crossings.h"
#include "core/geometry/yarn_curve.h"

namespace knittsim::geometry {

/// Builds the curves of one fabric again and again, as its shape changes. All that follows from the topology
/// is worked out once; update() is linear in the number of nodes and allocates nothing after the first call.
/// One object may be used by one thread at a time.
class YarnCurveBuilder {
public:
    /// `fabric` is not kept. `diameterMm` by carrier.
    YarnCurveBuilder(const fabric::Fabric& fabric, std::span<const double> diameterMm,
                     const CurveOptions& options = {});

    /// Curves at `positions` (3 per entry, mm). Valid until the next call.
    const YarnCurves& update(std::span<const float> positions);

    /// Curves at `positions`, a shape that lies flat, such as the machine's, made exact: the yarn between
    /// feet and heads is as long as stored within 1 % where it has room; at every crossing of the projection
    /// the strand that the fabric's books name lies in front by at least an eighth of a diameter. Holds until
    /// the next update(). Returns the rounds that it took, -1 when some crossings stay wrong (see
    /// auditCrossings). Some tenths of a second for 10,000 loops.
    int makeExact(const fabric::Fabric& fabric, std::span<const float> positions);

    /// Draws the yarn in to the shortest way in the plane that this builder knows; later updates keep that.
    void drawIn() { m_plan.drawIn(); }

    /// Raises and lowers strands at crossings whose order is wrong at `positions`, a shape that lies flat;
    /// later updates keep that. Returns how many were wrong before.
    std::size_t orderStrands(const fabric::Fabric& fabric, std::span<const float> positions);

    const YarnCurves& curves() const { return m_curves; }
    const FrameField& frames() const { return m_frames; }

private:
    struct Orders {
        std::vector<DepthFit::Order> orders;
        std::size_t wrong = 0;
    };
    /// The crossings of the curves and what the books say of each, see CrossingAudit::order.
    struct Audited {
        std::vector<ProjectedCrossing> crossings;
        std::vector<std::int8_t> order;
    };
    Audited audit(const fabric::Fabric& fabric) const;
    std::vector<double> pieceLengths(const fabric::Fabric& fabric) const;
    int fitDepth(const fabric::Fabric& fabric, Audited audited);
    std::size_t raise(const Audited& audited);
    float wantedGap(const ProjectedCrossing& crossing) const;
    std::size_t controlAt(std::int32_t node) const;
    Orders ordersOf(const Audited& audited) const;
    std::vector<DepthFit::Spline> splines() const;
    float diameterAt(std::int32_t node) const;
    void sample(std::size_t firstControl, std::size_t lastControl);
    void measureArc();

    CurveOptions m_options;
    std::vector<double> m_diameterMm; ///< by carrier
    FrameField m_frames;
    CurvePlan m_plan;
    std::vector<ControlValue> m_controls;
    std::vector<std::int32_t>
        m_nodeOfControl; ///< first node of the span that begins at a control, -1 for none
    std::vector<std::array<float, 4>> m_weights; ///< by sample of a span
    YarnCurves m_curves;
};

} // namespace knittsim::geometry
