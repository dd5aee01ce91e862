#include "core/pattern/samples.h"
#include "tests/support/build.h"
#include "ui/document/prefix_builder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace knittsim::document {
namespace {

using fabric::EntryIndex;
using fabric::Fabric;
using test::pass;

PrefixFabric prefixOf(const machine::Timeline& timeline, const Fabric& whole, int count) {
    PrefixFabric prefix;
    prefix.count = count;
    prefix.fabric = std::make_shared<Fabric>(fabric::buildFabric(timeline, count));
    prefix.wholeEntry = pairEntries(*prefix.fabric, whole);
    return prefix;
}

/// Positions that tell their entry: (entry, 2 entry, 3 entry).
std::vector<float> taggedPositions(const Fabric& fabric) {
    std::vector<float> positions;
    for (EntryIndex entry = 0; entry < fabric.entryCount; ++entry) {
        for (int axis = 1; axis <= 3; ++axis) {
            positions.push_back(static_cast<float>(axis * entry));
        }
    }
    return positions;
}

TEST(Prefix, ALoopKeepsItsPlaceInTheWhole) {
    const std::string lines =
        "in 1\n" + pass("knit", 'f', 4, 1, 1) + pass("knit", 'f', 1, 4, 1) + pass("knit", 'f', 4, 1, 1);
    const machine::Timeline timeline = test::timeline(lines);
    const Fabric whole = fabric::buildFabric(timeline);
    const PrefixFabric prefix = prefixOf(timeline, whole, 7); // one course and two stitches
    ASSERT_EQ(prefix.fabric->loops.size(), 6U);
    const std::vector<float> positions = prefixPositions(prefix, taggedPositions(whole));
    for (std::size_t loop = 0; loop < 6; ++loop) {
        const auto mine = prefix.fabric->loops[loop].headLeft;
        const auto theirs = whole.loops[loop].headLeft;
        const EntryIndex expected = whole.points[static_cast<std::size_t>(theirs)].entry;
        const EntryIndex entry = prefix.fabric->points[static_cast<std::size_t>(mine)].entry;
        EXPECT_FLOAT_EQ(positions[static_cast<std::size_t>(3 * entry)], static_cast<float>(expected));
        EXPECT_FLOAT_EQ(positions[static_cast<std::size_t>(3 * entry + 2)], static_cast<float>(3 * expected));
    }
}

TEST(Prefix, TheWholeProgramPairsEveryEntryWithItself) {
    const machine::Timeline timeline(pattern::makeSample("cable-left"), machine::genericProfile());
    const Fabric whole = fabric::buildFabric(timeline);
    const PrefixFabric prefix = prefixOf(timeline, whole, timeline.operationCount());
    int differing = 0;
    for (EntryIndex entry = 0; entry < whole.entryCount; ++entry) {
        const EntryIndex paired = prefix.wholeEntry[static_cast<std::size_t>(entry)];
        differing += paired >= 0 && paired != entry ? 1 : 0;
    }
    EXPECT_EQ(differing, 0);
}

TEST(Prefix, EveryPlaceIsFiniteAndNearTheFabricAtEveryTenthStep) {
    for (const char* sample : {"cable-left", "lace", "float-jacquard", "tube", "racked-rib"}) {
        const machine::Timeline timeline(pattern::makeSample(sample), machine::genericProfile());
        const Fabric whole = fabric::buildFabric(timeline);
        std::vector<float> positions;
        Vec3 low = whole.machinePositions.front();
        Vec3 high = low;
        for (const Vec3& place : whole.machinePositions) {
            low = low.cwiseMin(place);
            high = high.cwiseMax(place);
            for (int axis = 0; axis < 3; ++axis) {
                positions.push_back(static_cast<float>(place[axis]));
            }
        }
        const double margin = 5 * whole.pitchMm;
        for (int count = 0; count < timeline.operationCount(); count += 10) {
            const PrefixFabric prefix = prefixOf(timeline, whole, count);
            const std::vector<float> places = prefixPositions(prefix, positions);
            ASSERT_EQ(places.size(), 3 * static_cast<std::size_t>(prefix.fabric->entryCount));
            for (std::size_t i = 0; i < places.size(); ++i) {
                const auto axis = static_cast<int>(i % 3);
                ASSERT_TRUE(std::isfinite(places[i])) << sample << " step " << count;
                ASSERT_GT(places[i], low[axis] - margin) << sample << " step " << count;
                ASSERT_LT(places[i], high[axis] + margin) << sample << " step " << count;
            }
        }
    }
}

} // namespace
} // namespace knittsim::document
