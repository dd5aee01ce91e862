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
    const double slope = m_gradient.dot(move);
    const double allowed = m_model.allowedStep(m_x, move, kLargestDistortion);
    if (!(slope < 0) || !(allowed > 0)) {
        return false;
    }
    double length = std::min(longest, allowed);
    for (int trial = 0; trial < kMostTrials; ++trial, length *= 0.5) {
        interrupt.check();
        m_trial = m_x + length * move;
        m_trialEnergy = m_model.evaluate(m_trial, &m_trialGradient);
        ++m_evaluations;
        if (accepts(length, slope)) {
            return true;
        }
    }
    return false;
}

} // namespace knittsim::physics
