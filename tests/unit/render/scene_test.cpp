#include "core/fabric/fabric_builder.h"
#include "core/fabric/reduction.h"
#include "core/formats/formats.h"
#include "core/geometry/crossing_audit.h"
#include "tests/support/build.h"
#include "tests/support/lattice.h"
#include "tests/support/random_program.h"
#include "ui/render/camera.h"
#include "ui/render/scene_chunks.h"
#include "ui/render/scene_picking.h"
#include "ui/render/scene_worker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <semaphore>

namespace knittsim::render {
namespace {

std::shared_ptr<const fabric::Fabric> makeFabric(int courses = 4) {
    std::string lines = "in 1\nin 2\n";
    for (int course = 0; course < courses; ++course) {
        const int carrier = course % 2 + 1;
        lines +=
            course % 4 < 2 ? test::pass("knit", 'f', 5, 0, carrier) : test::pass("knit", 'f', 0, 5, carrier);
    }
    return std::make_shared<fabric::Fabric>(test::build(lines + "out 1\nout 2\n"));
}

YarnLook lookWith(double diameterMm) {
    YarnLook look;
    look.diameterMm = diameterMm;
    return look;
}

TEST(FabricScene, everyYarnBeginsWhereEveryStrideMeetsIt) {
    for (const DrawStyle style : {DrawStyle::Yarn, DrawStyle::Mesh}) {
        FabricScene scene(makeFabric(), {}, style);
        const auto frame = scene.prepare({});
        const SceneTopology& topology = *frame->topology;
        ASSERT_EQ(topology.yarns.size(), 2U);
        EXPECT_EQ(frame->nodes.size(), topology.owner.size());
        EXPECT_EQ(frame->surface.size(), topology.owner.size());
        std::vector<bool> used(frame->nodes.size(), false);
        for (const auto& yarn : topology.yarns) {
            EXPECT_EQ(yarn.first % kMostStride, 0);
            for (std::int32_t n = yarn.first; n < yarn.first + yarn.count; ++n) {
                used[static_cast<std::size_t>(n)] = true;
                EXPECT_GE(frame->nodes[static_cast<std::size_t>(n)][3], 0);
            }
        }
        for (std::size_t n = 0; n < used.size(); ++n) {
            EXPECT_TRUE(used[n] || frame->nodes[n][3] < 0)
                << "shaders must see that node " << n << " is none";
        }
    }
}

TEST(IsolatedScene, keepsTheWantedPointsOnlyAndAllTheRules) {
    const auto fabric = makeFabric();
    for (const DrawStyle style : {DrawStyle::Yarn, DrawStyle::Mesh}) {
        FabricScene scene(fabric, {}, style);
        const auto whole = scene.prepare({});
        std::vector<bool> keep;
        for (const fabric::BondingPoint& point : fabric->points) {
            keep.push_back(fabric->loops[static_cast<std::size_t>(point.loop)].course == 1);
        }
        const auto part = isolated(*whole, *fabric, keep);
        EXPECT_EQ(part->bounds.low, whole->bounds.low);
        EXPECT_EQ(part->nodes.size(), part->topology->owner.size());
        EXPECT_EQ(part->surface.size(), part->nodes.size());
        EXPECT_EQ(part->topology->pointCount, fabric->points.size());
        std::size_t nodes = 0;
        std::size_t strange = 0; // the end of each run belongs to the next point
        for (const geometry::YarnCurves::Range& yarn : part->topology->yarns) {
            EXPECT_EQ(yarn.first % kMostStride, 0);
            EXPECT_LT(part->nodes[static_cast<std::size_t>(yarn.first) - 1][3], 0) << "a gap before each run";
            for (std::int32_t n = yarn.first; n < yarn.first + yarn.count; ++n) {
                ++nodes;
                strange += keep[part->topology->owner[static_cast<std::size_t>(n)]] ? 0U : 1U;
            }
        }
        std::size_t wanted = 0;
        for (const geometry::YarnCurves::Range& yarn : whole->topology->yarns) {
            for (std::int32_t n = yarn.first; n < yarn.first + yarn.count; ++n) {
                wanted += keep[whole->topology->owner[static_cast<std::size_t>(n)]] ? 1U : 0U;
            }
        }
        EXPECT_GT(wanted, 0U);
        EXPECT_EQ(nodes, wanted + strange);
        EXPECT_LE(strange, part->topology->yarns.size());
        EXPECT_LT(part->markers.size(), std::max<std::size_t>(1, whole->markers.size()));
    }
}

TEST(IsolatedScene, ofNothingIsEmpty) {
    const auto fabric = makeFabric();
    FabricScene scene(fabric, {}, DrawStyle::Yarn);
    const auto part = isolated(*scene.prepare({}), *fabric, std::vector<bool>(fabric->points.size(), false));
    EXPECT_TRUE(part->nodes.empty());
    EXPECT_TRUE(part->chunks.empty());
}

TEST(FabricScene, improvingPutsTheRightStrandInFront) {
    const std::string file = std::string(KNITTSIM_SOURCE_DIR) + "/resources/patterns/racked-rib.k";
    const auto program = formats::readProgram(file);
    ASSERT_TRUE(program);
    const auto fabric =
        std::make_shared<fabric::Fabric>(fabric::buildFabric({program.value(), machine::genericProfile()}));
    FabricScene scene(fabric, {}, DrawStyle::Yarn);
    const auto wrong = [&] {
        scene.prepare({});
        return geometry::auditCrossings(*fabric, scene.curves(), geometry::projectCrossings(scene.curves()))
            .faults.size();
    };
    EXPECT_GT(wrong(), 0U) << "the sample asks for nothing";
    while (scene.improve()) {
    }
    EXPECT_EQ(wrong(), 0U);
    EXPECT_FALSE(scene.improve()) << "all is right";
}

TEST(FabricScene, drawsCurvesThatSomebodyElseHasMade) {
    geometry::YarnCurves curves;
    for (int i = 0; i < 7; ++i) {
        curves.nodes.emplace_back(static_cast<float>(i), 2.0F, 0.5F);
        curves.point.push_back(i / 2);
        curves.piece.push_back(i / 2);
        curves.arc.push_back(static_cast<float>(i));
        curves.normal.emplace_back(0.0F, 0.0F, 1.0F);
        curves.height.push_back(0.5F);
    }
    curves.yarns = {{0, 3, 0}, {3, 4, 1}};
    FabricScene scene(makeFabric(), {}, DrawStyle::Yarn);
    const auto frame = scene.prepareCurves(curves);
    ASSERT_EQ(frame->topology->yarns.size(), 2U);
    const auto& second = frame->topology->yarns[1];
    const int times = (second.count - 1) / 3; // small fabrics get more nodes
    EXPECT_GT(times, 1);
    for (int i = 0; i < 4; ++i) {
        const auto node = static_cast<std::size_t>(second.first + times * i);
        EXPECT_EQ(frame->nodes[node][0], static_cast<float>(3 + i));
        EXPECT_EQ(frame->topology->owner[node], (3 + i) / 2);
    }
    EXPECT_FLOAT_EQ(frame->bounds.low.x(), -0.5F * frame->diameters[0]);
    // The scene itself still knows its own curves.
    EXPECT_GT(scene.prepare({})->nodes.size(), 20U);
}

TEST(FabricScene, aCrossingTellsTheWayOfBothStrands) {
    // Two loops change places; the one from needle 0 goes to the right in front of the other.
    const auto fabric = std::make_shared<fabric::Fabric>(
        test::build("in 1\n" + test::pass("knit", 'f', 0, 1, 1) + test::pass("knit", 'f', 1, 0, 1) +
                    "xfer f0 b0\nxfer f1 b1\nrack 1\nxfer b0 f1\nrack -1\nxfer b1 f0\nrack 0\n" +
                    test::pass("knit", 'f', 0, 1, 1)));
    FabricScene scene(fabric, {}, DrawStyle::Mesh);
    const auto frame = scene.prepare({});
    ASSERT_EQ(frame->markers.size(), static_cast<std::size_t>(fabric->entryCount));
    // Upwards, whichever way the yarn runs.
    const auto lean = [](const std::array<float, 3>& way) { return way[0] / way[1]; };
    for (const fabric::Crossing& crossing : fabric->crossings) {
        const auto entry = fabric->points[static_cast<std::size_t>(crossing.over)].entry;
        const Marker& marker = frame->markers[static_cast<std::size_t>(entry)];
        EXPECT_EQ(marker.kind, Marker::Crossing);
        const float over = lean(marker.front);
        const float under = lean(marker.behind);
        EXPECT_GT(over * static_cast<float>(crossing.sign), under * static_cast<float>(crossing.sign));
    }
    const auto countOf = [&](Marker::Kind kind) {
        return std::ranges::count(frame->markers, kind, &Marker::kind);
    };
    EXPECT_EQ(countOf(Marker::Crossing), 4);
    EXPECT_EQ(countOf(Marker::Bond), 8) << "twice two loops drawn through two";
    EXPECT_EQ(countOf(Marker::OpenHead), 4) << "two loops on the needles";
}

TEST(FabricScene, aFabricWithLaddersIsDrawnInEveryStyle) {
    for (const unsigned seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
        const machine::Timeline machine(test::randomProgram({.seed = seed, .operations = 800}),
                                        machine::genericProfile());
        const fabric::Fabric whole = fabric::buildFabric(machine);
        for (const bool holder : {true, false}) {
            const auto reduced = fabric::removeRuns(whole, fabric::findRuns(whole, {.stitchHolder = holder}));
            const auto left = std::make_shared<fabric::Fabric>(reduced.fabric);
            for (const DrawStyle style : {DrawStyle::Yarn, DrawStyle::Mesh}) {
                FabricScene scene(left, {}, style);
                const auto frame = scene.prepare({});
                EXPECT_EQ(frame->markers.empty(), style == DrawStyle::Yarn || left->entryCount == 0);
                for (const auto& node : frame->nodes) {
                    ASSERT_TRUE(std::ranges::all_of(node, [](float v) { return std::isfinite(v); }));
                }
            }
        }
    }
}

TEST(FabricScene, piecesCoverEachSegmentOnceAndHoldTheirNodes) {
    FabricScene scene(makeFabric(), {}, DrawStyle::Yarn);
    const auto frame = scene.prepare({});
    std::vector<int> covered(frame->nodes.size(), 0);
    for (const Chunk& chunk : frame->chunks) {
        EXPECT_EQ(chunk.firstNode % kMostStride, 0);
        for (std::int32_t n = chunk.firstNode; n < chunk.firstNode + chunk.count; ++n) {
            const auto& node = frame->nodes[static_cast<std::size_t>(n)];
            EXPECT_LE((Vec3f(node[0], node[1], node[2]) - chunk.centre).norm(), chunk.reach * 1.0001F);
            covered[static_cast<std::size_t>(n)] += n + 1 < chunk.firstNode + chunk.count ? 1 : 0;
        }
    }
    for (const auto& yarn : frame->topology->yarns) {
        for (std::int32_t n = yarn.first; n + 1 < yarn.first + yarn.count; ++n) {
            EXPECT_EQ(covered[static_cast<std::size_t>(n)], 1) << n;
        }
    }
}

TEST(FabricScene, boundsHoldTheYarnWithItsThickness) {
    const std::vector<YarnLook> looks(2, lookWith(1));
    FabricScene scene(makeFabric(), looks, DrawStyle::Yarn);
    const auto frame = scene.prepare({});
    Vec3f high = Vec3f::Constant(-1e9F);
    for (const auto& node : frame->nodes) {
        if (node[3] >= 0) {
            high = high.cwiseMax(Vec3f(node[0], node[1], node[2]));
        }
    }
    EXPECT_LT((frame->bounds.high - high - Vec3f::Constant(0.5F)).norm(), 1e-4);
}

TEST(FabricScene, emptyFabricGivesAnEmptyFrame) {
    FabricScene scene(std::make_shared<fabric::Fabric>(test::build("in 1\nout 1\n")), {}, DrawStyle::Yarn);
    const auto frame = scene.prepare({});
    EXPECT_TRUE(frame->chunks.empty());
    EXPECT_TRUE(frame->bounds.empty());
}

TEST(ScenePicking, agreesWithLookingAtAllTheYarn) {
    const auto fabric = makeFabric(6);
    const auto positions = test::relaxedLattice(*fabric, 5);
    const std::vector<YarnLook> looks(2, lookWith(0.5));
    FabricScene scene(fabric, looks, DrawStyle::Yarn);
    const auto frame = scene.prepare(positions);
    const std::vector<double> diameters(2, 0.5);
    Camera camera;
    camera.setViewport(300, 200);
    camera.setScene(frame->bounds);
    camera.fit(frame->bounds);
    int hits = 0;
    for (float y = 3; y < 200; y += 13) {
        for (float x = 2; x < 300; x += 11) {
            const geometry::Ray ray = camera.rayAt(x, y);
            const auto quick = pickScene(*frame, *fabric, ray, 0);
            const auto slow = geometry::pickYarn(*fabric, scene.curves(), diameters, ray);
            ASSERT_EQ(quick.has_value(), slow.has_value()) << x << ' ' << y;
            if (quick) {
                EXPECT_EQ(quick->point, slow->point) << x << ' ' << y;
                EXPECT_NEAR(quick->depth, slow->depth, 1e-3);
                ++hits;
            }
        }
    }
    EXPECT_GT(hits, 100);
}

TEST(SceneWorker, givesTheLatestJobInTheEnd) {
    std::counting_semaphore<> ready(0);
    SceneWorker worker([&] { ready.release(); });
    const auto first = makeFabric(2);
    const auto last = makeFabric(5);
    for (int i = 0; i < 50; ++i) {
        worker.post({.fabric = first, .looks = {}, .style = DrawStyle::Yarn, .shape = nullptr});
    }
    worker.post({.fabric = last, .looks = {}, .style = DrawStyle::Mesh, .shape = nullptr});
    std::optional<SceneWorker::Picture> picture;
    while (!picture || picture->fabric != last) {
        ready.acquire();
        if (auto next = worker.take()) {
            picture = std::move(next);
        }
    }
    EXPECT_EQ(picture->scene->style, DrawStyle::Mesh);
    EXPECT_EQ(picture->scene->markers.size(), static_cast<std::size_t>(last->entryCount));
    EXPECT_FALSE(worker.take());
}

TEST(SceneWorker, takesShapesOfTheSameSizeOnly) {
    std::counting_semaphore<> ready(0);
    SceneWorker worker([&] { ready.release(); });
    const auto fabric = makeFabric();
    auto shape = std::make_shared<simulation::Frame>();
    shape->positions.assign(3 * static_cast<std::size_t>(fabric->entryCount), 7.0F);
    const auto highest = [&](std::shared_ptr<const simulation::Frame> frame) {
        worker.post({.fabric = fabric, .looks = {}, .style = DrawStyle::Mesh, .shape = std::move(frame)});
        ready.acquire();
        return worker.take()->scene->markers[0].place[1];
    };
    const float onMachine = highest(nullptr);
    EXPECT_EQ(highest(shape), 7.0F);
    auto foreign = std::make_shared<simulation::Frame>(*shape);
    foreign->positions.pop_back();
    EXPECT_EQ(highest(foreign), onMachine);
}

TEST(FabricScene, valuesTravelWithTheNodesOfTheirPoints) {
    const auto fabric = makeFabric();
    std::vector<float> values;
    for (std::size_t p = 0; p < fabric->points.size(); ++p) {
        values.push_back(static_cast<float>(p));
    }
    for (const DrawStyle style : {DrawStyle::Yarn, DrawStyle::Mesh}) {
        FabricScene scene(fabric, {}, style);
        const auto plain = scene.prepare({});
        const auto frame = scene.prepare({}, values);
        EXPECT_TRUE(plain->range.empty());
        ASSERT_FALSE(frame->range.empty());
        for (const auto& yarn : frame->topology->yarns) {
            for (auto n = static_cast<std::size_t>(yarn.first);
                 n < static_cast<std::size_t>(yarn.first + yarn.count); ++n) {
                const float told = static_cast<float>(frame->surface[n][1] >> 22) / 1023;
                const float value = values[frame->topology->owner[n]];
                EXPECT_NEAR(told, frame->range.shareOf(value), 0.001) << n;
                EXPECT_EQ(frame->surface[n][1] & 0x3fffffU, plain->surface[n][1] & 0x3fffffU);
            }
        }
        EXPECT_TRUE(scene.prepare({}, std::vector<float>(3, 1.0F))->range.empty()) << "of another fabric";
    }
}

} // namespace
} // namespace knittsim::render
