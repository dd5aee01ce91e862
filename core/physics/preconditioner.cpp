#include "core/physics/preconditioner.h"

#include "core/physics/model.h"

#include <Eigen/LU>

namespace knittsim::physics {

void BlockJacobi::build(double massFactor) {
    m_blocks = m_model.diagonal();
    m_inverse.resize(3, m_blocks.cols());
    for (Entry e = 0; e < m_model.entryCount(); ++e) {
        auto block = m_blocks.middleCols<3>(Eigen::Index{3} * e);
        block.diagonal().array() += massFactor * m_model.mass()[e];
        const Matrix3 inverse = Matrix3(block).inverse();
        m_inverse.middleCols<3>(Eigen::Index{3} * e) = 0.5 * (inverse + inverse.transpose());
    }
}

void BlockJacobi::apply(const Vector& r, Vector& z) const {
    z.resize(r.size());
    for (Eigen::Index i = 0; i < r.size(); i += 3) {
        z.segment<3>(i) = m_inverse.middleCols<3>(i) * r.segment<3>(i);
    }
}

double BlockJacobi::halfSquare(const Vector& v) const {
    double sum = 0;
    for (Eigen::Index i = 0; i < v.size(); i += 3) {
        const Eigen::Vector3d part = v.segment<3>(i);
        sum += part.dot(m_blocks.middleCols<3>(i) * part);
    }
    return 0.5 * sum;
}

} // namespace knittsim::physics
