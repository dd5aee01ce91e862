#include "tests/golden/pictures.h"
#include "tests/support/build.h"
#include "tests/support/lattice.h"

#include <gtest/gtest.h>

#include <cmath>

namespace knittsim::render {
namespace {

std::string courses(const std::string& beds, int count) {
    std::string lines;
    const int last = static_cast<int>(beds.size()) - 1;
    for (int course = 0; course < count; ++course) {
        for (int i = 0; i <= last; ++i) {
            const int needle = course % 2 == 0 ? last - i : i;
            lines += std::string("knit ") + (course % 2 == 0 ? '-' : '+') + ' ' +
                     beds[static_cast<std::size_t>(needle)] + std::to_string(needle) + " 1\n";
        }
    }
    return lines;
}

std::string transfers(const char* from, const char* to, const std::string& needles, int shift) {
    std::string lines;
    for (const char needle : needles) {
        lines +=
            std::string("xfer ") + from + needle + ' ' + to + std::to_string(needle - '0' + shift) + '\n';
    }
    return lines;
}

/// Two wales cross over two others in the middle of eight.
fabric::Fabric cable() {
    return test::build("in 1\n" + courses("ffffffff", 4) + transfers("f", "b", "2345", 0) + "rack 2\n" +
                       transfers("b", "f", "23", 2) + "rack -2\n" + transfers("b", "f", "45", -2) +
                       "rack 0\n" + courses("ffffffff", 4) + "out 1\n");
}

fabric::Fabric knit(const std::string& beds, int count) {
    return test::build("in 1\n" + courses(beds, count) + "out 1\n");
}

/// Rear-bed wales behind front-bed ones.
std::vector<float> foldedLattice(const fabric::Fabric& fabric) {
    std::vector<float> positions = test::relaxedLattice(fabric, kLoopMm);
    for (const fabric::Loop& loop : fabric.loops) {
        for (const fabric::PointIndex head : {loop.headLeft, loop.headRight}) {
            const auto e = 3 * static_cast<std::size_t>(fabric.points[static_cast<std::size_t>(head)].entry);
            positions[e + 2] = machine::isFront(loop.bound.bed) ? 0.3F : -0.3F;
        }
    }
    return positions;
}

TEST_F(Pictures, plainFront) {
    const auto fabric = knit("ffffff", 6);
    expectPicture("plain-front", fabric, test::relaxedLattice(fabric, kLoopMm));
}

TEST_F(Pictures, plainBack) {
    const auto fabric = knit("ffffff", 6);
    m_request.side = ViewSide::Back;
    expectPicture("plain-back", fabric, test::relaxedLattice(fabric, kLoopMm));
}

TEST_F(Pictures, ribWithTwoYarnWidthsOfDepth) {
    const auto fabric = knit("ffbbffbb", 6);
    expectPicture("rib", fabric, foldedLattice(fabric));
}

TEST_F(Pictures, cableOnTheMachine) {
    const auto fabric = cable();
    m_request.dark = true;
    expectPicture("cable", fabric, {});
}

TEST_F(Pictures, strokes) {
    const auto fabric = cable();
    m_request.style = DrawStyle::Strokes;
    expectPicture("strokes", fabric, {});
}

TEST_F(Pictures, mesh) {
    const auto fabric = cable();
    m_request.style = DrawStyle::Mesh;
    m_request.dark = true;
    expectPicture("mesh", fabric, {});
}

TEST_F(Pictures, aslantInPerspectiveWithASelectedStitch) {
    const auto fabric = knit("fffffff", 7);
    m_request.selection = {24};
    CameraState state;
    state.target = {4, 4, 0};
    state.yaw = 0.8F;
    state.pitch = 0.45F;
    state.halfHeight = 4;
    state.orthographic = false;
    m_request.camera = state;
    expectPicture("aslant", fabric, test::relaxedLattice(fabric, kLoopMm));
}

TEST_F(Pictures, manyStitchesAreDrawnAsBands) {
    const auto fabric = knit(std::string(40, 'f'), 36);
    expectPicture("far-away", fabric, test::relaxedLattice(fabric, kLoopMm));
}

TEST_F(Pictures, withoutBackgroundOnlyYarnIsOpaque) {
    const auto fabric = knit("ffff", 4);
    const auto positions = test::relaxedLattice(fabric, kLoopMm);
    m_request.fabric = &fabric;
    m_request.positions = positions;
    m_request.transparent = true;
    const auto image = renderFabric(m_request);
    ASSERT_TRUE(image);
    EXPECT_EQ(image->at(0, 0)[3], 0);
    EXPECT_EQ(image->at(96, 80)[3], 255);
}

TEST_F(Pictures, frontAndBackShowTheYarnInItsColour) {
    const auto fabric = knit("ffffff", 6);
    const auto positions = test::relaxedLattice(fabric, kLoopMm);
    m_request.fabric = &fabric;
    m_request.positions = positions;
    m_request.looks[0].colour = {40, 90, 200};
    for (const ViewSide side : {ViewSide::Front, ViewSide::Back}) {
        m_request.side = side;
        const auto image = renderFabric(m_request);
        ASSERT_TRUE(image);
        long red = 0;
        long blue = 0;
        for (int y = 48; y < 96; ++y) {
            for (int x = 64; x < 128; ++x) {
                red += image->at(x, y)[0];
                blue += image->at(x, y)[2];
            }
        }
        EXPECT_GT(blue, 3 * red);
        EXPECT_GT(blue / (48 * 64), 90);  // neither too dark ...
        EXPECT_LT(blue / (48 * 64), 230); // ... nor burnt out
    }
}

TEST_F(Pictures, oneCourseAlone) {
    const auto fabric = knit("ffffff", 6);
    for (const fabric::BondingPoint& point : fabric.points) {
        m_request.keep.push_back(fabric.loops[static_cast<std::size_t>(point.loop)].course == 3);
    }
    expectPicture("one-course", fabric, test::relaxedLattice(fabric, kLoopMm));
}

TEST_F(Pictures, sectionAcrossTheWales) {
    const auto fabric = knit("ffffff", 6);
    const auto positions = test::relaxedLattice(fabric, kLoopMm);
    m_request.side = ViewSide::Top;
    m_request.looks[0].diameterMm = kLoopMm / 14; // no yarn lies within another
    float height = 0;
    for (std::size_t e = 1; e < positions.size(); e += 3) {
        height = std::max(height, positions[e]);
    }
    m_request.section = Section{{0, 0.45F * height, 0}, Vec3f::UnitY()};
    expectPicture("section", fabric, positions);
}

TEST_F(Pictures, partsMakeTheSamePicture) {
    const auto fabric = cable();
    m_request.fabric = &fabric;
    for (const DrawStyle style : {DrawStyle::Yarn, DrawStyle::Strokes, DrawStyle::Mesh}) {
        m_request.style = style;
        m_request.part = 2048;
        const auto whole = renderFabric(m_request);
        m_request.part = 50;
        const auto parts = renderFabric(m_request);
        ASSERT_TRUE(whole && parts);
        const auto difference = test::compareBlocks(whole.value(), parts.value());
        EXPECT_EQ(difference.blocks, 0) << difference.text();
    }
}

TEST_F(Pictures, endsBetweenPartsWhenCancelled) {
    const auto fabric = cable();
    m_request.fabric = &fabric;
    m_request.part = 50;
    int asked = 0;
    m_request.progress = [&asked](double share) {
        EXPECT_GE(share, 0);
        EXPECT_LT(share, 1);
        return ++asked < 3;
    };
    const auto image = renderFabric(m_request);
    ASSERT_FALSE(image);
    EXPECT_EQ(image.diagnostics().front().id, "KS0009");
    EXPECT_EQ(asked, 3);
}

TEST_F(Pictures, impossibleSizeIsAnError) {
    const auto fabric = knit("ff", 2);
    m_request.fabric = &fabric;
    m_request.width = 0;
    const auto image = renderFabric(m_request);
    ASSERT_FALSE(image);
    EXPECT_EQ(image.diagnostics().front().id, "KS0404");
}

} // namespace
} // namespace knittsim::render
