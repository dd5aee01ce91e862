#include "core/physics/drag_term.h"

namespace knittsim::physics {

double DragTerm::evaluate(const Vector& x, Vector* gradient) const {
    double energy = 0;
    for (const Pull& p : m_pulls) {
        const Eigen::Vector3d away = at(x, p.entry) - p.target;
        energy += 0.5 * p.stiffness * away.squaredNorm();
        if (gradient != nullptr) {
            at(*gradient, p.entry) += p.stiffness * away;
        }
    }
    return energy;
}

void DragTerm::multiply(const Vector& v, Vector& y) const {
    for (const Pull& p : m_pulls) {
        at(y, p.entry) += p.stiffness * at(v, p.entry);
    }
}

void DragTerm::addDiagonal(Eigen::Matrix3Xd& blocks) const {
    for (const Pull& p : m_pulls) {
        blocks.middleCols<3>(Eigen::Index{3} * p.entry).diagonal().array() += p.stiffness;
    }
}

void DragTerm::addBlocks(BlockSink& sink) const {
    for (const Pull& p : m_pulls) {
        sink.add(p.entry, p.entry, p.stiffness * Matrix3::Identity());
    }
}

} // namespace knittsim::physics
