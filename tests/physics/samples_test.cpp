#include "core/fabric/fabric_builder.h"
#include "core/pattern/samples.h"
#include "core/simulation/simulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace knittsim {
namespace {

using simulation::Frame;
using simulation::State;

std::shared_ptr<const fabric::Fabric> buildSample(const std::string& id) {
    return std::make_shared<fabric::Fabric>(
        fabric::buildFabric(machine::Timeline(pattern::makeSample(id), machine::genericProfile())));
}

class SampleTest : public ::testing::TestWithParam<std::string> {};

TEST_P(SampleTest, SettlesToAFabricOfBelievableSize) {
    const auto fabric = buildSample(GetParam());
    simulation::Simulation simulation;
    simulation.apply(simulation::command::Load{fabric, {}});
    simulation.runToEnd(120);
    const Frame frame = simulation.frame();
    EXPECT_EQ(frame.state, State::AtRest);
    double low[3] = {1e9, 1e9, 1e9};
    double high[3] = {-1e9, -1e9, -1e9};
    for (std::size_t i = 0; i < frame.positions.size(); ++i) {
        ASSERT_TRUE(std::isfinite(frame.positions[i]));
        low[i % 3] = std::min<double>(low[i % 3], frame.positions[i]);
        high[i % 3] = std::max<double>(high[i % 3], frame.positions[i]);
    }
    RecordProperty("width_mm", std::to_string(high[0] - low[0]));
    RecordProperty("height_mm", std::to_string(high[1] - low[1]));
    RecordProperty("thickness_mm", std::to_string(high[2] - low[2]));
    // It leaves the machine narrower than it was knitted, and no thicker than a few loops are long.
    double machineLow = 1e9;
    double machineHigh = -1e9;
    double loop = 0;
    for (const Vec3& p : fabric->machinePositions) {
        machineLow = std::min(machineLow, p.x());
        machineHigh = std::max(machineHigh, p.x());
    }
    for (const machine::Loop& l : fabric->made.loops) {
        loop = std::max(loop, l.lengthMm);
    }
    EXPECT_LT(high[0] - low[0], machineHigh - machineLow);
    EXPECT_GT(high[0] - low[0], 0.25 * (machineHigh - machineLow));
    EXPECT_LT(high[2] - low[2], 1.5 * loop);
}

/// Hardly a loop is drawn together to a point at its heads.
TEST_P(SampleTest, KeepsItsLoopsOpen) {
    const auto fabric = buildSample(GetParam());
    simulation::Simulation simulation;
    simulation.apply(simulation::command::Load{fabric, {}});
    simulation.runToEnd(120);
    const Frame frame = simulation.frame();
    const auto place = [&](fabric::PointIndex p) {
        const auto e = 3 * static_cast<std::size_t>(fabric->points[static_cast<std::size_t>(p)].entry);
        return Vec3(frame.positions[e], frame.positions[e + 1], frame.positions[e + 2]);
    };
    std::size_t closed = 0;
    for (std::size_t i = 0; i < fabric->loops.size(); ++i) {
        const fabric::Loop& loop = fabric->loops[i];
        const double width = (place(loop.headRight) - place(loop.headLeft)).norm();
        closed += width < 0.02 * fabric->made.loops[i].lengthMm ? 1 : 0;
    }
    EXPECT_LE(closed, fabric->loops.size() / 50);
}

std::vector<std::string> ids() {
    std::vector<std::string> result;
    for (const pattern::Sample& sample : pattern::samples()) {
        result.push_back(sample.id);
    }
    return result;
}

std::string testName(const ::testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::erase(name, '-');
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, SampleTest, ::testing::ValuesIn(ids()), testName);

} // namespace
} // namespace knittsim
