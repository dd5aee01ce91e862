#pragma once

#include "core/physics/interrupt.h"
#include "core/physics/system.h"

namespace knittsim::physics {

/// Looks along a direction for a shape of less energy: first as far as kLargestDistortion allows, then by
/// halves (Armijo). Near rest, where energies differ by rounding only, a smaller force counts too.
class LineSearch {
public:
    LineSearch(const System& model, const Vector& x, double energy, const Vector& gradient)
        : m_model(model), m_x(x), m_energy(energy), m_gradient(gradient) {}

    /// Tries `longest` times `move` at most. False when nothing better was found.
    bool run(const Vector& move, double longest, const Interrupt& interrupt);

    const Vector& positions() const { return m_trial; }
    const Vector& gradient() const { return m_trialGradient; }
    double energy() const { return m_trialEnergy; }
    int evaluations() const { return m_evaluations; }

private:
    bool accepts(double length, double slope) const;

    const System& m_model;
    const Vector& m_x;
    double m_energy;
    const Vector& m_gradient;
    Vector m_trial;
    Vector m_trialGradient;
    double m_trialEnergy = 0;
    int m_evaluations = 0;
};

} // namespace knittsim::physics
