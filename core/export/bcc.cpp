#include "core/export/writers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace knittsim::exports {

namespace {

/// 64 bytes, little-endian.
struct Header {
    std::array<char, 3> sign{'B', 'C', 'C'};
    std::uint8_t bytes = 0x44;           ///< of an integer and of a number: four and four
    std::array<char, 2> curve{'C', '0'}; ///< uniform Catmull-Rom: runs through its control points
    std::uint8_t dimensions = 3;
    std::uint8_t upDimension = 1; ///< y
    std::uint64_t curves = 0;
    std::uint64_t points = 0;
    std::array<char, 40> info{};
};
static_assert(sizeof(Header) == 64);

constexpr std::string_view kInfo = "KnittSim, millimetres";

} // namespace

void writeBcc(Output& out, const Shape& shape) {
    Header header;
    std::memcpy(header.info.data(), kInfo.data(), kInfo.size());
    header.curves = shape.curves.yarns.size();
    for (const geometry::YarnCurves::Range& yarn : shape.curves.yarns) {
        header.points += static_cast<std::uint64_t>(yarn.count);
    }
    out.writeRaw(std::span<const Header>(&header, 1));
    for (const geometry::YarnCurves::Range& yarn : shape.curves.yarns) {
        out.advance(static_cast<double>(yarn.first) / static_cast<double>(header.points));
        // A negative number would close the curve; yarns have two ends.
        out.writeRaw(std::span<const std::int32_t>(&yarn.count, 1));
        static_assert(sizeof(Vec3f) == 3 * sizeof(float));
        out.writeRaw(nodesOf(shape, yarn));
    }
    out.advance(1);
}

} // namespace knittsim::exports
