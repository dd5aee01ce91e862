#include "core/physics/spring_term.h"

#include <algorithm>
#include <utility>

namespace knittsim::physics {

namespace {
constexpr double kTiny = 1e-12; // mm; below, a spring has no direction
}

SpringTerm::SpringTerm(SpringLaw law, std::vector<Spring> springs)
    : m_law(std::move(law)), m_springs(std::move(springs)) {}

double SpringTerm::tension(const Vector& x, std::size_t i) const {
    const Spring& s = m_springs[i];
    return evaluateSpring(m_law, s, (at(x, s.b) - at(x, s.a)).norm()).force;
}

double SpringTerm::evaluate(const Vector& x, Vector* gradient) const {
    double energy = 0;
    for (const Spring& s : m_springs) {
        const Eigen::Vector3d edge = at(x, s.b) - at(x, s.a);
        const double distance = edge.norm();
        const SpringValue value = evaluateSpring(m_law, s, distance);
        energy += value.energy;
        if (gradient != nullptr && distance > kTiny) {
            const Eigen::Vector3d force = edge * (value.force / distance);
            at(*gradient, s.b) += force;
            at(*gradient, s.a) -= force;
        }
    }
    return energy;
}

void SpringTerm::linearise(const Vector& x) {
    m_linear.resize(m_springs.size());
    for (std::size_t i = 0; i < m_springs.size(); ++i) {
        const Spring& s = m_springs[i];
        const Eigen::Vector3d edge = at(x, s.b) - at(x, s.a);
        const double distance = edge.norm();
        const SpringValue value = evaluateSpring(m_law, s, distance);
        const double across = distance > kTiny ? std::max(0.0, value.force / distance) : 0;
        m_linear[i].direction =
            distance > kTiny ? Eigen::Vector3d(edge / distance) : Eigen::Vector3d::UnitX();
        m_linear[i].across = across;
        m_linear[i].along = std::max(0.0, value.stiffness) - across;
    }
}

void SpringTerm::multiply(const Vector& v, Vector& y) const {
    for (std::size_t i = 0; i < m_springs.size(); ++i) {
        const Spring& s = m_springs[i];
        const Linear& l = m_linear[i];
        const Eigen::Vector3d d = at(v, s.b) - at(v, s.a);
        const Eigen::Vector3d force = l.across * d + (l.along * l.direction.dot(d)) * l.direction;
        at(y, s.b) += force;
        at(y, s.a) -= force;
    }
}

void SpringTerm::addDiagonal(Eigen::Matrix3Xd& blocks) const {
    for (std::size_t i = 0; i < m_springs.size(); ++i) {
        const Matrix3 block = m_linear[i].block();
        blocks.middleCols<3>(Eigen::Index{3} * m_springs[i].a) += block;
        blocks.middleCols<3>(Eigen::Index{3} * m_springs[i].b) += block;
    }
}

void SpringTerm::addBlocks(BlockSink& sink) const {
    for (std::size_t i = 0; i < m_springs.size(); ++i) {
        const Spring& s = m_springs[i];
        const Matrix3 block = m_linear[i].block();
        sink.add(s.a, s.a, block);
        sink.add(s.b, s.b, block);
        sink.add(s.a, s.b, -block);
        sink.add(s.b, s.a, -block);
    }
}

} // namespace knittsim::physics
