#include "core/physics/straight_term.h"

#include <cmath>

namespace knittsim::physics {

StraightTerm::StraightTerm(const std::vector<Straight>& places) {
    m_places.reserve(places.size());
    for (const Straight& p : places) {
        const double root = std::sqrt(p.stiffness);
        const double before = root / p.restBefore;
        const double after = root / p.restAfter;
        m_places.push_back({{p.before, p.middle, p.after}, {before, -before - after, after}});
    }
}

double StraightTerm::evaluate(const Vector& x, Vector* gradient) const {
    double energy = 0;
    for (const Place& p : m_places) {
        const Eigen::Vector3d r = p.weight[0] * at(x, p.entry[0]) + p.weight[1] * at(x, p.entry[1]) +
                                  p.weight[2] * at(x, p.entry[2]);
        energy += 0.5 * r.squaredNorm();
        if (gradient != nullptr) {
            for (int k = 0; k < 3; ++k) {
                at(*gradient, p.entry[k]) += p.weight[k] * r;
            }
        }
    }
    return energy;
}

void StraightTerm::linearise(const Vector& /*x*/) {}

void StraightTerm::multiply(const Vector& v, Vector& y) const {
    evaluate(v, &y);
}

void StraightTerm::addDiagonal(Eigen::Matrix3Xd& blocks) const {
    for (const Place& p : m_places) {
        for (int k = 0; k < 3; ++k) {
            blocks.middleCols<3>(Eigen::Index{3} * p.entry[k]).diagonal().array() +=
                p.weight[k] * p.weight[k];
        }
    }
}

void StraightTerm::addBlocks(BlockSink& sink) const {
    for (const Place& p : m_places) {
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                sink.add(p.entry[i], p.entry[j], p.weight[i] * p.weight[j] * Matrix3::Identity());
            }
        }
    }
}

} // namespace knittsim::physics
