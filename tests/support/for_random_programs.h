#pragma once

#include "tests/support/random_program.h"
#include "tests/support/shrink.h"

#include <gtest/gtest.h>

namespace knittsim::test {

/// Checks a property for `count` random programs, with the seeds options.seed, options.seed + 1, ... The
/// first that fails is shrunk and shown as knitout.
inline void forRandomPrograms(int count, RandomProgramOptions options, const Property& property) {
    const std::uint32_t first = options.seed;
    for (int i = 0; i < count; ++i) {
        options.seed = first + static_cast<std::uint32_t>(i);
        const std::string failure = explainFailure(randomProgram(options), property);
        if (!failure.empty()) {
            ADD_FAILURE() << "seed " << options.seed << ": " << failure;
            return;
        }
    }
}

} // namespace knittsim::test
