#include "tests/support/read_gltf.h"
#include "tests/unit/export/swatch.h"

#include <gmock/gmock.h>

#include <cmath>

namespace knittsim::exports {
namespace {

using testing::IsEmpty;

TEST_F(ExportTest, GlbKeepsTheRulesOfTheFormat) {
    const test::GltfFile file = test::readGlb(written("a.glb", swatch()));
    EXPECT_THAT(file.faults, IsEmpty());
    ASSERT_EQ(file.meshes.size(), 2u);
    for (const test::GltfMesh& mesh : file.meshes) {
        EXPECT_TRUE(test::isClosed(mesh.surface));
        EXPECT_EQ(test::eulerNumber(mesh.surface), 2);
        EXPECT_GT(test::volumeOf(mesh.surface), 0);
    }
}

TEST_F(ExportTest, GltfAsTextHoldsTheSame) {
    const Shape shape = swatch();
    const test::GltfFile text = test::readGltf(written("a.gltf", shape));
    const test::GltfFile binary = test::readGlb(written("a.glb", shape));
    EXPECT_THAT(text.faults, IsEmpty());
    EXPECT_EQ(text.buffer, binary.buffer);
    EXPECT_EQ(text.json["accessors"], binary.json["accessors"]);
}

TEST_F(ExportTest, GltfIsInMetres) {
    const Shape shape = swatch();
    const test::GltfFile file = test::readGlb(written("a.glb", shape));
    EXPECT_EQ(file.json["nodes"][0]["scale"], nlohmann::json({0.001, 0.001, 0.001}));
    const float radius = 0.5F * static_cast<float>(shape.materials[0].diameterMm);
    // The surface reaches one radius beyond the curve.
    float curve = -1e9F;
    for (const Vec3f& node : shape.curves.nodes) {
        curve = std::max(curve, node.y());
    }
    float surface = -1e9F;
    for (const test::GltfMesh& mesh : file.meshes) {
        for (const Vec3f& place : mesh.surface.places) {
            surface = std::max(surface, place.y());
        }
    }
    EXPECT_NEAR(surface, curve + radius, 0.35 * radius);
}

TEST_F(ExportTest, GltfColoursAreLinear) {
    const test::GltfFile file = test::readGlb(written("a.glb", swatch()));
    ASSERT_EQ(file.json["materials"].size(), 2u); // only carriers that have yarn
    // sRGB 200/255 = 0.784 is 0.578 in light, 20/255 is 0.007.
    EXPECT_NEAR(file.meshes[0].colour[0], 0.578, 0.001);
    EXPECT_NEAR(file.meshes[1].colour[0], 0.007, 0.001);
    EXPECT_NEAR(file.meshes[1].colour[2], 0.578, 0.001);
}

TEST_F(ExportTest, GltfOfNothingIsValid) {
    Shape nothing;
    nothing.fabric = std::make_shared<fabric::Fabric>();
    EXPECT_THAT(test::readGlb(written("a.glb", nothing)).faults, IsEmpty());
    EXPECT_THAT(test::readGltf(written("a.gltf", nothing)).faults, IsEmpty());
}

TEST(GltfReader, FindsFaults) {
    std::string text = R"({"asset":{"version":"1.0"},"scene":1,"scenes":[{"nodes":[0]}],"nodes":[{},{}]})";
    EXPECT_EQ(test::readGltf(text).faults.size(), 3u);
}

} // namespace
} // namespace knittsim::exports
