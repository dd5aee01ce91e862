#include "core/physics/rank_one.h"

#include <array>

namespace knittsim::physics {

void RankOneHessian::multiply(const Vector& v, Vector& y) const {
    for (const TwoArms& t : m_places) {
        const double p = t.slopeFirst.dot(at(v, t.first) - at(v, t.middle)) +
                         t.slopeSecond.dot(at(v, t.second) - at(v, t.middle));
        at(y, t.first) += p * t.slopeFirst;
        at(y, t.second) += p * t.slopeSecond;
        at(y, t.middle) -= p * (t.slopeFirst + t.slopeSecond);
    }
}

void RankOneHessian::addDiagonal(Eigen::Matrix3Xd& blocks) const {
    for (const TwoArms& t : m_places) {
        const Eigen::Vector3d both = t.slopeFirst + t.slopeSecond;
        blocks.middleCols<3>(Eigen::Index{3} * t.first) += t.slopeFirst * t.slopeFirst.transpose();
        blocks.middleCols<3>(Eigen::Index{3} * t.second) += t.slopeSecond * t.slopeSecond.transpose();
        blocks.middleCols<3>(Eigen::Index{3} * t.middle) += both * both.transpose();
    }
}

void RankOneHessian::addBlocks(BlockSink& sink) const {
    for (const TwoArms& t : m_places) {
        const std::array<Entry, 3> entry{t.first, t.second, t.middle};
        const std::array<Eigen::Vector3d, 3> slope{t.slopeFirst, t.slopeSecond,
                                                   -(t.slopeFirst + t.slopeSecond)};
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t l = 0; l < 3; ++l) {
                sink.add(entry[k], entry[l], slope[k] * slope[l].transpose());
            }
        }
    }
}

} // namespace knittsim::physics
