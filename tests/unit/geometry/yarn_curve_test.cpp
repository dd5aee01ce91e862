#include "core/geometry/yarn_curve_builder.h"
#include "tests/unit/geometry/plain_case.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace knittsim::geometry {
namespace {

using fabric::PointIndex;
using test::curvesOf;
using test::kDiameterMm;
using test::kLoopMm;
using test::relaxedLattice;

/// Nodes that belong to bonding points first..last.
std::vector<std::size_t> nodesOf(const YarnCurves& curves, PointIndex first, PointIndex last) {
    std::vector<std::size_t> nodes;
    for (std::size_t n = 0; n < curves.point.size(); ++n) {
        if (curves.point[n] >= first && curves.point[n] <= last) {
            nodes.push_back(n);
        }
    }
    return nodes;
}

std::pair<PointIndex, PointIndex> pointsOfLoop(const fabric::Loop& loop) {
    PointIndex first = std::min(loop.headLeft, loop.headRight);
    PointIndex last = std::max(loop.headLeft, loop.headRight);
    if (loop.footLeft >= 0) {
        first = std::min(loop.footLeft, loop.footRight);
        last = std::max(loop.footLeft, loop.footRight);
    }
    return {first, last};
}

/// Seen from the front: does the first strand pass in front (+) or behind (-) where the two cross? In the
/// order along the first strand, in the wale about x = `centre` only.
std::string crossingsSeen(const YarnCurves& curves, const std::vector<std::size_t>& a,
                          const std::vector<std::size_t>& b, float centre) {
    std::string seen;
    for (std::size_t i = 0; i + 1 < a.size(); ++i) {
        for (std::size_t k = 0; k + 1 < b.size(); ++k) {
            if (a[i + 1] != a[i] + 1 || b[k + 1] != b[k] + 1) {
                continue;
            }
            const Vec3f& p = curves.nodes[a[i]];
            const Vec3f& q = curves.nodes[b[k]];
            const Vec3f u = curves.nodes[a[i] + 1] - p;
            const Vec3f v = curves.nodes[b[k] + 1] - q;
            const float det = u.x() * v.y() - u.y() * v.x();
            const Vec3f w = q - p;
            const float s = (w.x() * v.y() - w.y() * v.x()) / det;
            const float t = (w.x() * u.y() - w.y() * u.x()) / det;
            const bool inWale = std::abs(p.x() + s * u.x() - centre) < kLoopMm / 8;
            if (s >= 0 && s < 1 && t >= 0 && t < 1 && inWale) {
                seen += p.z() + s * u.z() > q.z() + t * v.z() ? '+' : '-';
            }
        }
    }
    return seen;
}

/// All pairs of a loop and the loop it was drawn through.
void expectEveryLoopDrawnThrough(const fabric::Fabric& fabric) {
    const YarnCurves curves = curvesOf(fabric);
    int pairs = 0;
    for (std::size_t i = 0; i < fabric.loops.size(); ++i) {
        for (const machine::LoopIndex parent : fabric.made.parentsOf(static_cast<machine::LoopIndex>(i))) {
            const auto [first, last] = pointsOfLoop(fabric.loops[i]);
            const auto [parentFirst, parentLast] =
                pointsOfLoop(fabric.loops[static_cast<std::size_t>(parent)]);
            const bool hasFeet = fabric.loops[static_cast<std::size_t>(parent)].footLeft >= 0;
            if (!hasFeet && (first == parentLast + 1 || parentFirst == 0)) {
                continue; // the yarn turns from the one straight into the other, or begins here
            }
            // The sinker before a loop belongs to the bonding point before it.
            const float centre = static_cast<float>(fabric.made.loops[i].needle.index * kLoopMm / 4);
            const std::string seen = crossingsSeen(curves, nodesOf(curves, first - 1, last),
                                                   nodesOf(curves, parentFirst - 1, parentLast), centre);
            const bool front = fabric.made.loops[i].needle.bed == machine::Bed::Front;
            EXPECT_EQ(seen, front ? "-++-" : "+--+") << "loop " << i << " through " << parent;
            ++pairs;
        }
    }
    EXPECT_EQ(pairs, static_cast<int>(fabric.loops.size()) - 6 - 2);
}

TEST(YarnCurve, plainLoopsPassBehindInFrontInFrontBehind) {
    expectEveryLoopDrawnThrough(test::knit("ffffff", 5));
}

TEST(YarnCurve, reverseLoopsPassTheOtherWay) {
    expectEveryLoopDrawnThrough(test::knit("bbbbbb", 5));
}

TEST(YarnCurve, ribLoopsPassByTheBedTheyWereMadeOn) {
    expectEveryLoopDrawnThrough(test::knit("fbfbbf", 5));
}

TEST(YarnCurve, strandsAreApartAtEveryBondingPoint) {
    const fabric::Fabric fabric = test::knit("ffffff", 6);
    const YarnCurves curves = curvesOf(fabric);
    for (fabric::EntryIndex entry = 0; entry < fabric.entryCount; ++entry) {
        const auto points = fabric.at(entry);
        if (points.size() != 2 || std::abs(points[0] - points[1]) == 1) {
            continue; // at the turn of the first course a yarn meets itself
        }
        float nearest = std::numeric_limits<float>::max();
        for (const std::size_t a : nodesOf(curves, points[0], points[0])) {
            for (const std::size_t b : nodesOf(curves, points[1], points[1])) {
                nearest = std::min(nearest, (curves.nodes[a] - curves.nodes[b]).norm());
            }
        }
        EXPECT_GT(nearest, 0.4 * kDiameterMm) << "entry " << entry;
    }
}

TEST(YarnCurve, isAboutAsLongAsTheYarnThatWasFed) {
    const fabric::Fabric fabric = test::knit("ffffffffff", 10);
    const YarnCurves curves = curvesOf(fabric);
    ASSERT_EQ(curves.yarns.size(), 1U);
    EXPECT_NEAR(curves.arc.back() / (100 * kLoopMm), 1.0, 0.2);
}

TEST(YarnCurve, rearBedFabricIsTheMirrorImageOfFrontBedFabric) {
    const fabric::Fabric front = test::knit("ffff", 4);
    const fabric::Fabric rear = test::knit("bbbb", 4);
    const auto positions = relaxedLattice(front, kLoopMm);
    const YarnCurves a = curvesOf(front, positions);
    const YarnCurves b = curvesOf(rear, positions);
    ASSERT_EQ(a.nodes.size(), b.nodes.size());
    for (std::size_t n = 0; n < a.nodes.size(); ++n) {
        EXPECT_LT((a.nodes[n] - Vec3f(b.nodes[n].x(), b.nodes[n].y(), -b.nodes[n].z())).norm(), 1e-4) << n;
    }
}

TEST(YarnCurve, turnsWithTheFabricInSpace) {
    const fabric::Fabric fabric = test::knit("ffbbf", 4);
    auto positions = relaxedLattice(fabric, kLoopMm);
    const YarnCurves before = curvesOf(fabric, positions);
    const Eigen::Matrix3f turn =
        (Eigen::AngleAxisf(0.9F, Vec3f(1, 2, -1).normalized()) * Eigen::AngleAxisf(2.1F, Vec3f::UnitY()))
            .toRotationMatrix();
    for (std::size_t i = 0; i + 2 < positions.size(); i += 3) {
        Eigen::Map<Vec3f> p(positions.data() + i);
        p = turn * p + Vec3f(3, -7, 11);
    }
    const YarnCurves after = curvesOf(fabric, positions);
    for (std::size_t n = 0; n < before.nodes.size(); ++n) {
        EXPECT_LT((turn * before.nodes[n] + Vec3f(3, -7, 11) - after.nodes[n]).norm(), 1e-3) << n;
    }
}

void expectFinite(const fabric::Fabric& fabric, const std::vector<float>& positions) {
    const std::vector<double> diameters(4, kDiameterMm);
    const YarnCurves curves = buildYarnCurves(fabric, positions, diameters, {.withSurface = true});
    for (std::size_t n = 0; n < curves.nodes.size(); ++n) {
        ASSERT_TRUE(curves.nodes[n].allFinite() && curves.normal[n].allFinite()) << n;
        ASSERT_TRUE(std::isfinite(curves.arc[n]) && std::isfinite(curves.height[n])) << n;
    }
}

TEST(YarnCurve, isFiniteWhereAllPointsCoincide) {
    const fabric::Fabric fabric = test::knit("fbf", 4);
    expectFinite(fabric, std::vector<float>(3 * static_cast<std::size_t>(fabric.entryCount), 4.0F));
}

TEST(YarnCurve, isFiniteWherePositionsAreNot) {
    const fabric::Fabric fabric = test::knit("fbf", 4);
    auto positions = relaxedLattice(fabric, kLoopMm);
    positions[4] = std::numeric_limits<float>::quiet_NaN();
    positions[9] = std::numeric_limits<float>::infinity();
    expectFinite(fabric, positions);
    expectFinite(fabric, {});
}

TEST(YarnCurve, arcLengthRisesAndBondingPointsFollowEachOther) {
    const fabric::Fabric fabric =
        test::build("in 1\nin 2\n" + test::pass("knit", 'f', 5, 1, 1) + test::pass("tuck", 'f', 1, 5, 2, 2) +
                    test::pass("knit", 'f', 5, 1, 1) + "out 1\nout 2\n");
    const YarnCurves curves = curvesOf(fabric);
    ASSERT_EQ(curves.yarns.size(), 2U);
    for (const YarnCurves::Range& yarn : curves.yarns) {
        EXPECT_EQ(curves.arc[static_cast<std::size_t>(yarn.first)], 0);
        for (std::int32_t n = yarn.first + 1; n < yarn.first + yarn.count; ++n) {
            const auto i = static_cast<std::size_t>(n);
            EXPECT_GE(curves.arc[i], curves.arc[i - 1]);
            EXPECT_GE(curves.point[i], curves.point[i - 1]);
            EXPECT_LE(curves.point[i], curves.point[i - 1] + 1);
        }
    }
}

TEST(YarnCurve, builderGivesTheSameAgainAfterAnotherShape) {
    const fabric::Fabric fabric = test::knit("fbff", 4);
    const std::vector<double> diameters(4, kDiameterMm);
    YarnCurveBuilder builder(fabric, diameters);
    const auto positions = relaxedLattice(fabric, kLoopMm);
    const std::vector<Vec3f> first = builder.update(positions).nodes;
    builder.update(relaxedLattice(fabric, 2 * kLoopMm));
    EXPECT_EQ(builder.update(positions).nodes, first);
}

TEST(YarnCurve, slackYarnMakesHigherHeadsUntilItsLimit) {
    // The same loops on a narrower lattice: more yarn is left for the arcs than the chords take.
    const fabric::Fabric fabric = test::knit("fff", 3);
    auto wide = relaxedLattice(fabric, kLoopMm);
    for (std::size_t i = 0; i < wide.size(); i += 3) {
        wide[i] *= 2.2F;
    }
    const auto top = [](const YarnCurves& curves) {
        float y = 0;
        for (const Vec3f& node : curves.nodes) {
            y = std::max(y, node.y());
        }
        return y;
    };
    EXPECT_GT(top(curvesOf(fabric)), top(curvesOf(fabric, wide)));
}

} // namespace
} // namespace knittsim::geometry
