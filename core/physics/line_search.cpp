#include "core/physics/line_search.h"

#include "core/physics/integrator.h"

#include <algorithm>
#include <cmath>

namespace knittsim::physics {

namespace {
constexpr int kMostTrials = 20;
constexpr double kArmijo = 1e-4;
constexpr double kRounding = 1e-13; // relative error of an energy
} // namespace

bool LineSearch::accepts(double length, double slope) const {
    if (!std::isfinite(m_trialEnergy)) {
        return false;
    }
    if (m_trialEnergy <= m_energy + kArmijo * length * slope) {
        return true;
    }
    return m_trialEnergy <= m_energy + kRounding * std::abs(m_energy) &&
           m_trialGradient.squaredNorm() < m_gradient.squaredNorm();
}

bool LineSearch::run(const Vector& move, double longest, const Interrupt& interrupt) {
    // What is shortened here and there may no longer go downhill.
    Vector allowed = longest * move;
    m_model.shorten(m_x, allowed, kLargestDistortion);
    double slope = m_gradient.dot(allowed);
    if (!(slope < 0)) {
        allowed = longest * move;
        allowed *= m_model.allowedStep(m_x, allowed, kLargestDistortion);
        slope = m_gradient.dot(allowed);
    }
    if (!(slope < 0)) {
        return false;
    }
    double length = 1;
    for (int trial = 0; trial < kMostTrials; ++trial, length *= 0.5) {
        interrupt.check();
        m_trial = m_x + length * allowed;
        m_trialEnergy = m_model.evaluate(m_trial, &m_trialGradient);
        ++m_evaluations;
        if (accepts(length, slope)) {
            return true;
        }
    }
    return false;
}

} // namespace knittsim::physics
