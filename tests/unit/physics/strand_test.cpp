#include "core/physics/strand.h"
#include "knit.h"

#include <gtest/gtest.h>

namespace knittsim::physics {
namespace {

using fabric::Fabric;

int count(const Strands& strands, Strand::Kind kind) {
    return static_cast<int>(std::count_if(strands.all.begin(), strands.all.end(),
                                          [&](const Strand& s) { return s.kind == kind; }));
}

TEST(Strands, OfAPlainSwatchByHand) {
    // 4 x 3: 12 heads; two legs for each of the 8 loops with feet; 3 sinkers in each of two courses;
    // floats: 3 between the first loops, and one way up after each of the first two courses.
    const Strands strands = findStrands(test::plain(4, 3));
    EXPECT_EQ(count(strands, Strand::Kind::Head), 12);
    EXPECT_EQ(count(strands, Strand::Kind::Leg), 16);
    EXPECT_EQ(count(strands, Strand::Kind::Sinker), 6);
    EXPECT_EQ(count(strands, Strand::Kind::Float), 5);
}

TEST(Strands, ShareTheLoopLengthAsARelaxedLoopDoes) {
    const Fabric f = test::plain(4, 3);
    const double l = f.made.loops[0].lengthMm;
    for (const Strand& s : findStrands(f).all) {
        if (s.kind == Strand::Kind::Head || s.kind == Strand::Kind::Sinker) {
            EXPECT_NEAR(s.rest, 0.125 * l, 1e-3 * l);
        } else if (s.kind == Strand::Kind::Leg) {
            EXPECT_NEAR(s.rest, 0.19 * l, 1e-3 * l);
        }
    }
}

TEST(Strands, LegsShrinkWhereTheFaceChanges) {
    const Fabric f = test::garter(3, 4);
    const Strands strands = findStrands(f);
    const double l = f.made.loops[0].lengthMm;
    const auto legRest = [&](int loop) {
        const auto s = strands.legAt(f.loops[static_cast<std::size_t>(loop)].footLeft);
        return strands.all[static_cast<std::size_t>(s)].rest / (kLegChord * fabric::kLegShare * l);
    };
    EXPECT_NEAR(legRest(test::loopAt(1, 1, 3)), kLegTwoFaceChanges, 1e-12);
    EXPECT_NEAR(legRest(test::loopAt(1, 3, 3)), kLegOneFaceChange, 1e-12); // nothing drawn through the last
}

TEST(Strands, AFloatIsAsLongAsItsYarnLessTheArcsAtItsEnds) {
    // Needles 0 and 5 only, twice over: the float between spans 5 pitches.
    const Fabric f = knittsim::test::build(
        "in 1\nknit + f0 1\nknit + f5 1\nknit - f5 1\nknit - f0 1\nknit + f0 1\nknit + f5 1\n");
    const double l = f.made.loops[0].lengthMm;
    const auto foot = f.loops[5].footLeft;
    const Strands strands = findStrands(f);
    const Strand& s = strands.all[static_cast<std::size_t>(strands.otherAt(foot))];
    EXPECT_EQ(s.kind, Strand::Kind::Float);
    EXPECT_NEAR(s.length, fabric::kSinkerShare * l + 4 * f.pitchMm, 1e-9);
    EXPECT_NEAR(s.rest, kArcChord * fabric::kSinkerShare * l + 4 * f.pitchMm, 1e-9);
    EXPECT_FALSE(s.pushes());
}

TEST(Strands, CrossingsShareTheStrandWithoutChangingItsLength) {
    // Two wales change places over held loops: their legs cross.
    const Fabric f =
        knittsim::test::build("in 1\n" + knittsim::test::pass("knit", 'f', 0, 3, 1) +
                              "xfer f1 b1\nxfer f2 b2\nrack 1\nxfer b1 f2\nrack -1\nxfer b2 f1\nrack 0\n" +
                              knittsim::test::pass("knit", 'f', 3, 0, 1));
    ASSERT_FALSE(f.crossings.empty());
    const Strands strands = findStrands(f);
    const BondingPointModel net = buildBondingPointModel(f, {});
    for (const Strand& s : strands.all) {
        double rest = 0;
        for (std::size_t i = 0; i < net.springPoint.size(); ++i) {
            if (net.springPoint[i] >= s.first && net.springPoint[i] < s.last) {
                rest += net.model->springs().springs()[i].rest;
            }
        }
        if (s.kind != Strand::Kind::Float) {
            EXPECT_NEAR(rest, s.rest, 1e-9);
        }
    }
}

} // namespace
} // namespace knittsim::physics
