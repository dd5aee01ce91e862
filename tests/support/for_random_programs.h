#pragma once

#include "tests/support/random_program.h"
#include "tests/support/shrink.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <span>

namespace knittsim::test {

/// A random program that once broke a property, and what it was about.
struct KnownSeed {
    std::uint32_t seed;
    const char* about;
};

/// KNITTSIM_RANDOM_PROGRAMS says how many programs every property is checked for; else `count`.
inline int numberOfPrograms(int count) {
    const char* given = std::getenv("KNITTSIM_RANDOM_PROGRAMS");
    return given == nullptr ? count : std::atoi(given);
}

/// Checks a property for `count` random programs, with the seeds options.seed, options.seed + 1, ..., and for
/// those that are `known`. The first that fails is shrunk and shown as knitout.
inline void forRandomPrograms(int count, RandomProgramOptions options, const Property& property,
                              std::span<const KnownSeed> known = {}) {
    const std::uint32_t first = options.seed;
    const auto holds = [&](std::uint32_t seed, const std::string& about) {
        options.seed = seed;
        const std::string failure = explainFailure(randomProgram(options), property);
        EXPECT_TRUE(failure.empty()) << "seed " << seed << about << ": " << failure;
        return failure.empty();
    };
    for (const KnownSeed& seed : known) {
        if (!holds(seed.seed, std::string(" (") + seed.about + ')')) {
            return;
        }
    }
    for (int i = 0; i < numberOfPrograms(count); ++i) {
        if (!holds(first + static_cast<std::uint32_t>(i), {})) {
            return;
        }
    }
}

} // namespace knittsim::test
