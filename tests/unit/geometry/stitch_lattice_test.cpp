#include "core/geometry/measure.h"
#include "core/geometry/stitch_lattice.h"
#include "tests/unit/geometry/plain_case.h"

#include <gtest/gtest.h>

namespace knittsim::geometry {
namespace {

TEST(StitchLattice, HasAPlaceForEachStitchInItsSpacing) {
    const fabric::Fabric fabric = test::knit("ffffff", 5);
    const std::vector<float> positions = test::relaxedLattice(fabric, test::kLoopMm);
    const StitchLattice lattice = stitchLattice(fabric, positions);
    const Measurement size = measure(fabric, positions);
    ASSERT_EQ(lattice.wales, 6);
    ASSERT_EQ(lattice.courses, 5);
    for (int course = 0; course < 5; ++course) {
        for (int wale = 0; wale < 6; ++wale) {
            ASSERT_TRUE(lattice.at(wale, course));
            if (wale > 0) {
                EXPECT_NEAR(lattice.at(wale, course)->x() - lattice.at(wale - 1, course)->x(),
                            size.waleSpacingMm, 1e-4);
            }
            if (course > 0) {
                EXPECT_NEAR(lattice.at(wale, course)->y() - lattice.at(wale, course - 1)->y(),
                            size.courseSpacingMm, 1e-4);
            }
        }
    }
}

TEST(StitchLattice, LeavesOutWhereNoLoopIs) {
    // Needle 2 misses the second course; needle 3 never knits, so wales 2 and 4 are neighbours.
    const fabric::Fabric fabric = test::build("in 1\nknit + f0 1\nknit + f1 1\nknit + f2 1\nknit + f4 1\n"
                                              "knit - f4 1\nmiss - f2 1\nknit - f1 1\nknit - f0 1\nout 1\n");
    const StitchLattice lattice = stitchLattice(fabric, test::relaxedLattice(fabric, test::kLoopMm));
    ASSERT_EQ(lattice.wales, 4);
    ASSERT_EQ(lattice.courses, 2);
    EXPECT_TRUE(lattice.at(2, 0));
    EXPECT_FALSE(lattice.at(2, 1));
    EXPECT_TRUE(lattice.at(3, 1));
}

TEST(StitchLattice, OfNothingIsEmpty) {
    EXPECT_EQ(stitchLattice(fabric::Fabric(), {}).wales, 0);
}

} // namespace
} // namespace knittsim::geometry
