#include "core/physics/yarn_model/relax_cell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace knittsim::physics {
namespace {

RodYarn acrylic() {
    RodYarn yarn; // PHYSICS-REFERENCE 2.4: 0.65 of 1.48 mm; k from 1e-4 to 1e-3 N/mm^3
    yarn.coreDiameter = 0.44;
    yarn.contactStiffness = 0.03;
    return yarn;
}

CellShape relaxed(const std::vector<const char*>& rows, double loopLength, const RodYarn& yarn = acrylic(),
                  const CellOptions& options = {}) {
    const KnitPurl pattern = KnitPurl::fromRows(rows);
    return relaxCell(pattern, std::vector<double>(pattern.faces.size(), loopLength), yarn, options);
}

void expectAtRest(const CellShape& cell) {
    EXPECT_EQ(cell.relax.verdict, StopRule::Verdict::ResidualReached);
    EXPECT_EQ(cell.relax.audit.coreOverlaps, 0);
    EXPECT_TRUE(cell.faults.empty());
}

class PlainCell : public ::testing::TestWithParam<double> {};

TEST_P(PlainCell, HasMundensConstants) {
    // PHYSICS 3: kc 5.0 to 5.8, kw 3.7 to 4.4, kc/kw 1.2 to 1.42 for l = 16 to 19 core diameters.
    const double loopLength = GetParam() * acrylic().coreDiameter;
    const CellShape cell = relaxed({"k"}, loopLength);
    expectAtRest(cell);
    const double kw = loopLength / cell.waleSpacing;
    const double kc = loopLength / cell.courseSpacing;
    EXPECT_THAT(kw, ::testing::AllOf(::testing::Gt(3.7), ::testing::Lt(4.4)));
    EXPECT_THAT(kc, ::testing::AllOf(::testing::Gt(5.0), ::testing::Lt(5.8)));
    EXPECT_THAT(kc / kw, ::testing::AllOf(::testing::Gt(1.2), ::testing::Lt(1.42)));
}

INSTANTIATE_TEST_SUITE_P(LoopLengths, PlainCell, ::testing::Values(16.5, 17.5, 18.5));

TEST(RelaxCell, EndsInOneShapeFromAllStarts) {
    const CellShape first = relaxed({"k"}, 8);
    for (const auto& [width, height] : {std::pair{3.2, 4.5}, std::pair{5.0, 5.0}, std::pair{4.0, 7.0}}) {
        CellOptions options;
        options.start.widthFactor = width;
        options.start.heightFactor = height;
        const CellShape other = relaxed({"k"}, 8, acrylic(), options);
        expectAtRest(other);
        EXPECT_NEAR(other.waleSpacing / first.waleSpacing, 1, 0.01) << width;
        EXPECT_NEAR(other.courseSpacing / first.courseSpacing, 1, 0.01) << width;
    }
}

TEST(RelaxCell, EndsInOneShapeByAllSolvers) {
    CellOptions options;
    options.relax.residual = 1e-4; // a rib opens and closes at hardly any force
    const CellShape first = relaxed({"kp"}, 9, acrylic(), options);
    for (const char* integrator : {"fire", "l-bfgs"}) {
        options.relax.integrator = integrator;
        const CellShape other = relaxed({"kp"}, 9, acrylic(), options);
        expectAtRest(other);
        EXPECT_NEAR(other.waleSpacing / first.waleSpacing, 1, 0.01) << integrator;
        EXPECT_NEAR(other.courseSpacing / first.courseSpacing, 1, 0.01) << integrator;
    }
}

TEST(RelaxCell, SpacingsHardlyDependOnTheBendingStiffness) {
    // PHYSICS 3: EI times 100 changes spacings by less than 11 %: contact is softer by 100 in its units.
    RodYarn soft = acrylic();
    RodYarn hard = acrylic();
    soft.contactStiffness = 0.3;
    hard.contactStiffness = 0.003;
    const CellShape a = relaxed({"k"}, 8.8, soft);
    const CellShape b = relaxed({"k"}, 8.8, hard);
    EXPECT_NEAR(b.waleSpacing / a.waleSpacing, 1, 0.11);
    EXPECT_NEAR(b.courseSpacing / a.courseSpacing, 1, 0.11);
}

TEST(RelaxCell, ScalesWithYarnAndLoop) {
    // Yarn and loop halved, EI kept: EA times 4, k times 32.
    RodYarn small = acrylic();
    small.outerDiameter *= 0.5;
    small.coreDiameter *= 0.5;
    small.axialStiffness *= 4;
    small.contactStiffness *= 32;
    const CellShape one = relaxed({"k"}, 8);
    const CellShape half = relaxed({"k"}, 4, small);
    EXPECT_NEAR(2 * half.waleSpacing / one.waleSpacing, 1, 0.01);
    EXPECT_NEAR(2 * half.courseSpacing / one.courseSpacing, 1, 0.01);
}

TEST(RelaxCell, PurlIsKnitSeenFromBehind) {
    const CellShape knit = relaxed({"k"}, 8);
    const CellShape purl = relaxed({"p"}, 8);
    expectAtRest(purl);
    EXPECT_NEAR(purl.waleSpacing / knit.waleSpacing, 1, 5e-3);
    EXPECT_NEAR(purl.courseSpacing / knit.courseSpacing, 1, 5e-3);
}

TEST(RelaxCell, PatternsStandToPlainAsInFabric) {
    // PHYSICS-REFERENCE 3.3: garter low, ribs narrow and 2x2 rib narrower, all thicker than plain.
    const CellShape plain = relaxed({"k"}, 8.8);
    const CellShape garter = relaxed({"k", "p"}, 8.8);
    const CellShape rib = relaxed({"kp"}, 8.8);
    const CellShape rib2 = relaxed({"kkpp"}, 8.8);
    const CellShape seed = relaxed({"kp", "pk"}, 8.8);
    for (const CellShape* cell : {&garter, &rib, &rib2, &seed}) {
        expectAtRest(*cell);
        EXPECT_GT(cell->thickness, 1.3 * plain.thickness);
    }
    EXPECT_THAT(garter.courseSpacing / plain.courseSpacing,
                ::testing::AllOf(::testing::Gt(0.6), ::testing::Lt(0.8)));
    EXPECT_THAT(garter.waleSpacing / plain.waleSpacing,
                ::testing::AllOf(::testing::Gt(1.0), ::testing::Lt(1.2)));
    EXPECT_THAT(rib.waleSpacing / plain.waleSpacing,
                ::testing::AllOf(::testing::Gt(0.5), ::testing::Lt(0.65)));
    EXPECT_LT(rib2.waleSpacing, rib.waleSpacing);
    EXPECT_LT(seed.courseSpacing, 0.85 * plain.courseSpacing);
}

TEST(RelaxCell, ManyRepeatsAreOneRepeat) {
    const CellShape one = relaxed({"k"}, 8.8);
    const CellShape many = relaxed({"kkkk", "kkkk", "kkkk"}, 8.8);
    expectAtRest(many);
    EXPECT_NEAR(many.waleSpacing / one.waleSpacing, 1, 0.01);
    EXPECT_NEAR(many.courseSpacing / one.courseSpacing, 1, 0.01);
}

TEST(RelaxCell, CanBeCancelled) {
    const std::function<bool()> now = [] { return true; };
    CellOptions options;
    options.relax.cancelled = &now;
    EXPECT_EQ(relaxed({"k"}, 8, acrylic(), options).relax.verdict, StopRule::Verdict::GoOn);
}

TEST(KnitCell, StartsWithTheRightTopologyAndLength) {
    for (const std::vector<const char*>& rows : {std::vector<const char*>{"k"},
                                                 {"p"},
                                                 {"k", "p"},
                                                 {"kp"},
                                                 {"kkpp"},
                                                 {"kp", "pk"},
                                                 {"kp", "kp", "pk", "pk"},
                                                 {"kkpkp", "pkpkk", "kkkpp"}}) {
        const KnitPurl pattern = KnitPurl::fromRows(rows);
        const YarnChains chains =
            knitCell(pattern, std::vector<double>(pattern.faces.size(), 8.0), acrylic());
        EXPECT_STREQ(chains.problem(), "");
        EXPECT_TRUE(findLoopFaults(pattern, chains, chains.start(), 24).empty()) << rows.front();
        double length = 0;
        for (const Chain& c : chains.chains) {
            for (Entry i = 0; i < c.count; ++i) {
                length += (position(chains.start(), chains.cellEntry(), c.place(i + 1)) -
                           position(chains.start(), chains.cellEntry(), c.place(i)))
                              .norm();
            }
        }
        EXPECT_NEAR(length / (8.0 * static_cast<double>(pattern.faces.size())), 1, 0.02);
    }
}

TEST(LoopCertificate, FindsAStitchThatIsNotDrawnThrough) {
    // The shape of purl is no shape of knit: every stitch comes from the wrong side.
    const KnitPurl purl = KnitPurl::fromRows({"pp", "pp"});
    const YarnChains chains = knitCell(purl, std::vector<double>(4, 8.0), acrylic());
    EXPECT_EQ(findLoopFaults(KnitPurl::fromRows({"kk", "kk"}), chains, chains.start(), 24).size(), 4U);

    // One course lifted over the one below it.
    Vector x = chains.start();
    for (Entry e = chains.chains[1].first; e < chains.nodeCount(); ++e) {
        at(x, e).z() += 5;
    }
    EXPECT_FALSE(findLoopFaults(purl, chains, x, 24).empty());
}

TEST(SmallestRepeat, IsFoundInBothDirections) {
    const auto repeatOf = [](const std::vector<const char*>& rows) {
        const KnitPurl p = KnitPurl::fromRows(rows);
        const KnitPurl r = smallestRepeat(p, std::vector<double>(p.faces.size(), 8.0)).pattern;
        return std::pair{r.wales, r.courses};
    };
    EXPECT_EQ(repeatOf({"kkkk", "kkkk"}), (std::pair{1, 1}));
    EXPECT_EQ(repeatOf({"kpkp", "kpkp"}), (std::pair{2, 1}));
    EXPECT_EQ(repeatOf({"kk", "pp", "kk", "pp"}), (std::pair{1, 2}));
    EXPECT_EQ(repeatOf({"kpk"}), (std::pair{3, 1}));
    EXPECT_EQ(repeatOf({"kp", "pk", "kp", "kp"}), (std::pair{2, 4}));
}

TEST(SmallestRepeat, KeepsUnlikeLoopLengthsApart) {
    const KnitPurl p = KnitPurl::fromRows({"kk", "kk"});
    const Repeat repeat = smallestRepeat(p, {8, 8, 9, 9});
    EXPECT_EQ(repeat.pattern.wales, 1);
    EXPECT_EQ(repeat.pattern.courses, 2);
    EXPECT_THAT(repeat.loopLengths, ::testing::ElementsAre(8, 9));
}

} // namespace
} // namespace knittsim::physics
