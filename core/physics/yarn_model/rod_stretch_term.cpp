#include "core/physics/yarn_model/rod_stretch_term.h"

#include <algorithm>

namespace knittsim::physics {

namespace {
constexpr double kTiny = 1e-12; // below, a segment has no direction
}

RodStretchTerm::RodStretchTerm(const YarnChains& chains) : m_hessian(chains.cellEntry()) {
    for (const Chain& c : chains.chains) {
        const RodYarn& yarn = chains.yarns[static_cast<std::size_t>(c.yarn)];
        for (Entry i = 0; i < c.segmentCount(); ++i) {
            const double rest = chains.restLength[static_cast<std::size_t>(c.first + i)];
            m_segments.push_back({{{c.place(i), c.place(i + 1)}, {-1, 1}}, rest, yarn.axialStiffness / rest});
        }
    }
}

double RodStretchTerm::evaluate(const Vector& x, Vector* gradient) const {
    double energy = 0;
    for (const Segment& s : m_segments) {
        const Eigen::Vector3d e = s.ends.of(x, m_hessian.cell());
        const double length = e.norm();
        const double excess = length - s.rest;
        energy += 0.5 * s.stiffness * excess * excess;
        if (gradient != nullptr && length > kTiny) {
            s.ends.spread((s.stiffness * excess / length) * e, *gradient, m_hessian.cell());
        }
    }
    return energy;
}

void RodStretchTerm::linearise(const Vector& x) {
    m_hessian.parts().clear();
    m_hessian.parts().reserve(m_segments.size());
    for (const Segment& s : m_segments) {
        const Eigen::Vector3d e = s.ends.of(x, m_hessian.cell());
        const double length = e.norm();
        if (length <= kTiny) {
            m_hessian.parts().push_back({s.ends, s.stiffness * Matrix3::Identity()});
            continue;
        }
        const Eigen::Vector3d t = e / length;
        const double across = std::max(0.0, s.stiffness * (1 - s.rest / length));
        m_hessian.parts().push_back(
            {s.ends, across * Matrix3::Identity() + (s.stiffness - across) * t * t.transpose()});
    }
}

std::vector<double> RodStretchTerm::tensions(const Vector& x) const {
    std::vector<double> result;
    result.reserve(m_segments.size());
    for (const Segment& s : m_segments) {
        result.push_back(s.stiffness * (s.ends.of(x, m_hessian.cell()).norm() - s.rest));
    }
    return result;
}

} // namespace knittsim::physics
