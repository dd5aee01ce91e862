#include "core/physics/yarn_model/contact_kernel.h"

#include <cmath>

namespace knittsim::physics {

ContactKernel::ContactKernel(double core, double outer, double stiffness)
    : m_core(core), m_shell(outer - core), m_stiffness(stiffness), m_least(inside(kLeast)) {}

ContactKernel::Value ContactKernel::inside(double z) const {
    constexpr double p = kExponent;
    const double power = std::pow(z, -p);
    const double scale = m_stiffness * m_shell / p;
    return {scale * m_shell / (p - 1) * (power * z - 1 + (1 - p) * (1 - z)), scale * (1 - power),
            m_stiffness * power / z};
}

ContactKernel::Value ContactKernel::at(double distance) const {
    const double z = (distance - m_core) / m_shell;
    if (z >= 1) {
        return {};
    }
    if (z >= kLeast) {
        return inside(z);
    }
    const double deeper = (z - kLeast) * m_shell;
    return {m_least.energy + deeper * (m_least.slope + 0.5 * deeper * m_least.curvature),
            m_least.slope + deeper * m_least.curvature, m_least.curvature};
}

} // namespace knittsim::physics
