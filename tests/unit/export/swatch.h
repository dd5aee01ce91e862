#pragma once

#include "core/export/write_shape.h"
#include "tests/support/build.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <iterator>

namespace knittsim::exports {

inline std::vector<yarn::Yarn> twoYarns() {
    std::vector<yarn::Yarn> yarns(4);
    yarns[0].name = "red wool";
    yarns[0].colour = {200, 40, 30};
    yarns[0].outerDiameterMm = 0.4;
    yarns[1].name = "blue \"silk\"";
    yarns[1].colour = {20, 60, 200};
    yarns[1].outerDiameterMm = 0.3;
    return yarns;
}

/// Rib of two yarns, `wales` x 8, as the machine leaves it.
inline Shape swatch(int wales = 8) {
    std::string lines = "in 1\nin 2\n";
    for (int course = 0; course < 8; ++course) {
        const char* carrier = course / 2 % 2 == 0 ? " 1\n" : " 2\n";
        for (int i = 0; i < wales; ++i) {
            const int needle = course % 2 == 0 ? wales - 1 - i : i;
            lines += std::string("knit ") + (course % 2 == 0 ? "- " : "+ ") +
                     (needle / 2 % 2 == 0 ? 'f' : 'b') + std::to_string(needle) + carrier;
        }
    }
    auto fabric = std::make_shared<fabric::Fabric>(test::build(lines + "out 1\nout 2\n"));
    return *shapeAt(std::move(fabric), twoYarns(), {});
}

/// A folder of its own for each test, removed with it.
class ExportTest : public testing::Test {
protected:
    std::string written(const std::string& name, const Shape& shape, const WriteOptions& options = {}) {
        const auto result = writeShape(m_folder / name, shape, options);
        EXPECT_TRUE(result) << name;
        auto bytes = readFile(m_folder / name, std::size_t{1} << 30);
        return bytes ? std::move(bytes).value() : std::string();
    }

    std::ptrdiff_t entryCount() const { return m_temporary.entryCount(); }

    test::TemporaryFolder m_temporary;
    const std::filesystem::path m_folder = m_temporary.path();
};

} // namespace knittsim::exports
