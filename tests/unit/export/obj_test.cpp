#include "tests/support/surface.h"
#include "tests/unit/export/swatch.h"

#include <cstdio>
#include <map>
#include <sstream>

namespace knittsim::exports {
namespace {

struct ObjObject {
    std::string name, material;
    test::Surface surface; ///< with places from 0
};

/// Objects of an OBJ file whose places and normals have the same numbers.
std::vector<ObjObject> readObj(const std::string& text, std::string& library) {
    std::vector<ObjObject> objects;
    std::istringstream lines(text);
    std::uint32_t before = 0; // places of the objects so far
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string key;
        words >> key;
        if (key == "o") {
            before += objects.empty() ? 0 : static_cast<std::uint32_t>(objects.back().surface.places.size());
            words >> objects.emplace_back().name;
        } else if (key == "mtllib") {
            words >> library;
        } else if (key == "usemtl") {
            words >> objects.back().material;
        } else if (key == "v" || key == "vn") {
            Vec3f v;
            words >> v.x() >> v.y() >> v.z();
            EXPECT_TRUE(words && v.allFinite()) << line;
            (key == "v" ? objects.back().surface.places : objects.back().surface.normals).push_back(v);
        } else if (key == "f") {
            std::uint32_t place = 0;
            std::uint32_t normal = 0;
            int corners = 0;
            for (std::string corner; words >> corner; ++corners) {
                EXPECT_EQ(std::sscanf(corner.c_str(), "%u//%u", &place, &normal), 2) << line;
                EXPECT_EQ(place, normal);
                EXPECT_GT(place, before);
                objects.back().surface.corners.push_back(place - 1 - before);
                EXPECT_LT(objects.back().surface.corners.back(), objects.back().surface.places.size());
            }
            EXPECT_EQ(corners, 3);
        }
    }
    return objects;
}

TEST_F(ExportTest, ObjHasAClosedTubeForEachYarn) {
    const Shape shape = swatch();
    std::string library;
    const std::vector<ObjObject> objects = readObj(written("a.obj", shape), library);
    ASSERT_EQ(objects.size(), 2u);
    EXPECT_EQ(library, "a.mtl");
    EXPECT_NE(objects[0].material, objects[1].material);
    for (std::size_t y = 0; y < objects.size(); ++y) {
        const test::Surface& tube = objects[y].surface;
        EXPECT_TRUE(test::isClosed(tube));
        EXPECT_EQ(test::eulerNumber(tube), 2);
        ASSERT_EQ(tube.normals.size(), tube.places.size());
        for (const Vec3f& normal : tube.normals) {
            EXPECT_NEAR(normal.norm(), 1, 2e-4);
        }
        // A prism of eight sides; a little less, as chords cut the bends.
        const geometry::YarnCurves::Range& yarn = shape.curves.yarns[y];
        const double length = shape.curves.arc[static_cast<std::size_t>(yarn.first + yarn.count - 1)];
        const double radius = shape.materials[yarn.carrier].diameterMm / 2;
        const double prism = 8 * std::sin(M_PI / 4) / 2 * radius * radius * length;
        EXPECT_NEAR(test::volumeOf(tube), prism, 0.04 * prism);
    }
}

TEST_F(ExportTest, ObjColoursAreTheYarns) {
    const Shape shape = swatch();
    std::string library;
    const auto objects = readObj(written("a.obj", shape), library);
    std::istringstream lines(readFile(m_folder / "a.mtl").value());
    std::map<std::string, Vec3f> colours;
    std::string name;
    for (std::string key; lines >> key;) {
        if (key == "newmtl") {
            lines >> name;
        } else if (key == "Kd") {
            Vec3f& c = colours[name];
            lines >> c.x() >> c.y() >> c.z();
        }
    }
    for (std::size_t y = 0; y < objects.size(); ++y) {
        ASSERT_TRUE(colours.contains(objects[y].material)) << objects[y].material;
        const yarn::Colour wanted = shape.materials[shape.curves.yarns[y].carrier].colour;
        EXPECT_LT((colours[objects[y].material] - Vec3f(wanted.r, wanted.g, wanted.b) / 255).norm(), 1e-3);
    }
}

} // namespace
} // namespace knittsim::exports
