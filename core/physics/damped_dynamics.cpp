#include "core/physics/damped_dynamics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knittsim::physics {

namespace {

constexpr int kPowerIterations = 20;

Vector byCoordinate(const Vector& byEntry) {
    Vector result(3 * byEntry.size());
    for (Eigen::Index e = 0; e < byEntry.size(); ++e) {
        result.segment<3>(3 * e).setConstant(byEntry[e]);
    }
    return result;
}

} // namespace

void DampedDynamics::attach(System& model, const Motion& motion, const std::optional<Damping>& damping) {
    m_model = &model;
    m_model->linearise(motion.positions);
    m_inverseMass = byCoordinate(model.mass()).cwiseInverse();
    m_frequency = highestFrequency();
    m_inverseMass /= m_frequency * m_frequency;
    m_massDamping = damping ? damping->massRate / m_frequency
                            : std::numbers::pi / std::sqrt(static_cast<double>(model.entryCount()));
    m_stiffnessDamping = damping ? damping->stiffnessTime * m_frequency : 1;
    m_stableStep = kStableStep;
    evaluations = 0;
}

void DampedDynamics::freeze(const Vector& x) {
    m_model->linearise(x);
    // m_inverseMass has 1/w^2 inside, so this is relative to w. Above 1 the damping grows with the square.
    const double ratio = highestFrequency();
    m_stableStep = kStableStep / std::max(ratio, ratio * ratio);
}

/// Power iteration for H x = w^2 M x from a start with all short waves in it; a few per cent are enough.
double DampedDynamics::highestFrequency() const {
    Vector v(m_model->size());
    for (Eigen::Index i = 0; i < v.size(); ++i) {
        v[i] = 1 + std::sin(1.7 * static_cast<double>(i) * static_cast<double>(i % 101));
    }
    Vector y;
    double square = 1;
    for (int i = 0; i < kPowerIterations; ++i) {
        v.normalize();
        m_model->multiply(v, y);
        v = m_inverseMass.cwiseProduct(y);
        square = v.norm();
    }
    return std::isfinite(square) && square > 0 ? 1.05 * std::sqrt(square) : 1;
}

void DampedDynamics::slope(Eigen::Ref<const Vector> y, Eigen::Ref<Vector> derivative) {
    const Eigen::Index n = m_model->size();
    m_first = y.head(n);
    m_second = y.tail(n);
    m_model->evaluate(m_first, &m_gradient);
    m_model->multiply(m_second, m_first);
    m_first = m_stiffnessDamping * m_first + m_gradient;
    m_model->mask(m_first);
    m_model->mask(m_second);
    derivative.head(n) = m_second;
    derivative.tail(n) = -m_inverseMass.cwiseProduct(m_first) - m_massDamping * m_second;
    evaluations += 2;
}

void DampedDynamics::jacobian(Eigen::Ref<const Vector> direction, Eigen::Ref<Vector> product) {
    const Eigen::Index n = m_model->size();
    m_second = direction.head(n) + m_stiffnessDamping * direction.tail(n);
    m_model->multiply(m_second, m_first);
    m_model->mask(m_first);
    m_second = direction.tail(n);
    m_model->mask(m_second);
    product.head(n) = m_second;
    product.tail(n) = -m_inverseMass.cwiseProduct(m_first) - m_massDamping * m_second;
    ++evaluations;
}

void DampedDynamics::pack(const Motion& motion, Eigen::Ref<Vector> y) const {
    y.head(m_model->size()) = motion.positions;
    y.tail(m_model->size()) = motion.velocities / m_frequency;
}

void DampedDynamics::unpack(Eigen::Ref<const Vector> y, Motion& motion) const {
    motion.positions = y.head(m_model->size());
    motion.velocities = m_frequency * y.tail(m_model->size());
}

StepReport DampedDynamics::report(const Motion& motion, const Vector& before, double scaledStep) {
    StepReport result;
    result.stepSize = scaledStep / m_frequency;
    result.potential = m_model->evaluate(motion.positions, &m_gradient);
    result.forceNorm = m_gradient.norm();
    for (Entry e = 0; e < m_model->entryCount(); ++e) {
        // kg mm^2/s^2 = 1e-6 J = uJ
        result.kinetic += 0.5 * m_model->mass()[e] * at(motion.velocities, e).squaredNorm();
    }
    result.largestMove = (motion.positions - before).cwiseAbs().maxCoeff();
    result.evaluations = evaluations + 1;
    evaluations = 0;
    return result;
}

} // namespace knittsim::physics
