#include "core/geometry/yarn_curve.h"

#include "core/geometry/spline.h"
#include "core/geometry/yarn_curve_builder.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace knittsim::geometry {

YarnCurveBuilder::YarnCurveBuilder(const fabric::Fabric& fabric, std::span<const double> diameterMm,
                                   const CurveOptions& options)
    : m_options(options), m_diameterMm(diameterMm.begin(), diameterMm.end()), m_frames(fabric),
      m_plan(fabric, diameterMm) {
    const int samples = std::clamp(options.samplesPerSegment, 1, 32);
    for (int i = 0; i < samples; ++i) {
        m_weights.push_back(splineWeights(static_cast<float>(i) / static_cast<float>(samples)));
    }
    m_nodeOfControl.assign(m_plan.pointOfControl().size(), -1);
    std::int32_t node = 0;
    for (const CurvePlan::YarnRange& yarn : m_plan.yarns()) {
        m_curves.yarns.push_back({node, (yarn.count - 1) * samples + 1, yarn.carrier});
        for (std::int32_t i = 0; i < yarn.count; ++i) {
            const auto control = static_cast<std::size_t>(yarn.first + i);
            m_nodeOfControl[control] = node;
            const int own = i + 1 < yarn.count ? samples : 1;
            m_curves.point.insert(m_curves.point.end(), static_cast<std::size_t>(own),
                                  m_plan.pointOfControl()[control]);
            m_curves.piece.insert(m_curves.piece.end(), static_cast<std::size_t>(own),
                                  m_plan.pieceOfControl()[control]);
            node += own;
        }
    }
    const auto nodes = static_cast<std::size_t>(node);
    m_curves.nodes.resize(nodes);
    m_curves.arc.resize(nodes);
    if (options.withSurface) {
        m_curves.normal.resize(nodes);
        m_curves.height.resize(nodes);
    }
}

const YarnCurves& YarnCurveBuilder::update(std::span<const float> positions) {
    if (m_options.withSurface) {
        m_frames.updateWithRelief(positions);
    } else {
        m_frames.update(positions);
    }
    m_plan.place(m_frames, m_controls);
    for (const CurvePlan::YarnRange& yarn : m_plan.yarns()) {
        sample(static_cast<std::size_t>(yarn.first), static_cast<std::size_t>(yarn.first + yarn.count - 1));
    }
    measureArc();
    return m_curves;
}

void YarnCurveBuilder::sample(std::size_t firstControl, std::size_t lastControl) {
    ControlValue value{};
    const auto store = [&](std::size_t node) {
        m_curves.nodes[node] = {value[0], value[1], value[2]};
        if (m_options.withSurface) {
            m_curves.height[node] = value[3];
            m_curves.normal[node] = {value[4], value[5], value[6]};
        }
    };
    for (std::size_t control = firstControl; control < lastControl; ++control) {
        const ControlValue* p = &m_controls[control - 1];
        auto node = static_cast<std::size_t>(m_nodeOfControl[control]);
        for (const std::array<float, 4>& w : m_weights) {
            for (std::size_t c = 0; c < value.size(); ++c) {
                value[c] = w[0] * p[0][c] + w[1] * p[1][c] + w[2] * p[2][c] + w[3] * p[3][c];
            }
            store(node++);
        }
    }
    value = m_controls[lastControl];
    store(static_cast<std::size_t>(m_nodeOfControl[lastControl]));
}

void YarnCurveBuilder::measureArc() {
    for (const YarnCurves::Range& yarn : m_curves.yarns) {
        const auto first = static_cast<std::size_t>(yarn.first);
        const std::size_t end = first + static_cast<std::size_t>(yarn.count);
        m_curves.arc[first] = 0;
        for (std::size_t i = first + 1; i < end; ++i) {
            m_curves.arc[i] = (m_curves.nodes[i] - m_curves.nodes[i - 1]).norm();
        }
        // Summed in double: yarns are long and their pieces short.
        double arc = 0;
        for (std::size_t i = first + 1; i < end; ++i) {
            arc += static_cast<double>(m_curves.arc[i]);
            m_curves.arc[i] = static_cast<float>(arc);
        }
    }
}

std::size_t yarnAt(const YarnCurves& curves, std::int32_t node) {
    const auto after = std::ranges::upper_bound(curves.yarns, node, {}, &YarnCurves::Range::first);
    return static_cast<std::size_t>(after - curves.yarns.begin()) - 1;
}

std::vector<YarnPiece> yarnPieces(const fabric::Fabric& fabric, const YarnCurves& curves) {
    std::vector<YarnPiece> pieces;
    for (const YarnCurves::Range& yarn : curves.yarns) {
        std::int32_t begin = -1;
        fabric::PointIndex before = -1;
        double stored = 0;
        for (std::int32_t n = yarn.first; n < yarn.first + yarn.count; ++n) {
            const fabric::PointIndex p = curves.point[static_cast<std::size_t>(n)];
            if (p == before) {
                continue;
            }
            stored += before < 0 ? 0 : fabric.lengths[static_cast<std::size_t>(before)];
            before = p;
            if (fabric.points[static_cast<std::size_t>(p)].role != fabric::Role::Crossing) {
                if (begin >= 0) {
                    pieces.push_back({begin, n, static_cast<float>(stored)});
                }
                begin = n;
                stored = 0;
            }
        }
    }
    return pieces;
}

std::vector<double> spanLengths(const YarnCurves& curves) {
    std::vector<double> length;
    for (const YarnCurves::Range& yarn : curves.yarns) {
        for (std::int32_t n = yarn.first; n + 1 < yarn.first + yarn.count; ++n) {
            const auto i = static_cast<std::size_t>(n);
            const auto point = static_cast<std::size_t>(curves.point[i]);
            length.resize(std::max(length.size(), point + 1), 0);
            length[point] += static_cast<double>(curves.arc[i + 1] - curves.arc[i]);
        }
    }
    return length;
}

YarnCurves buildYarnCurves(const fabric::Fabric& fabric, std::span<const float> positions,
                           std::span<const double> diameterMm, const CurveOptions& options) {
    YarnCurveBuilder builder(fabric, diameterMm, options);
    if (options.exact) {
        builder.makeExact(fabric, positions);
    } else {
        builder.update(positions);
    }
    return builder.curves();
}

} // namespace knittsim::geometry
