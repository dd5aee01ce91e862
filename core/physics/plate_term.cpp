#include "core/physics/plate_term.h"

#include <cmath>

namespace knittsim::physics {

double PlateTerm::evaluate(const Vector& x, Vector* gradient) const {
    double energy = 0;
    for (Eigen::Index i = 2; i < x.size(); i += 3) {
        const double out = std::abs(x[i]) - m_halfGap;
        if (out > 0) {
            energy += 0.5 * m_stiffness * out * out;
            if (gradient != nullptr) {
                (*gradient)[i] += std::copysign(m_stiffness * out, x[i]);
            }
        }
    }
    return energy;
}

void PlateTerm::linearise(const Vector& x) {
    m_linear.resize(x.size() / 3);
    for (Eigen::Index e = 0; e < m_linear.size(); ++e) {
        m_linear[e] = std::abs(x[3 * e + 2]) > m_halfGap ? m_stiffness : 0;
    }
}

void PlateTerm::multiply(const Vector& v, Vector& y) const {
    for (Eigen::Index e = 0; e < m_linear.size(); ++e) {
        y[3 * e + 2] += m_linear[e] * v[3 * e + 2];
    }
}

void PlateTerm::addDiagonal(Eigen::Matrix3Xd& blocks) const {
    for (Eigen::Index e = 0; e < m_linear.size(); ++e) {
        blocks(2, 3 * e + 2) += m_linear[e];
    }
}

void PlateTerm::addBlocks(BlockSink& sink) const {
    Matrix3 block = Matrix3::Zero();
    for (Eigen::Index e = 0; e < m_linear.size(); ++e) {
        if (m_linear[e] > 0) {
            block(2, 2) = m_linear[e];
            sink.add(static_cast<Entry>(e), static_cast<Entry>(e), block);
        }
    }
}

} // namespace knittsim::physics
