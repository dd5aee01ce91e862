#pragma once

#include "core/physics/energy_term.h"
#include "core/physics/spring_law.h"

#include <vector>

namespace knittsim::physics {

/// Springs along the yarn: equations 1 to 3, 7 and 8. The Hessian leaves out the part across a compressed
/// spring.
class SpringTerm final : public EnergyTerm {
public:
    SpringTerm(SpringLaw law, std::vector<Spring> springs);

    const std::vector<Spring>& springs() const { return m_springs; }

    /// Force in spring i, mN, > 0 pulls.
    double tension(const Vector& x, std::size_t i) const;

    double evaluate(const Vector& x, Vector* gradient) const override;
    void linearise(const Vector& x) override;
    void multiply(const Vector& v, Vector& y) const override;
    void addDiagonal(Eigen::Matrix3Xd& blocks) const override;
    void addBlocks(BlockSink& sink) const override;

private:
    /// H of one spring = across I + along t t^T
    struct Linear {
        Eigen::Vector3d direction;
        double across;
        double along;

        Matrix3 block() const {
            return across * Matrix3::Identity() + along * direction * direction.transpose();
        }
    };

    SpringLaw m_law;
    std::vector<Spring> m_springs;
    std::vector<Linear> m_linear;
};

} // namespace knittsim::physics
