#include "core/base/file.h"
#include "core/yarn/yarn_library.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <set>

namespace knittsim::yarn {
namespace {

using ::testing::IsEmpty;
using ::testing::Key;
using ::testing::SizeIs;
using ::testing::UnorderedElementsAre;

const std::filesystem::path kFolder = std::filesystem::path(KNITTSIM_SOURCE_DIR) / "resources/yarns";

const YarnLibrary& library() {
    static const Result<YarnLibrary> result = YarnLibrary::read(kFolder);
    return result.value();
}

TEST(ShippedYarns, AllFilesAreRead) {
    const Result<YarnLibrary> result = YarnLibrary::read(kFolder);
    ASSERT_TRUE(result);
    EXPECT_THAT(result.diagnostics(), IsEmpty());
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
        files += entry.path().extension() == ".json" ? 1 : 0;
    }
    EXPECT_EQ(result.value().yarns().size(), files);
    EXPECT_GE(files, 22U);
}

TEST(ShippedYarns, FilesAreNamedByIdAndWrittenAsTheProgramWritesThem) {
    for (const Yarn& yarn : library().yarns()) {
        const Result<std::string> text = readFile(kFolder / (yarn.id + ".json"));
        ASSERT_TRUE(text) << yarn.id;
        EXPECT_EQ(text.value(), toJson(yarn)) << yarn.id;
    }
}

TEST(ShippedYarns, EveryNumberTellsWhereItComesFrom) {
    for (const Yarn& yarn : library().yarns()) {
        EXPECT_THAT(yarn.sources,
                    UnorderedElementsAre(Key("count"), Key("outer_diameter_mm"), Key("core_diameter_mm"),
                                         Key("axial_stiffness_n"), Key("bending_stiffness_n_m2"),
                                         Key("friction"), Key("colour"), Key("surface")))
            << yarn.id;
    }
}

TEST(ShippedYarns, ColoursDiffer) {
    std::set<std::array<int, 3>> colours;
    for (const Yarn& yarn : library().yarns()) {
        colours.insert({yarn.colour.r, yarn.colour.g, yarn.colour.b});
    }
    EXPECT_THAT(colours, SizeIs(library().yarns().size()));
}

TEST(ShippedYarns, DefaultYarnIsTheMerinoOfTheLibrary) {
    const Yarn* merino = library().find(defaultYarn().id);
    ASSERT_NE(merino, nullptr);
    Yarn bare = *merino;
    bare.sources.clear();
    EXPECT_EQ(bare, defaultYarn());
}

/// What a yarn's estimate rests on: fibre density g/cm3, packing of the hull, eta, fibre modulus GPa, fibre
/// tex.
struct Estimate {
    const char* id;
    double density, packing, eta, modulus, fibreTex;
};

double roundFibreTex(double micron, double density) {
    return std::numbers::pi / 4 * micron * micron * density * 1e-3;
}

/// README of resources/yarns, "Formulas".
TEST(ShippedYarns, EstimatesFollowTheirFormulas) {
    const Estimate estimates[] = {
        {"merino-2-30", 1.31, 0.50, 0.25, 3, roundFibreTex(19.5, 1.31)},
        {"merino-2-48", 1.31, 0.50, 0.25, 3, roundFibreTex(19.5, 1.31)},
        {"merino-2-28-two-ends", 1.31, 0.45, 0.25, 3, roundFibreTex(19.5, 1.31)},
        {"lambswool-2-15", 1.31, 0.28, 0.25, 3, roundFibreTex(21, 1.31)},
        {"shetland-2-8", 1.31, 0.25, 0.25, 3, roundFibreTex(28, 1.31)},
        {"cashmere-2-26", 1.31, 0.28, 0.25, 3, roundFibreTex(15.5, 1.31)},
        {"acrylic-hb-2-28", 1.17, 0.30, 0.25, 4, 0.33},
        {"acrylic-hb-2-16", 1.17, 0.28, 0.25, 4, 0.33},
        {"cotton-combed-2-30", 1.52, 0.60, 0.5, 7.5, 0.19},
        {"cotton-carded-2-20", 1.52, 0.60, 0.5, 7.5, 0.19},
        {"cotton-mercerised-2-40", 1.52, 0.65, 0.5, 7.5, 0.19},
        {"cotton-pearl-3-2", 1.52, 0.55, 0.5, 7.5, 0.19},
        {"cotton-20-2-du-pasquier", 1.52, 0.60, 0.5, 7.5, 0.19},
        {"viscose-2-30", 1.5, 0.60, 0.5, 8, 0.17},
        {"polyester-textured-167", 1.38, 0.35, 0.25, 10, 0.348},
        {"linen-26", 1.48, 0.53, 0.5, 30, roundFibreTex(16, 1.48)},
        {"silk-spun-2-60", 1.34, 0.60, 0.5, 10, 0.15},
        {"mohair-brushed-11", 1.3, 0.06, 0.25, 3.5, roundFibreTex(26, 1.3)},
        {"alpaca-2-16", 1.3, 0.38, 0.25, 3.2, roundFibreTex(23, 1.3)},
        {"nylon-70-24-two-ends", 1.14, 0.35, 0.25, 3, 0.324},
    };
    for (const Estimate& e : estimates) {
        const Yarn* yarn = library().find(e.id);
        ASSERT_NE(yarn, nullptr) << e.id;
        const auto diameter = [&](double packing) {
            return 0.03568 * std::sqrt(yarn->tex / (e.density * packing));
        };
        EXPECT_NEAR(yarn->outerDiameterMm / diameter(e.packing), 1, 0.04) << e.id;
        EXPECT_NEAR(yarn->coreDiameterMm / diameter(0.9), 1, 0.04) << e.id;
        // tex / density is the section in 1e-3 mm2; GPa mm2 = kN = 1e6 mN
        const double section = yarn->tex / e.density * 1e-3;
        EXPECT_NEAR(yarn->axialStiffnessMilliNewton / (e.eta * e.modulus * section * 1e6), 1, 0.05) << e.id;
        const double fibre = e.fibreTex / e.density * 1e-3;
        const double inertia = fibre * fibre / (4 * std::numbers::pi);
        const double bending = 2.4 * (yarn->tex / e.fibreTex) * e.modulus * 1e6 * inertia;
        EXPECT_NEAR(yarn->bendingStiffness / bending, 1, 0.06) << e.id;
    }
}

TEST(ShippedYarns, MonofilamentsAreSolidRods) {
    for (const auto& [id, modulus, density] :
         {std::tuple{"nylon-mono-150", 2.5e6, 1.14}, std::tuple{"pet-mono-178", 10e6, 1.38}}) {
        const Yarn* yarn = library().find(id);
        ASSERT_NE(yarn, nullptr) << id;
        const double d = yarn->outerDiameterMm;
        EXPECT_EQ(yarn->coreDiameterMm, d);
        const double area = std::numbers::pi / 4 * d * d;
        EXPECT_NEAR(yarn->tex / (area * density * 1e3), 1, 0.01) << id;
        EXPECT_NEAR(yarn->axialStiffnessMilliNewton / (modulus * area), 1, 0.02) << id;
        EXPECT_NEAR(yarn->bendingStiffness / (modulus * area * d * d / 16), 1, 0.02) << id;
    }
}

} // namespace
} // namespace knittsim::yarn
