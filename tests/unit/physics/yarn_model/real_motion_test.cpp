#include "chains_for_tests.h"
#include "core/physics/real_motion.h"
#include "core/physics/yarn_model/gravity_term.h"
#include "core/physics/yarn_model/yarn_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace knittsim::physics {
namespace {

constexpr double kLength = 20;
constexpr int kNodes = 41;
constexpr double kSwing = 0.8;              ///< of the lower end
constexpr double kRoot = 2.404825557695773; ///< first zero of J0

/// A thread hung up at one end swings as J0(2 w sqrt(z / g)), z from its lower end, with w = j/2 sqrt(g / L)
/// (Daniel Bernoulli).
double period() {
    return 2 * std::numbers::pi / (0.5 * kRoot * std::sqrt(1 / kLength));
}

/// Its lower end at times, x.
struct Swing {
    std::vector<double> time;
    std::vector<double> x;

    double at(double t) const {
        std::size_t i = 1;
        while (i + 1 < time.size() && time[i] < t) {
            ++i;
        }
        const double share = (t - time[i - 1]) / (time[i] - time[i - 1]);
        return x[i - 1] + share * (x[i] - x[i - 1]);
    }
    /// When it first goes through 0 after `from`.
    double zeroAfter(double from) const {
        for (std::size_t i = 1; i < time.size(); ++i) {
            if (time[i - 1] >= from && (x[i - 1] > 0) != (x[i] > 0)) {
                return time[i - 1] + (time[i] - time[i - 1]) * x[i - 1] / (x[i - 1] - x[i]);
            }
        }
        return -1;
    }
};

Swing swing(double massRate) {
    YarnChains chains;
    chains.yarns = {{1, 0.5, 2e4, 1e-3, 0.1}}; // hardly stretches, hardly resists bending
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < kNodes; ++i) {
        const double z = kLength * (1 - static_cast<double>(i) / (kNodes - 1));
        points.emplace_back(kSwing * std::cyl_bessel_j(0, kRoot * std::sqrt(z / kLength)), z - kLength, 0);
    }
    test::addChain(chains, points);
    YarnModel model(chains);
    model.add(std::make_unique<GravityTerm>(nodeLengths(chains), Eigen::Vector3d(0, -1, 0)));
    model.setPinned(0, true);
    Motion motion{chains.start(), Vector::Zero(chains.start().size()), 0};
    const auto integrator = makeRealMotion({.massRate = massRate, .stiffnessTime = 0.01});
    integrator->initialise(model, motion);
    Swing result;
    while (motion.time < 0.8 * period()) {
        result.time.push_back(motion.time);
        result.x.push_back(at(motion.positions, kNodes - 1).x());
        if (integrator->step(motion, {}).outcome != StepReport::Outcome::Moved) {
            ADD_FAILURE() << "stopped at " << motion.time;
            break;
        }
    }
    return result;
}

TEST(RealMotion, AHangingThreadSwingsAsBernoulliFound) {
    const Swing free = swing(0);
    const double first = free.zeroAfter(0);
    const double second = free.zeroAfter(first);
    EXPECT_NEAR(first, 0.25 * period(), 0.01 * period());
    EXPECT_NEAR(2 * (second - first), period(), 0.01 * period());
    EXPECT_NEAR(free.at(0.5 * period()), -kSwing, 0.03 * kSwing);
}

TEST(RealMotion, AirTakesTheSwingAwayAsFastAsItsRateSays) {
    constexpr double kRate = 0.03;
    const Swing damped = swing(kRate);
    EXPECT_NEAR(damped.at(0.5 * period()) / swing(0).at(0.5 * period()), std::exp(-0.25 * kRate * period()),
                0.01);
}

} // namespace
} // namespace knittsim::physics
