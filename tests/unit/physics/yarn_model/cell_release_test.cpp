#include "core/fabric/fabric_builder.h"
#include "core/pattern/swatch.h"
#include "core/physics/yarn_model/fabric_repeat.h"
#include "core/physics/yarn_model/relax_cell.h"
#include "core/yarn/yarn_library.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

/// Cells that come from a machine and are held by friction.
namespace knittsim::physics {
namespace {

RodYarn acrylic(double friction) {
    RodYarn yarn; // PHYSICS-REFERENCE 2.4
    yarn.coreDiameter = 0.44;
    yarn.contactStiffness = 0.03;
    yarn.friction = friction;
    return yarn;
}

/// Loops of 8 d that were held at `kw` = loop length / needle pitch.
CellShape released(const std::vector<const char*>& rows, double friction, double kw, double takeDown = 4,
                   double set = 0) {
    const KnitPurl pattern = KnitPurl::fromRows(rows);
    RodYarn yarn = acrylic(friction);
    yarn.set = set;
    CellOptions options;
    options.machine = MachineHold{8 / kw, takeDown};
    return relaxCell(pattern, std::vector<double>(pattern.faces.size(), 8), yarn, options);
}

void expectSound(const CellShape& cell) {
    EXPECT_TRUE(isAtRest(cell.relax.verdict));
    EXPECT_EQ(cell.relax.audit.coreOverlaps, 0);
    EXPECT_TRUE(cell.faults.empty());
}

TEST(CellRelease, WithoutFrictionWhereACellComesFromIsForgotten) {
    const CellShape free = relaxCell(KnitPurl::fromRows({"k"}), {8}, acrylic(0));
    for (const double kw : {2.6, 4.0}) {
        const CellShape cell = released({"k"}, 0, kw);
        expectSound(cell);
        EXPECT_NEAR(cell.waleSpacing / free.waleSpacing, 1, 0.01) << kw;
        EXPECT_NEAR(cell.courseSpacing / free.courseSpacing, 1, 0.01) << kw;
    }
}

TEST(CellRelease, WithFrictionManyShapesAreAtRest) {
    // Crassous, Poincloux and Steinberger 2024: a line of rest shapes, the longer the rougher the yarn;
    // narrower ones are higher.
    double span = 0;
    for (const double friction : {0.1, 0.3}) {
        const CellShape wide = released({"k"}, friction, 2.6, 0);
        const CellShape narrow = released({"k"}, friction, 5, 4);
        expectSound(wide);
        expectSound(narrow);
        EXPECT_LT(narrow.waleSpacing, wide.waleSpacing);
        EXPECT_GT(narrow.courseSpacing, wide.courseSpacing);
        EXPECT_GT(wide.waleSpacing - narrow.waleSpacing, 1.5 * span) << friction;
        span = wide.waleSpacing - narrow.waleSpacing;
    }
}

TEST(CellRelease, IrregularCellsKeepTheirShape) {
    // Without friction these slide into flat shapes of less energy (moss of some, basket weave of all
    // starts), with courses lower than half of plain.
    const CellShape plain = released({"k"}, 0.25, 4);
    for (const std::vector<const char*>& rows :
         {std::vector<const char*>{"kp", "kp", "pk", "pk"}, {"kkpp", "kkpp", "ppkk", "ppkk"}}) {
        const CellShape one = released(rows, 0.25, 4);
        const CellShape other = released(rows, 0.25, 4, 3);
        for (const CellShape* cell : {&one, &other}) {
            expectSound(*cell);
            EXPECT_GT(cell->courseSpacing, 0.7 * plain.courseSpacing) << rows.front();
        }
        EXPECT_NEAR(other.waleSpacing / one.waleSpacing, 1, 0.05) << rows.front();
        EXPECT_NEAR(other.courseSpacing / one.courseSpacing, 1, 0.05) << rows.front();
    }
}

TEST(CellRelease, SetKeepsTheShapeAndTakesTheForceOut) {
    const CellShape springy = released({"kp"}, 0.25, 4);
    const CellShape steamed = released({"kp"}, 0.25, 4, 4, 0.5);
    expectSound(steamed);
    EXPECT_NEAR(steamed.waleSpacing / springy.waleSpacing, 1, 0.03);
    EXPECT_NEAR(steamed.courseSpacing / springy.courseSpacing, 1, 0.03);
    // Half the curvature left to bend, so a quarter of the energy.
    EXPECT_NEAR(steamed.energy / springy.energy, 0.25, 0.04);
}

struct Swatch {
    const char* name;
    machine::Program program;
    double width; ///< relative to plain, measured (PHYSICS 3)
    double height;
};

TEST(CellRelease, TheSwatchesComeOutAsMeasured) {
    // One yarn, one mu (both from the library), one stitch size, nothing fitted. Without friction 2x2 rib is
    // half as wide, and moss ends now in one shape, now in another.
    const auto library = yarn::YarnLibrary::read(KNITTSIM_SOURCE_DIR "/resources/yarns");
    const yarn::Yarn* yarn = library.value().find("acrylic-hb-2-28");
    ASSERT_NE(yarn, nullptr);
    machine::MachineProfile profile = machine::genericProfile();
    profile.defaultLoopLengthMm = 6.8;
    const YarnUnits units = unitsOf(*yarn);
    const auto settled = [&](const machine::Program& program) {
        const auto found = findFabricRepeat(fabric::buildFabric(machine::Timeline(program, profile)));
        std::vector<double> lengths = found->repeat.loopLengths;
        for (double& l : lengths) {
            l /= units.lengthMm;
        }
        CellOptions options;
        options.machine = machineHold(profile.pitchMm(), units);
        return relaxCell(found->repeat.pattern, lengths, toRod(*yarn, units), options);
    };
    const CellShape plain = settled(pattern::makePlain(14, 12));
    expectSound(plain);
    for (const Swatch& swatch : {Swatch{"garter", pattern::makeGarter(14, 12), 1.12, 0.76},
                                 Swatch{"rib", pattern::makeRib(14, 12), 0.72, 1.23},
                                 Swatch{"rib 2x2", pattern::makeRib(14, 12, 2, 2), 0.62, 1.13},
                                 Swatch{"seed", pattern::makeSeed(14, 12), 1.20, 1.01},
                                 Swatch{"moss", pattern::makeMoss(14, 12), 1.04, 1.24}}) {
        const CellShape cell = settled(swatch.program);
        expectSound(cell);
        EXPECT_NEAR(cell.waleSpacing / plain.waleSpacing / swatch.width, 1, 0.15) << swatch.name;
        EXPECT_NEAR(cell.courseSpacing / plain.courseSpacing / swatch.height, 1, 0.15) << swatch.name;
    }
}

} // namespace
} // namespace knittsim::physics
