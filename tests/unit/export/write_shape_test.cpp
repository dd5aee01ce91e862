#include "tests/unit/export/swatch.h"

#include <fstream>

namespace knittsim::exports {
namespace {

constexpr std::array kNames{"a.obj", "a.gltf", "a.glb", "a.bcc", "a.svg", "a.csv"};

TEST(FormatOf, LooksAtTheExtensionOnly) {
    EXPECT_EQ(formatOf("x/y.z/A.GLB"), Format::Glb);
    EXPECT_EQ(formatOf("a.svg"), Format::Svg);
    for (const char* name : {"a", "a.png", ".obj", "a.obj.bak", ""}) {
        EXPECT_FALSE(formatOf(name)) << name;
    }
}

TEST_F(ExportTest, CancelLeavesNothingWhereverItComes) {
    const Shape shape = swatch(30);
    for (const char* name : kNames) {
        int calls = 0;
        double last = 0;
        ASSERT_TRUE(writeShape(m_folder / name, shape, {}, [&](double share) {
            ++calls;
            EXPECT_GE(share, last) << name;
            EXPECT_LE(share, 1.001) << name;
            last = share;
            return true;
        }));
        std::filesystem::remove_all(m_folder);
        std::filesystem::create_directory(m_folder);
        ASSERT_GE(calls, 1) << name;
        for (const int at : {1, (calls + 1) / 2, calls}) {
            int seen = 0;
            const auto result = writeShape(m_folder / name, shape, {}, [&](double) { return ++seen < at; });
            ASSERT_FALSE(result) << name;
            EXPECT_EQ(result.diagnostics().front().id, "KS0009");
            EXPECT_EQ(seen, at) << name;
            EXPECT_EQ(entryCount(), 0) << name;
        }
    }
}

TEST_F(ExportTest, CancelKeepsTheFileThatWasThere) {
    const Shape shape = swatch();
    for (const char* name : kNames) {
        std::ofstream(m_folder / name) << "before";
        EXPECT_FALSE(writeShape(m_folder / name, shape, {}, [](double) { return false; }));
        EXPECT_EQ(readFile(m_folder / name).value(), "before") << name;
    }
}

TEST_F(ExportTest, WhereTheObjFindsNoPlaceTheMaterialsStayAsTheyWere) {
    const Shape shape = swatch();
    std::filesystem::create_directories(m_folder / "a.obj" / "full"); // no file replaces a folder
    const auto alone = writeShape(m_folder / "a.obj", shape);
    ASSERT_FALSE(alone);
    EXPECT_EQ(alone.diagnostics().front().id, "KS0002");
    EXPECT_EQ(entryCount(), 1); // nothing but the folder
    std::ofstream(m_folder / "a.mtl") << "before";
    EXPECT_FALSE(writeShape(m_folder / "a.obj", shape));
    EXPECT_EQ(readFile(m_folder / "a.mtl").value(), "before");
    EXPECT_EQ(entryCount(), 2);
}

TEST_F(ExportTest, WhereTheMaterialsFindNoPlaceThereIsNoObj) {
    std::filesystem::create_directories(m_folder / "a.mtl" / "full");
    EXPECT_FALSE(writeShape(m_folder / "a.obj", swatch()));
    EXPECT_EQ(entryCount(), 1);
}

TEST_F(ExportTest, SaysWhatCannotBeWritten) {
    const Shape shape = swatch();
    for (const char* name : kNames) {
        const auto result = writeShape(m_folder / "none" / name, shape);
        ASSERT_FALSE(result);
        EXPECT_EQ(result.diagnostics().front().id, "KS0002") << name;
        EXPECT_EQ(result.diagnostics().size(), 1u);
    }
    const auto result = writeShape(m_folder / "a.stl", shape);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.diagnostics().front().id, "KS0022");
    EXPECT_EQ(entryCount(), 0);
}

TEST_F(ExportTest, AnEmptyFabricIsAFileWithoutYarn) {
    Shape nothing;
    nothing.fabric = std::make_shared<fabric::Fabric>();
    for (const char* name : kNames) {
        EXPECT_FALSE(written(name, nothing).empty()) << name;
    }
}

TEST(ShapeAt, StopsWhenItIsToldTo) {
    const Shape shape = swatch();
    EXPECT_FALSE(shapeAt(shape.fabric, twoYarns(), {}, [](double) { return false; }));
}

TEST(ShapeAt, HasAMaterialForEveryCarrier) {
    const Shape shape = swatch();
    const auto bare = shapeAt(shape.fabric, {}, {});
    ASSERT_TRUE(bare);
    for (const geometry::YarnCurves::Range& yarn : bare->curves.yarns) {
        EXPECT_LT(yarn.carrier, bare->materials.size());
    }
}

} // namespace
} // namespace knittsim::exports
