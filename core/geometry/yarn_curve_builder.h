#pragma once

#include "core/geometry/curve_plan.h"
#include "core/geometry/frame_field.h"
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

    const YarnCurves& curves() const { return m_curves; }
    const FrameField& frames() const { return m_frames; }

private:
    void sample(std::size_t firstControl, std::size_t lastControl);
    void measureArc();

    CurveOptions m_options;
    FrameField m_frames;
    CurvePlan m_plan;
    std::vector<ControlValue> m_controls;
    std::vector<std::int32_t>
        m_nodeOfControl; ///< first node of the span that begins at a control, -1 for none
    std::vector<std::array<float, 4>> m_weights; ///< by sample of a span
    YarnCurves m_curves;
};

} // namespace knittsim::geometry
