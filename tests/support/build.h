#pragma once

#include "core/fabric/fabric_builder.h"
#include "core/formats/knitout/reader.h"
#include "core/machine/timeline.h"

#include <stdexcept>
#include <string>

namespace knittsim::test {

/// A program from knitout lines without the header; carriers are 1 to 4, front to back.
inline machine::Program program(const std::string& lines) {
    auto parsed = formats::knitout::parse(";!knitout-2\n;;Carriers: 1 2 3 4\n" + lines, "test.k");
    if (!parsed) {
        throw std::runtime_error("test program is wrong: " + parsed.diagnostics().front().id);
    }
    return std::move(parsed).value();
}

inline machine::Timeline timeline(const std::string& lines) {
    return {program(lines), machine::genericProfile()};
}

inline fabric::Fabric build(const std::string& lines) {
    return fabric::buildFabric(timeline(lines));
}

/// One pass over needles first..last (either way) of one bed, for example pass("knit", 'f', 0, 9, 1).
inline std::string pass(const char* operation, char bed, int first, int last, int carrier, int step = 1) {
    std::string lines;
    const int direction = first <= last ? 1 : -1;
    for (int needle = first; (last - needle) * direction >= 0; needle += direction * step) {
        lines += std::string(operation) + (direction > 0 ? " + " : " - ") + bed + std::to_string(needle) +
                 ' ' + std::to_string(carrier) + '\n';
    }
    return lines;
}

} // namespace knittsim::test
