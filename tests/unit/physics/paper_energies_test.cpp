#include "core/physics/bonding_point_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace knittsim::physics {
namespace {

/// One yarn through entries 0, 1, 2 with 2 and 3 mm of yarn between them.
fabric::Fabric threePoints() {
    fabric::Fabric f;
    f.made.loops.resize(1);
    f.loops.resize(1);
    for (int e = 0; e < 3; ++e) {
        fabric::BondingPoint point;
        point.entry = e;
        point.loop = 0;
        f.points.push_back(point);
    }
    f.lengths = {2, 3, 0};
    f.yarns.push_back({.carrier = 0, .first = 0, .count = 3, .lengthMm = 5});
    f.entryCount = 3;
    f.machinePositions = {{0, 0, 0}, {2.5, 0, 0}, {2.5, 2, 0}};
    f.pointsOfEntry = {0, 1, 2};
    f.firstOfEntry = {0, 1, 2, 3};
    return f;
}

ModelOptions paper() {
    ModelOptions options;
    options.mode = ModelOptions::Mode::Paper;
    options.paper.pull = 7;
    options.paper.repel = 11;
    options.paper.bend = 0.5;
    return options;
}

TEST(PaperModel, AddsUpEquationsSixToEight) {
    const fabric::Fabric f = threePoints();
    const BondingPointModel net = buildBondingPointModel(f, {}, paper());
    // 0.5 mm too long, 1 mm too short, one right angle
    const double quarter = std::numbers::pi / 2;
    EXPECT_NEAR(net.model->evaluate(machinePositions(f), nullptr),
                7 * std::pow(0.5, 4) + 11 * 1 + 0.5 * quarter * quarter, 1e-12);
}

TEST(PaperModel, TellsTheForceInEachPieceOfYarn) {
    const fabric::Fabric f = threePoints();
    const BondingPointModel net = buildBondingPointModel(f, {}, paper());
    std::vector<float> tension(3);
    net.tensions(machinePositions(f), tension);
    EXPECT_FLOAT_EQ(tension[0], 4 * 7 * 0.125F);
    EXPECT_FLOAT_EQ(tension[1], -2 * 11);
    EXPECT_FLOAT_EQ(tension[2], 0);
}

TEST(PaperModel, HangsHalfOfTheYarnOnEitherPoint) {
    const fabric::Fabric f = threePoints();
    std::vector<yarn::Yarn> yarns(1);
    yarns[0].tex = 100; // 1e-7 kg/mm
    const BondingPointModel net = buildBondingPointModel(f, yarns, paper());
    EXPECT_NEAR(net.model->mass()[0], 1e-7, 1e-20);
    EXPECT_NEAR(net.model->mass()[1], 2.5e-7, 1e-20);
    EXPECT_NEAR(net.model->mass()[2], 1.5e-7, 1e-20);
}

} // namespace
} // namespace knittsim::physics
