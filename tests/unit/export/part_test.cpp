#include "core/export/shape.h"
#include "tests/unit/export/swatch.h"

#include <algorithm>

namespace knittsim::exports {
namespace {

std::vector<bool> courseOf(const fabric::Fabric& fabric, int course) {
    std::vector<bool> keep;
    for (const fabric::BondingPoint& point : fabric.points) {
        keep.push_back(point.loop >= 0 &&
                       fabric.loops[static_cast<std::size_t>(point.loop)].course == course);
    }
    return keep;
}

TEST(PartOf, NothingIsTakenAwayWhereNothingIsAskedFor) {
    const Shape whole = swatch();
    const Shape same = partOf(whole, {});
    EXPECT_EQ(same.curves.nodes.size(), whole.curves.nodes.size());
    EXPECT_EQ(same.curves.yarns.size(), whole.curves.yarns.size());
}

TEST(PartOf, ACourseIsCutOutOfItsYarn) {
    const Shape whole = swatch();
    const std::vector<bool> keep = courseOf(*whole.fabric, 3);
    const Shape part = partOf(whole, keep);
    ASSERT_FALSE(part.curves.yarns.empty());
    EXPECT_LT(part.curves.nodes.size(), whole.curves.nodes.size() / 4);
    for (const geometry::YarnCurves::Range& yarn : part.curves.yarns) {
        const auto first = static_cast<std::size_t>(yarn.first);
        const auto last = first + static_cast<std::size_t>(yarn.count) - 1;
        EXPECT_EQ(yarn.carrier, 1); // courses 2 and 3 are of the second yarn
        EXPECT_EQ(part.curves.arc[first], 0);
        float length = 0;
        for (std::size_t n = first; n < last; ++n) {
            EXPECT_TRUE(keep[static_cast<std::size_t>(part.curves.point[n])]);
            length += (part.curves.nodes[n + 1] - part.curves.nodes[n]).norm();
        }
        EXPECT_NEAR(part.curves.arc[last], length, 1e-3F * length);
    }
}

TEST_F(ExportTest, EveryFormatHasThePartAndNothingElse) {
    const Shape whole = swatch();
    const Shape part = partOf(whole, courseOf(*whole.fabric, 3));
    for (const char* name : {"a.obj", "a.gltf", "a.glb", "a.bcc", "a.svg", "a.csv"}) {
        const std::size_t all = written(name, whole).size();
        const std::size_t some = written(name, part).size();
        EXPECT_GT(some, 0U) << name;
        EXPECT_LT(some, all / 2) << name;
    }
    const std::string table = written("b.csv", part);
    EXPECT_EQ(std::ranges::count(table, '\n') - 1, std::ranges::count(part.keep, true));
}

} // namespace
} // namespace knittsim::exports
