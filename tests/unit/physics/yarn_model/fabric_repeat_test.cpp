#include "core/fabric/fabric_builder.h"
#include "core/pattern/samples.h"
#include "core/pattern/swatch.h"
#include "core/physics/yarn_model/fabric_repeat.h"
#include "core/physics/yarn_model/yarn_units.h"
#include "core/yarn/yarn_library.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace knittsim::physics {
namespace {

std::optional<FabricRepeat> repeatOf(const machine::Program& program) {
    return findFabricRepeat(fabric::buildFabric(machine::Timeline(program, machine::genericProfile())));
}

double meanLength(const FabricRepeat& found) {
    const std::vector<double>& l = found.repeat.loopLengths;
    return std::accumulate(l.begin(), l.end(), 0.0) / static_cast<double>(l.size());
}

struct Case {
    const char* name;
    machine::Program program;
    int wales;
    int courses;
    double bedChanges; ///< by stitch
};

TEST(FabricRepeat, OfTheRegularFabricsWithTheYarnTheyAreFed) {
    const machine::MachineProfile profile = machine::genericProfile();
    const double gap = std::hypot(profile.pitchMm(), profile.bedGapMm) - profile.pitchMm();
    const std::vector<Case> cases{{"plain", pattern::makePlain(14, 12), 1, 1, 0},
                                  {"garter", pattern::makeGarter(14, 12), 1, 2, 0},
                                  {"rib", pattern::makeRib(14, 12), 2, 1, 1},
                                  {"rib 2x2", pattern::makeRib(14, 12, 2, 2), 4, 1, 0.5},
                                  {"seed", pattern::makeSeed(14, 12), 2, 2, 1},
                                  {"moss", pattern::makeMoss(14, 12), 2, 4, 1}};
    for (const Case& c : cases) {
        const auto found = repeatOf(c.program);
        ASSERT_TRUE(found) << c.name;
        EXPECT_EQ(found->repeat.pattern.wales, c.wales) << c.name;
        EXPECT_EQ(found->repeat.pattern.courses, c.courses) << c.name;
        EXPECT_NEAR(meanLength(*found), profile.defaultLoopLengthMm + c.bedChanges * gap, 1e-9) << c.name;
    }
}

TEST(FabricRepeat, KnowsKnitFromPurl) {
    const auto found = repeatOf(pattern::makeRib(14, 12, 2, 2));
    ASSERT_TRUE(found);
    const KnitPurl& p = found->repeat.pattern;
    EXPECT_EQ(std::accumulate(p.faces.begin(), p.faces.end(), 0), 0);
    EXPECT_EQ(p.at(0, 0), -p.at(2, 0));
}

TEST(FabricRepeat, IsNothingWhereNothingRepeats) {
    EXPECT_FALSE(repeatOf(pattern::makePlain(3, 10))); // too narrow: no wales but edges
    EXPECT_FALSE(repeatOf(pattern::makePlain(10, 1)));
    EXPECT_FALSE(repeatOf(machine::Program{}));
    EXPECT_FALSE(repeatOf(pattern::makeSample("cable-left"))); // plain between the cables only
    EXPECT_FALSE(repeatOf(pattern::makeRib(16, 8, 7, 9)));     // one repeat and a half at most
}

TEST(YarnUnits, MakeOneYarnOfAllThatAreSimilar) {
    yarn::Yarn small = yarn::defaultYarn();
    yarn::Yarn large = small;
    large.outerDiameterMm *= 2;
    large.coreDiameterMm *= 2;
    large.bendingStiffness *= 3;
    large.axialStiffnessMilliNewton *= 3.0 / 4;
    const RodYarn a = toRod(small, unitsOf(small));
    const RodYarn b = toRod(large, unitsOf(large));
    EXPECT_DOUBLE_EQ(a.outerDiameter, 1);
    EXPECT_DOUBLE_EQ(a.bendingStiffness, 1);
    EXPECT_DOUBLE_EQ(a.coreDiameter, b.coreDiameter);
    EXPECT_DOUBLE_EQ(a.axialStiffness, b.axialStiffness);
    EXPECT_DOUBLE_EQ(a.contactStiffness, b.contactStiffness);
    // In common units the thicker one is so.
    const RodYarn c = toRod(large, unitsOf(small));
    EXPECT_DOUBLE_EQ(c.outerDiameter, 2);
    EXPECT_DOUBLE_EQ(c.bendingStiffness, 3);
    EXPECT_NEAR(c.contactStiffness, a.contactStiffness * 3 / 32, 1e-12); // k d^5 / EI is the same
}

TEST(YarnUnits, EveryYarnOfTheLibraryCanBeModelled) {
    const auto library = yarn::YarnLibrary::read(std::string(KNITTSIM_SOURCE_DIR) + "/resources/yarns");
    ASSERT_TRUE(library);
    for (const yarn::Yarn& y : library.value().yarns()) {
        const YarnUnits units = unitsOf(y);
        const KnitPurl plain = KnitPurl::fromRows({"k"});
        const RodYarn rod = toRod(y, units);
        const YarnChains chains = knitCell(plain, {16.7 * rod.coreDiameter}, rod);
        EXPECT_STREQ(chains.problem(), "") << y.id;
    }
}

} // namespace
} // namespace knittsim::physics
