#include "core/fabric/fabric_builder.h"
#include "core/fabric/machine_shape.h"
#include "core/formats/formats.h"
#include "core/geometry/curve_report.h"
#include "tests/support/build.h"
#include "tests/support/machine_data.h"
#include "tests/unit/geometry/plain_case.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace knittsim::geometry {
namespace {

namespace fs = std::filesystem;

struct Exact {
    fabric::Fabric fabric;
    YarnCurves curves;
    CurveReport report;
};

/// Yarn of a seventeenth of the loop length, as a normal fabric has.
std::vector<double> diametersFor(const fabric::Fabric& fabric) {
    return std::vector<double>(32, fabric::meanLoopLength(fabric) / 17);
}

Exact exact(fabric::Fabric fabric) {
    const std::vector<double> diameters = diametersFor(fabric);
    YarnCurves curves = buildMachineCurves(fabric, diameters);
    CurveReport report = inspectCurves(fabric, curves, diameters);
    return {std::move(fabric), std::move(curves), std::move(report)};
}

Exact exact(const fs::path& file) {
    const auto program = formats::readProgram(file.string());
    EXPECT_TRUE(program) << file;
    return exact(fabric::buildFabric({program.value(), machine::genericProfile()}));
}

std::vector<fs::path> programsIn(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator(folder, error)) {
        if (entry.path().extension() == ".k" || entry.path().extension() == ".knitout") {
            files.push_back(entry.path());
        }
    }
    std::ranges::sort(files);
    return files;
}

double asStored(const CurveReport& report) {
    return static_cast<double>(report.piecesAsStored) / static_cast<double>(report.pieces);
}

/// As long as stored, or the grid does not allow it.
double accountedFor(const CurveReport& report) {
    return static_cast<double>(report.piecesAsStored + report.piecesOutOfReach) /
           static_cast<double>(report.pieces);
}

/// `least`: share of the pieces of yarn that are as long as stored. Turns at the selvedges and floats under
/// held loops are longer on their shortest way. `leastWithThese`: share with those of which this can be told;
/// what is left over lies in layers that hold each other apart.
void expectExact(const fs::path& file, double least, double leastWithThese) {
    const CurveReport report = exact(file).report;
    const std::string name = file.parent_path().filename() / file.filename();
    EXPECT_TRUE(report.crossings.faults.empty()) << name << " of " << report.crossings.expected;
    EXPECT_TRUE(report.certificate.holds()) << name;
    EXPECT_GT(report.nearest.mm, 0) << name;
    EXPECT_GT(report.crossings.expected, 0U) << name;
    EXPECT_GE(asStored(report), least) << name;
    EXPECT_GE(accountedFor(report), leastWithThese) << name;
}

TEST(ExactCurve, EverySampleHasTheCrossingsThatItsBooksName) {
    for (const fs::path& file : programsIn(fs::path(KNITTSIM_SOURCE_DIR) / "resources" / "patterns")) {
        expectExact(file, 0.97, 0.998);
    }
}

TEST(ExactCurve, EveryProgramFromAMachineHasTheCrossingsThatItsBooksName) {
    const std::vector<fs::path> files = programsIn(test::machineData());
    if (files.empty()) {
        GTEST_SKIP() << "no programs in " << test::machineData();
    }
    for (const fs::path& file : files) {
        expectExact(file, 0.75, 0.96);
    }
}

TEST(ExactCurve, ThinYarnCrossesTheSame) {
    for (const char* name : {"plain", "lace", "transfer-demo", "racked-rib", "tube"}) {
        const auto program =
            formats::readProgram(std::string(KNITTSIM_SOURCE_DIR) + "/resources/patterns/" + name + ".k");
        ASSERT_TRUE(program) << name;
        const fabric::Fabric f = fabric::buildFabric({program.value(), machine::genericProfile()});
        std::vector<double> thin = diametersFor(f);
        for (double& d : thin) {
            d *= 0.1;
        }
        const CurveReport report = inspectCurves(f, buildMachineCurves(f, thin), thin);
        EXPECT_TRUE(report.crossings.faults.empty()) << name;
        EXPECT_TRUE(report.certificate.holds()) << name;
    }
}

TEST(ExactCurve, PlainKnitIsAsLongAsItsYarn) {
    const CurveReport report = exact(test::knit("ffffffffffff", 12)).report;
    EXPECT_GT(report.pieces, 500U);
    EXPECT_GE(asStored(report), 0.98); // all but the turns at the edges
    EXPECT_GT(report.piecesOutOfReach, 0U);
    EXPECT_EQ(report.piecesAsStored + report.piecesOutOfReach, report.pieces);
}

TEST(ExactCurve, StrandsAreAThirdOfADiameterApartInPlainKnit) {
    const Exact plain = exact(test::knit("ffffffff", 8));
    EXPECT_GT(plain.report.nearest.mm, 0.3 * diametersFor(plain.fabric)[0]);
}

TEST(CrossingAudit, ALoopOnTheWrongSideIsAFault) {
    Exact plain = exact(test::knit("ffffff", 6));
    ASSERT_TRUE(plain.report.crossings.faults.empty());
    // One loop in the middle is mirrored in depth: its four crossings with the loop below and the four with
    // the loop above have the wrong strand in front.
    const machine::LoopIndex loop = 15;
    for (std::size_t n = 0; n < plain.curves.nodes.size(); ++n) {
        const auto p = static_cast<std::size_t>(plain.curves.piece[n]);
        if (plain.fabric.points[p].loop == loop) {
            plain.curves.nodes[n].z() = 1 - plain.curves.nodes[n].z();
        }
    }
    const CrossingAudit audit = auditCrossings(plain.fabric, plain.curves, projectCrossings(plain.curves));
    EXPECT_GE(audit.faults.size(), 4U);
    for (const CrossingFault& fault : audit.faults) {
        EXPECT_TRUE(fault.a.loop == loop || fault.b.loop == loop);
        EXPECT_EQ(fault.kind, CrossingFault::Kind::WrongOrder);
    }
    EXPECT_FALSE(certifyTopology(plain.fabric, plain.curves).holds());
}

TEST(CrossingAudit, AMirroredFabricIsAllFaults) {
    Exact plain = exact(test::knit("fbffbf", 6));
    for (Vec3f& node : plain.curves.nodes) {
        node.z() = -node.z();
    }
    const CrossingAudit audit = auditCrossings(plain.fabric, plain.curves, projectCrossings(plain.curves));
    EXPECT_LT(audit.found, audit.expected / 20) << "a few fit neighbours that are the same way round";
    EXPECT_EQ(certifyTopology(plain.fabric, plain.curves).failures.size(),
              certifyTopology(plain.fabric, plain.curves).pairs);
}

TEST(Certificate, FindsALoopThatSlippedOutOfTheOneBelow) {
    Exact plain = exact(test::knit("ffffff", 6));
    ASSERT_TRUE(plain.report.certificate.holds());
    // All of one loop is moved to the front: it lies before the loop that it was drawn through.
    const machine::LoopIndex loop = 20;
    for (std::size_t n = 0; n < plain.curves.nodes.size(); ++n) {
        const auto p = static_cast<std::size_t>(plain.curves.piece[n]);
        if (plain.fabric.points[p].loop == loop) {
            plain.curves.nodes[n].z() += 3;
        }
    }
    const TopologyCertificate certificate = certifyTopology(plain.fabric, plain.curves);
    ASSERT_FALSE(certificate.holds());
    EXPECT_TRUE(
        std::ranges::any_of(certificate.failures, [&](const PullThrough& p) { return p.loop == loop; }));
}

TEST(StrandDistance, IsThatOfTheNearestStrands) {
    YarnCurves curves;
    for (const Vec3f& p : {Vec3f(0, 0, 0), Vec3f(10, 0, 0), Vec3f(5, -3, 0.4F), Vec3f(5, 3, 0.4F)}) {
        curves.nodes.push_back(p);
        curves.arc.push_back(curves.nodes.size() % 2 == 1 ? 0 : 10);
    }
    curves.yarns = {{0, 2, 0}, {2, 2, 1}};
    EXPECT_NEAR(smallestDistance(curves, 1, 1).mm, 0.4, 1e-6);
    EXPECT_EQ(smallestDistance(curves, 0.3, 1).nodeA, -1);
}

} // namespace
} // namespace knittsim::geometry
