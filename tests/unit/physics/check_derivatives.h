#pragma once

#include "core/physics/energy_term.h"

#include <Eigen/Dense>

namespace knittsim::physics::test {

/// The Hessian that addBlocks gives, as a dense matrix.
class DenseSink final : public BlockSink {
public:
    explicit DenseSink(Eigen::Index size) : matrix(Eigen::MatrixXd::Zero(size, size)) {}
    void add(Entry row, Entry column, const Matrix3& block) override {
        matrix.block<3, 3>(Eigen::Index{3} * row, Eigen::Index{3} * column) += block;
    }
    Eigen::MatrixXd matrix;
};

inline Eigen::MatrixXd denseHessian(EnergyTerm& term, const Vector& x) {
    term.linearise(x);
    DenseSink sink(x.size());
    term.addBlocks(sink);
    return sink.matrix;
}

inline Vector gradientOf(const EnergyTerm& term, const Vector& x) {
    Vector gradient = Vector::Zero(x.size());
    term.evaluate(x, &gradient);
    return gradient;
}

/// Central differences of the energy.
inline Vector differenceGradient(const EnergyTerm& term, const Vector& x, double h = 1e-6) {
    Vector result(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        Vector up = x;
        Vector down = x;
        up[i] += h;
        down[i] -= h;
        result[i] = (term.evaluate(up, nullptr) - term.evaluate(down, nullptr)) / (2 * h);
    }
    return result;
}

/// Central differences of the gradient.
inline Eigen::MatrixXd differenceHessian(const EnergyTerm& term, const Vector& x, double h = 1e-6) {
    Eigen::MatrixXd result(x.size(), x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        Vector up = x;
        Vector down = x;
        up[i] += h;
        down[i] -= h;
        result.col(i) = (gradientOf(term, up) - gradientOf(term, down)) / (2 * h);
    }
    return result;
}

} // namespace knittsim::physics::test
