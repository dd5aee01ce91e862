#pragma once

namespace knittsim::physics {

/// Energy density of two pieces of yarn at a distance, per length of both (soft shell and hard core of
/// PHYSICS-REFERENCE 2.4): with z = (distance - core) / shell and shell = outer - core
///
///   v = k shell^2 / (p (p - 1)) (z^(1-p) - 1 + (1-p)(1-z))   for z < 1, 0 beyond,
///
/// so v'' = k z^(-p-1). Below z = kLeast it goes on as a parabola.
class ContactKernel {
public:
    static constexpr double kExponent = 2.4; ///< p
    static constexpr double kLeast = 1e-2;

    /// Mean core and outer diameter of the two yarns, and k.
    ContactKernel(double core, double outer, double stiffness);

    double reach() const { return m_core + m_shell; }

    struct Value {
        double energy = 0;
        double slope = 0;     ///< d energy / d distance, <= 0
        double curvature = 0; ///< >= 0
    };
    Value at(double distance) const;

private:
    Value inside(double z) const;

    double m_core;
    double m_shell;
    double m_stiffness;
    Value m_least; ///< at z = kLeast
};

} // namespace knittsim::physics
