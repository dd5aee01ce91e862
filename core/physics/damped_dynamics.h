#pragma once

#include "core/physics/integrator.h"
#include "core/physics/real_motion.h"

#include <optional>

namespace knittsim::physics {

/// The Euler-Lagrange equations of the fabric with damping, one second-order equation a coordinate (PHYSICS
/// 1):
///
///     M x'' = F(x) - b H x' - a M x'
///
/// w is the highest frequency of the net. For a fabric that is to come to rest, b = 1/w: damping in
/// proportion to the Hessian H calms the short waves, which the explicit methods could not follow otherwise;
/// a is chosen so that the longest wave is damped critically. Real motion has a Damping of its own.
///
/// Written as a first-order system in numbers of one size: time w t, unknowns y = (x, x'/w), all in mm.
/// H is that of the shape at the last `freeze`, so that y' is a smooth function of y between two of them.
class DampedDynamics {
public:
    /// Finds w for the shape of `motion`. Without `damping` that of a search for rest.
    void attach(System& model, const Motion& motion, const std::optional<Damping>& damping = std::nullopt);

    System& model() const { return *m_model; }
    double frequency() const { return m_frequency; }               ///< w, 1/s
    double massDamping() const { return m_massDamping; }           ///< a/w
    double stiffnessDamping() const { return m_stiffnessDamping; } ///< b w
    Eigen::Index size() const { return 2 * m_model->size(); }

    /// Renews H.
    void freeze(const Vector& x);

    /// Scaled time step below which an explicit method of order 5 is stable for the present H. Error control
    /// alone would let the shortest waves tremble at the limit and never come to rest.
    double stableStep() const { return m_stableStep; }

    /// y' at y; both of length size(). Counts evaluations.
    void slope(Eigen::Ref<const Vector> y, Eigen::Ref<Vector> derivative);

    /// Jacobian of `slope` times `direction`.
    void jacobian(Eigen::Ref<const Vector> direction, Eigen::Ref<Vector> product);

    void pack(const Motion& motion, Eigen::Ref<Vector> y) const;
    void unpack(Eigen::Ref<const Vector> y, Motion& motion) const;

    /// What a step that ended at `motion` achieved.
    StepReport report(const Motion& motion, const Vector& before, double scaledStep);

    int evaluations = 0; ///< of forces and Hessian products, since `report`

private:
    static constexpr double kStableStep = 2; ///< of the 3 or so that the methods bear

    double highestFrequency() const;

    System* m_model = nullptr;
    Vector m_inverseMass; ///< by coordinate, times 1/w^2
    double m_frequency = 1;
    double m_massDamping = 0;
    double m_stiffnessDamping = 1;
    double m_stableStep = kStableStep;
    Vector m_first, m_second, m_gradient;
};

} // namespace knittsim::physics
