#include "tests/unit/export/swatch.h"

#include <cstdio>
#include <sstream>

namespace knittsim::exports {
namespace {

TEST_F(ExportTest, CsvHasALineForEachBondingPoint) {
    const Shape shape = swatch();
    std::istringstream lines(written("a.csv", shape));
    std::string line;
    std::getline(lines, line);
    const auto columns = std::ranges::count(line, ',');
    std::size_t count = 0;
    double length = 0;
    for (; std::getline(lines, line); ++count) {
        EXPECT_EQ(std::ranges::count(line, ','), columns) << line;
        length += std::stod(line.substr(line.rfind(',') + 1));
    }
    EXPECT_EQ(count, shape.fabric->points.size());
    double fed = 0;
    for (const double mm : shape.fabric->lengths) {
        fed += mm;
    }
    EXPECT_NEAR(length, fed, 1e-5 * static_cast<double>(count));
}

} // namespace
} // namespace knittsim::exports
