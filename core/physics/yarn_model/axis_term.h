#pragma once

#include "core/physics/energy_term.h"

#include <utility>
#include <vector>

namespace knittsim::physics {

/// Springs on single coordinates, 1/2 k (x_i - c)^2: a pull to a plane, or a smooth rod that yarn hangs on.
class AxisTerm final : public EnergyTerm {
public:
    struct Spring {
        Entry entry = 0;
        int axis = 0; ///< 0 to 2
        double at = 0;
        double stiffness = 0;
    };

    explicit AxisTerm(std::vector<Spring> springs) : m_springs(std::move(springs)) {}

    double evaluate(const Vector& x, Vector* gradient) const override {
        double energy = 0;
        for (const Spring& s : m_springs) {
            const double off = x[index(s)] - s.at;
            energy += 0.5 * s.stiffness * off * off;
            if (gradient != nullptr) {
                (*gradient)[index(s)] += s.stiffness * off;
            }
        }
        return energy;
    }
    void linearise(const Vector& /*x*/) override {}
    void multiply(const Vector& v, Vector& y) const override {
        for (const Spring& s : m_springs) {
            y[index(s)] += s.stiffness * v[index(s)];
        }
    }
    void addDiagonal(Eigen::Matrix3Xd& blocks) const override {
        for (const Spring& s : m_springs) {
            blocks(s.axis, index(s)) += s.stiffness;
        }
    }
    void addBlocks(BlockSink& sink) const override {
        for (const Spring& s : m_springs) {
            Matrix3 block = Matrix3::Zero();
            block(s.axis, s.axis) = s.stiffness;
            sink.add(s.entry, s.entry, block);
        }
    }

private:
    static Eigen::Index index(const Spring& s) { return Eigen::Index{3} * s.entry + s.axis; }

    std::vector<Spring> m_springs;
};

} // namespace knittsim::physics
