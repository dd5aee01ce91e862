#include "core/physics/curl_term.h"

#include <Eigen/Geometry>

#include <cmath>

namespace knittsim::physics {

namespace {

Matrix3 cross(const Eigen::Vector3d& v) {
    Matrix3 m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

} // namespace

Eigen::Vector3d CurlTerm::residual(const Curl& c, const Vector& x) {
    const Eigen::Vector3d t = (at(x, c.middle) - at(x, c.before)) / c.restBefore;
    const Eigen::Vector3d u = (at(x, c.above) - at(x, c.middle)) / c.restAbove;
    const Eigen::Vector3d s = (at(x, c.after) - at(x, c.middle)) / c.restAfter;
    return std::sqrt(c.stiffness) * (s - std::cos(c.turn) * t - std::sin(c.turn) * t.cross(u));
}

CurlTerm::Jacobian CurlTerm::jacobian(const Curl& c, const Vector& x) {
    const Eigen::Vector3d t = (at(x, c.middle) - at(x, c.before)) / c.restBefore;
    const Eigen::Vector3d u = (at(x, c.above) - at(x, c.middle)) / c.restAbove;
    const double root = std::sqrt(c.stiffness);
    const Matrix3 byT =
        root / c.restBefore * (-std::cos(c.turn) * Matrix3::Identity() + std::sin(c.turn) * cross(u));
    const Matrix3 byU = -root / c.restAbove * std::sin(c.turn) * cross(t);
    const Matrix3 byS = root / c.restAfter * Matrix3::Identity();
    return {-byT, byT - byU - byS, byS, byU};
}

double CurlTerm::evaluate(const Vector& x, Vector* gradient) const {
    double energy = 0;
    for (const Curl& c : m_places) {
        const Eigen::Vector3d r = residual(c, x);
        energy += 0.5 * r.squaredNorm();
        if (gradient != nullptr) {
            const Jacobian j = jacobian(c, x);
            const auto entry = entries(c);
            for (std::size_t k = 0; k < 4; ++k) {
                at(*gradient, entry[k]) += j[k].transpose() * r;
            }
        }
    }
    return energy;
}

void CurlTerm::linearise(const Vector& x) {
    m_linear.resize(m_places.size());
    for (std::size_t i = 0; i < m_places.size(); ++i) {
        m_linear[i] = jacobian(m_places[i], x);
    }
}

void CurlTerm::multiply(const Vector& v, Vector& y) const {
    for (std::size_t i = 0; i < m_places.size(); ++i) {
        const auto entry = entries(m_places[i]);
        Eigen::Vector3d r = Eigen::Vector3d::Zero();
        for (std::size_t k = 0; k < 4; ++k) {
            r += m_linear[i][k] * at(v, entry[k]);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            at(y, entry[k]) += m_linear[i][k].transpose() * r;
        }
    }
}

void CurlTerm::addDiagonal(Eigen::Matrix3Xd& blocks) const {
    for (std::size_t i = 0; i < m_places.size(); ++i) {
        const auto entry = entries(m_places[i]);
        for (std::size_t k = 0; k < 4; ++k) {
            blocks.middleCols<3>(Eigen::Index{3} * entry[k]) += m_linear[i][k].transpose() * m_linear[i][k];
        }
    }
}

void CurlTerm::addBlocks(BlockSink& sink) const {
    for (std::size_t i = 0; i < m_places.size(); ++i) {
        const auto entry = entries(m_places[i]);
        for (std::size_t k = 0; k < 4; ++k) {
            for (std::size_t l = 0; l < 4; ++l) {
                sink.add(entry[k], entry[l], m_linear[i][k].transpose() * m_linear[i][l]);
            }
        }
    }
}

} // namespace knittsim::physics
