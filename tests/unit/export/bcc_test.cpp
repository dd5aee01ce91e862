#include "tests/unit/export/swatch.h"

#include <cstring>

namespace knittsim::exports {
namespace {

/// After the description of the format, not after our writer.
struct BccFile {
    std::vector<std::vector<Vec3f>> curves;
    std::uint64_t points = 0;
};

template<class T> T take(std::string_view& bytes) {
    T value{};
    EXPECT_GE(bytes.size(), sizeof value);
    if (bytes.size() >= sizeof value) {
        std::memcpy(&value, bytes.data(), sizeof value);
        bytes.remove_prefix(sizeof value);
    }
    return value;
}

BccFile readBcc(std::string_view bytes) {
    BccFile file;
    EXPECT_EQ(bytes.substr(0, 3), "BCC");
    EXPECT_EQ(bytes[3], 0x44);
    EXPECT_EQ(bytes.substr(4, 2), "C0");
    EXPECT_EQ(bytes[6], 3);
    EXPECT_EQ(bytes[7], 1); // y is up
    bytes.remove_prefix(8);
    const auto curves = take<std::uint64_t>(bytes);
    file.points = take<std::uint64_t>(bytes);
    EXPECT_EQ(std::string(bytes.data()), "KnittSim, millimetres");
    bytes.remove_prefix(40);
    for (std::uint64_t c = 0; c < curves && !bytes.empty(); ++c) {
        const auto count = take<std::int32_t>(bytes);
        EXPECT_GT(count, 0); // open
        std::vector<Vec3f>& points = file.curves.emplace_back();
        for (std::int32_t i = 0; i < count; ++i) {
            const float x = take<float>(bytes);
            const float y = take<float>(bytes);
            points.emplace_back(x, y, take<float>(bytes));
        }
    }
    EXPECT_TRUE(bytes.empty());
    return file;
}

TEST_F(ExportTest, BccKeepsEveryNodeOfEveryYarn) {
    const Shape shape = swatch();
    const BccFile file = readBcc(written("a.bcc", shape));
    ASSERT_EQ(file.curves.size(), 2u);
    EXPECT_EQ(file.points, shape.curves.nodes.size());
    for (std::size_t y = 0; y < file.curves.size(); ++y) {
        const geometry::YarnCurves::Range& yarn = shape.curves.yarns[y];
        ASSERT_EQ(file.curves[y].size(), static_cast<std::size_t>(yarn.count));
        double length = 0;
        for (std::size_t n = 0; n < file.curves[y].size(); ++n) {
            EXPECT_EQ(file.curves[y][n], shape.curves.nodes[static_cast<std::size_t>(yarn.first) + n]);
            length += n > 0 ? (file.curves[y][n] - file.curves[y][n - 1]).norm() : 0.0;
        }
        const double arc = shape.curves.arc[static_cast<std::size_t>(yarn.first + yarn.count - 1)];
        EXPECT_NEAR(length, arc, 1e-4 * arc);
    }
}

TEST_F(ExportTest, BccOfNothingIsAHeader) {
    Shape nothing;
    nothing.fabric = std::make_shared<fabric::Fabric>();
    EXPECT_EQ(written("a.bcc", nothing).size(), 64u);
}

} // namespace
} // namespace knittsim::exports
