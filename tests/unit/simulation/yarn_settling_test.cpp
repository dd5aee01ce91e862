#include "core/base/segment_distance.h"
#include "core/fabric/fabric_builder.h"
#include "core/geometry/curve_report.h"
#include "core/pattern/samples.h"
#include "core/pattern/swatch.h"
#include "core/simulation/yarn_settling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace knittsim::simulation {
namespace {

using physics::Entry;

fabric::Fabric build(const machine::Program& program) {
    return fabric::buildFabric(machine::Timeline(program, machine::genericProfile()));
}

/// Wale and course spacing without two wales and courses at each edge.
geometry::Measurement measureInner(const fabric::Fabric& f, const YarnSettling& settling) {
    const std::vector<float> positions = entryPositions(f, settling.yarns(), settling.shape());
    const geometry::Measurement whole = geometry::measure(f, positions);
    return geometry::measure(f, positions, {2, whole.wales - 3, 2, whole.courses - 3});
}

/// Mean height of the nodes of a wale over the courses in the middle, mm.
double waleHeight(const fabric::Fabric& f, const YarnSettling& settling, int needle) {
    double sum = 0;
    int count = 0;
    const FabricYarns& yarns = settling.yarns();
    for (std::size_t e = 0; e < yarns.piece.size(); ++e) {
        const auto loop = static_cast<std::size_t>(f.points[static_cast<std::size_t>(yarns.piece[e])].loop);
        const int course = f.loops[loop].course;
        if (f.made.loops[loop].needle.index == needle && course >= 4 && course < f.courseCount - 4) {
            sum += physics::at(settling.shape(), static_cast<Entry>(e)).z() * yarns.units.lengthMm;
            ++count;
        }
    }
    return sum / count;
}

class YarnLayoutTest : public ::testing::TestWithParam<const char*> {};

/// Before anything moves, the chains cross as the fabric's books say, and every loop is drawn through those
/// below it.
TEST_P(YarnLayoutTest, HasTheTopologyOfTheFabric) {
    const fabric::Fabric f = build(pattern::makeSample(GetParam()));
    const FabricYarns yarns = layYarns(f, {}, {.nodesPerLoop = 36});
    ASSERT_STREQ(yarns.chains.problem(), "");
    const geometry::YarnCurves curves = curvesOf(yarns, yarns.chains.start());
    const auto crossings = geometry::auditCrossings(f, curves, geometry::projectCrossings(curves));
    EXPECT_EQ(crossings.found, crossings.expected);
    EXPECT_TRUE(geometry::certifyTopology(f, curves).holds());
}

TEST_P(YarnLayoutTest, HasTheYarnThatTheMachineFed) {
    const fabric::Fabric f = build(pattern::makeSample(GetParam()));
    const FabricYarns yarns = layYarns(f, {});
    const double fed = std::accumulate(f.lengths.begin(), f.lengths.end(), 0.0);
    double rest = 0;
    for (const physics::Chain& chain : yarns.chains.chains) {
        for (Entry i = 0; i < chain.segmentCount(); ++i) {
            rest += yarns.chains.restLength[static_cast<std::size_t>(chain.first + i)];
        }
    }
    EXPECT_NEAR(rest * yarns.units.lengthMm / fed, 1, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Samples, YarnLayoutTest,
                         ::testing::Values("plain", "rib-1x1", "garter", "seed", "cable-left", "lace",
                                           "tuck"),
                         [](const auto& info) {
                             std::string name = info.param;
                             std::erase(name, '-');
                             return name;
                         });

TEST(FabricYarns, LeaveOutEverySecondNodeAndKeepTheRest) {
    const fabric::Fabric f = build(pattern::makePlain(6, 6));
    const FabricYarns dense = layYarns(f, {}, {.nodesPerLoop = 36});
    const FabricYarns half = withHalfTheNodes(f, dense, dense.chains.start());
    ASSERT_STREQ(half.chains.problem(), "");
    EXPECT_EQ((dense.chains.nodeCount() + 2) / 2, half.chains.nodeCount());
    EXPECT_EQ(half.chains.nodes.col(7), dense.chains.nodes.col(14));
    EXPECT_EQ(half.piece[7], dense.piece[14]);
    EXPECT_DOUBLE_EQ(half.chains.restLength[3], dense.chains.restLength[6] + dense.chains.restLength[7]);
    for (std::size_t p = 0; p < half.nodeOfPoint.size(); ++p) {
        EXPECT_EQ(half.nodeOfPoint[p], dense.nodeOfPoint[p] / 2);
    }
}

TEST(FabricYarns, KnowEachYarnOfAFabricOfTwo) {
    std::vector<yarn::Yarn> materials(10);
    materials[1].outerDiameterMm = 0.5;
    materials[1].coreDiameterMm = 0.3;
    materials[1].bendingStiffness = 20;
    const fabric::Fabric f = build(pattern::makeSample("float-jacquard"));
    const FabricYarns yarns = layYarns(f, materials);
    ASSERT_GE(yarns.chains.chains.size(), 2U);
    std::vector<machine::CarrierIndex> carriers;
    for (std::size_t c = 0; c < yarns.chains.chains.size(); ++c) {
        const auto yarn = static_cast<std::size_t>(yarns.chains.chains[c].yarn);
        EXPECT_EQ(yarn, yarns.carrier[c]);
        EXPECT_NEAR(yarns.chains.yarns[yarn].outerDiameter * yarns.units.lengthMm,
                    materials[yarn].outerDiameterMm, 1e-12);
        EXPECT_NEAR(yarns.chains.yarns[yarn].bendingStiffness * yarns.units.bendingStiffness,
                    materials[yarn].bendingStiffness, 1e-12);
        carriers.push_back(yarns.carrier[c]);
    }
    EXPECT_NE(carriers[0], carriers[1]);
}

TEST(FabricYarns, KeepTheNodesThatMustStay) {
    const fabric::Fabric f = build(pattern::makePlain(6, 6));
    const FabricYarns dense = layYarns(f, {}, {.nodesPerLoop = 36});
    std::vector<char> kept(static_cast<std::size_t>(dense.chains.nodeCount()), 0);
    kept[15] = 1;
    const FabricYarns half = withHalfTheNodes(f, dense, dense.chains.start(), kept);
    ASSERT_STREQ(half.chains.problem(), "");
    EXPECT_EQ((dense.chains.nodeCount() + 2) / 2 + 1, half.chains.nodeCount());
    EXPECT_EQ(half.chains.nodes.col(8), dense.chains.nodes.col(15));
    EXPECT_EQ(half.chains.nodes.col(9), dense.chains.nodes.col(16));
    EXPECT_DOUBLE_EQ(half.chains.restLength[7], dense.chains.restLength[14]);
    EXPECT_DOUBLE_EQ(half.chains.restLength[9], dense.chains.restLength[16] + dense.chains.restLength[17]);
    const auto yarnOf = [](const FabricYarns& yarns) { return physics::arcLengths(yarns.chains).back(); };
    EXPECT_NEAR(yarnOf(half), yarnOf(dense), 1e-9);
}

class Plain12 : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        s_fabric = new fabric::Fabric(build(pattern::makePlain(12, 12)));
        s_settling = new YarnSettling(*s_fabric, {}, {});
        while (s_settling->step({})) {
        }
    }
    static void TearDownTestSuite() {
        delete s_settling;
        delete s_fabric;
        s_settling = nullptr;
        s_fabric = nullptr;
    }
    inline static fabric::Fabric* s_fabric = nullptr;
    inline static YarnSettling* s_settling = nullptr;
};

TEST_F(Plain12, ComesToRestWithoutOverlap) {
    EXPECT_EQ(s_settling->phase(), YarnSettling::Phase::Done);
    EXPECT_EQ(s_settling->report().verdict, physics::StopRule::Verdict::ResidualReached);
    const YarnAudit audit = s_settling->audit();
    EXPECT_EQ(audit.coreOverlaps, 0);
    EXPECT_GT(audit.expectedCrossings, 500U);
    EXPECT_EQ(audit.laidCrossings, audit.expectedCrossings);
    EXPECT_EQ(audit.passThroughs(), 0U);
    // Away from the edges, where loops roll up, the shape itself shows that every loop is drawn through.
    for (const geometry::PullThrough& doubt :
         geometry::certifyTopology(*s_fabric, s_settling->curves()).failures) {
        const int needle = s_fabric->made.loops[static_cast<std::size_t>(doubt.loop)].needle.index;
        const int course = s_fabric->loops[static_cast<std::size_t>(doubt.loop)].course;
        EXPECT_TRUE(needle <= 3 || needle >= 10 || course <= 2 || course >= 10) << needle << ' ' << course;
    }
}

/// PHYSICS 3: kc 5.0 to 5.8, kw 3.7 to 4.4, kc/kw 1.2 to 1.42 (Munden and followers).
TEST_F(Plain12, HasTheSpacingsOfTheLiterature) {
    const geometry::Measurement inner = measureInner(*s_fabric, *s_settling);
    const double kw = inner.loopLengthMm / inner.waleSpacingMm;
    const double kc = inner.loopLengthMm / inner.courseSpacingMm;
    EXPECT_GT(kw, 3.7);
    EXPECT_LT(kw, 4.4);
    EXPECT_GT(kc, 5.0);
    EXPECT_LT(kc, 5.8);
    EXPECT_GT(kc / kw, 1.2);
    EXPECT_LT(kc / kw, 1.42);
}

TEST_F(Plain12, IsAsLongInYarnAsItWasFed) {
    const geometry::YarnCurves curves = s_settling->curves();
    const double fed = std::accumulate(s_fabric->lengths.begin(), s_fabric->lengths.end(), 0.0);
    EXPECT_NEAR(curves.arc.back() / fed, 1, 0.01);
}

TEST(YarnSettling, OneByOneRibIsNarrowerThanPlain) {
    double spacing[2] = {0, 0};
    for (const int purls : {0, 1}) {
        const fabric::Fabric f = build(purls == 0 ? pattern::makePlain(12, 12) : pattern::makeRib(12, 12));
        YarnSettling settling(f, {}, {});
        while (settling.step({})) {
        }
        spacing[purls] = measureInner(f, settling).waleSpacingMm;
    }
    EXPECT_LT(spacing[1], 0.95 * spacing[0]);
}

/// Without a table the sides of plain knit curl to the back.
TEST(YarnSettling, SidesOfPlainCurlToTheBack) {
    const fabric::Fabric f = build(pattern::makePlain(14, 14));
    YarnSettling settling(f, {}, {.surroundings = Surroundings::Free});
    while (settling.step({})) {
    }
    const double middle = waleHeight(f, settling, 7);
    for (const int edge : {1, 14}) {
        EXPECT_LT(waleHeight(f, settling, edge), middle - 0.1) << edge;
    }
}

/// No two segments come nearer in a step than the guard allows: to 0.4 of their distance.
TEST(YarnSettling, LetsNoStrandPassThroughAnother) {
    const fabric::Fabric f = build(pattern::makeRib(6, 6));
    YarnSettling settling(f, {}, {.surroundings = Surroundings::Free});
    int checked = 0;
    physics::Vector old;
    for (int step = 0; step < 100; ++step) {
        const bool settled = settling.phase() == YarnSettling::Phase::Settling;
        old = settling.shape();
        if (!settling.step({})) {
            break;
        }
        if (!settled) {
            continue;
        }
        const physics::Vector move = settling.shape() - old;
        const Entry nodes = settling.yarns().chains.nodeCount();
        const auto distance = [&](const physics::Vector& x, Entry a, Entry b) {
            return closestPoints(physics::at(x, a), physics::at(x, a + 1), physics::at(x, b),
                                 physics::at(x, b + 1))
                .distance;
        };
        const physics::Vector halfWay = old + 0.5 * move;
        for (Entry a = 0; a + 1 < nodes; ++a) {
            for (Entry b = a + 2; b + 1 < nodes; ++b) {
                if ((physics::at(old, a) - physics::at(old, b)).squaredNorm() > 9) {
                    continue;
                }
                const double start = distance(old, a, b);
                ++checked;
                ASSERT_GE(distance(halfWay, a, b), 0.399 * start) << "step " << step;
                ASSERT_GE(distance(settling.shape(), a, b), 0.399 * start) << "step " << step;
            }
        }
    }
    EXPECT_GT(checked, 100'000);
}

/// A small swatch at rest, and what a person may do with it.
class Handled : public ::testing::Test {
protected:
    void settle() {
        while (m_settling.step({})) {
        }
        ASSERT_EQ(m_settling.phase(), YarnSettling::Phase::Done);
    }
    Eigen::Vector3d placeOf(fabric::PointIndex point) const {
        const Entry node = m_settling.yarns().nodeOfPoint[static_cast<std::size_t>(point)];
        return m_settling.yarns().units.lengthMm * physics::at(m_settling.shape(), node);
    }
    fabric::PointIndex middlePoint() const {
        return static_cast<fabric::PointIndex>(m_fabric.points.size() / 2);
    }

    fabric::Fabric m_fabric = build(pattern::makePlain(8, 8));
    YarnSettling m_settling{m_fabric, {}, {}};
};

TEST_F(Handled, ThickerYarnGoesOnFromTheShapeToTheSizeOfItsOwnFabric) {
    settle();
    const physics::Vector shape = m_settling.shape();
    yarn::Yarn thick;
    thick.outerDiameterMm *= 1.3;
    thick.coreDiameterMm *= 1.3;
    for (machine::CarrierIndex c = 0; c < m_settling.yarns().chains.yarns.size(); ++c) {
        m_settling.setYarn(c, thick);
    }
    EXPECT_EQ(m_settling.shape(), shape);
    EXPECT_EQ(m_settling.phase(), YarnSettling::Phase::Settling);
    settle();
    EXPECT_EQ(m_settling.audit().coreOverlaps, 0);
    const std::vector<yarn::Yarn> thickOnes(10, thick);
    YarnSettling fresh(m_fabric, thickOnes, {});
    while (fresh.step({})) {
    }
    const geometry::Measurement own = measureInner(m_fabric, fresh);
    const geometry::Measurement swapped = measureInner(m_fabric, m_settling);
    // Of four by four stitches, which friction holds a little where they came from.
    EXPECT_NEAR(swapped.waleSpacingMm / own.waleSpacingMm, 1, 0.1);
    EXPECT_NEAR(swapped.courseSpacingMm / own.courseSpacingMm, 1, 0.1);
    EXPECT_NEAR(m_settling.yarns().chains.yarns.back().outerDiameter, 1.3, 1e-12);
}

TEST_F(Handled, AnotherYarnWhileYarnsGrowIsTheOneThatGrows) {
    yarn::Yarn thin;
    thin.outerDiameterMm *= 0.8;
    thin.coreDiameterMm *= 0.8;
    m_settling.step({});
    for (machine::CarrierIndex c = 0; c < m_settling.yarns().chains.yarns.size(); ++c) {
        m_settling.setYarn(c, thin);
    }
    settle();
    EXPECT_NEAR(m_settling.yarns().chains.yarns.back().outerDiameter, 0.8, 1e-12);
    EXPECT_EQ(m_settling.audit().coreOverlaps, 0);
}

TEST_F(Handled, CarriersWithoutYarnAreIgnored) {
    settle();
    m_settling.setYarn(200, yarn::Yarn());
    EXPECT_EQ(m_settling.phase(), YarnSettling::Phase::Done);
}

TEST_F(Handled, APullMovesYarnTowardsItsTargetAndPinsHold) {
    settle();
    const fabric::PointIndex pulled = middlePoint();
    const fabric::PointIndex pinned = 1;
    const Eigen::Vector3d before = placeOf(pulled);
    const Eigen::Vector3d held = placeOf(pinned);
    const Eigen::Vector3d target = before + Eigen::Vector3d(0, 0, 3);
    m_settling.setPinned(pinned, true);
    m_settling.drag(pulled, target);
    settle();
    EXPECT_LT((placeOf(pulled) - target).norm(), 0.8 * (before - target).norm());
    EXPECT_LT((placeOf(pinned) - held).norm(), 1e-12);
    EXPECT_EQ(m_settling.audit().coreOverlaps, 0);
    const double stretched = (placeOf(pulled) - target).norm();
    m_settling.release();
    settle();
    EXPECT_GT((placeOf(pulled) - target).norm(), stretched);
    m_settling.setPinned(pinned, false);
    settle();
    EXPECT_GT((placeOf(pinned) - held).norm(), 0);
}

TEST_F(Handled, HangingYarnOfMoreWeightHangsLonger) {
    const auto length = [&] {
        const FabricYarns& yarns = m_settling.yarns();
        double low = 1e9;
        for (Entry e = 0; e < yarns.chains.nodeCount(); ++e) {
            low = std::min(low, physics::at(m_settling.shape(), e).y());
        }
        return physics::at(m_settling.shape(), topNodes(m_fabric, yarns).front()).y() - low;
    };
    m_settling.setSurroundings(Surroundings::Hanging);
    settle();
    const physics::Vector shape = m_settling.shape();
    const double light = length();
    yarn::Yarn heavy;
    heavy.tex *= 3000;
    for (machine::CarrierIndex c = 0; c < m_settling.yarns().chains.yarns.size(); ++c) {
        m_settling.setYarn(c, heavy);
    }
    settle();
    EXPECT_GT(length(), 1.1 * light);
    for (const Entry e : topNodes(m_fabric, m_settling.yarns())) {
        EXPECT_EQ(physics::at(m_settling.shape(), e), physics::at(shape, e));
    }
}

TEST_F(Handled, OnATableNothingSinksInAndPinnedEdgesStay) {
    settle();
    m_settling.setSurroundings(Surroundings::Pinned);
    const physics::Vector before = m_settling.shape();
    settle();
    for (const Entry e : edgeNodes(m_fabric, m_settling.yarns())) {
        EXPECT_EQ(physics::at(m_settling.shape(), e), physics::at(before, e));
    }
    const auto lowest = [&] {
        double low = 1e9;
        for (Entry e = 0; e < m_settling.yarns().chains.nodeCount(); ++e) {
            low = std::min(low, physics::at(m_settling.shape(), e).z());
        }
        return low;
    };
    const double floor = lowest();
    m_settling.setSurroundings(Surroundings::Table);
    settle();
    EXPECT_GT(lowest(), floor - 0.1); // d
    EXPECT_EQ(m_settling.audit().coreOverlaps, 0);
}

TEST(Surroundings, AreListedInTheOrderOfTheirValues) {
    const auto kinds = surroundingsKinds();
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        EXPECT_EQ(static_cast<std::size_t>(kinds[i].value), i);
    }
}

TEST(YarnSettling, StopsWhenItIsAskedTo) {
    const fabric::Fabric f = build(pattern::makePlain(8, 8));
    YarnSettling settling(f, {}, {});
    const std::function<bool()> always = [] { return true; };
    const physics::Vector before = settling.shape();
    EXPECT_FALSE(settling.step(physics::Interrupt(&always)));
    EXPECT_EQ(settling.shape(), before);
    EXPECT_EQ(settling.phase(), YarnSettling::Phase::Growing);
}

TEST(YarnSettling, OfAnEmptyFabricSaysSo) {
    const fabric::Fabric empty;
    YarnSettling settling(empty, {}, {});
    EXPECT_STRNE(settling.problem(), "");
    EXPECT_FALSE(settling.step({}));
    EXPECT_EQ(settling.audit().coreOverlaps, 0);
}

} // namespace
} // namespace knittsim::simulation
