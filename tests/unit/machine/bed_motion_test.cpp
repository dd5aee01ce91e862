#include "core/machine/bed_motion.h"
#include "tests/support/build.h"
#include "tests/support/random_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace knittsim::machine {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr BedWindow kAll{-200, 200};

std::map<Needle, std::vector<LoopIndex>> loopsOf(const BedPicture& picture) {
    std::map<Needle, std::vector<LoopIndex>> held;
    for (const SeenNeedle& needle : picture.needles) {
        for (const SeenLoop& loop : needle.loops) {
            held[needle.needle].push_back(loop.loop);
        }
    }
    return held;
}

std::map<Needle, std::vector<LoopIndex>> loopsOf(const MachineState& state) {
    std::map<Needle, std::vector<LoopIndex>> held;
    for (int bed = 0; bed < kBedCount; ++bed) {
        const NeedleRow& row = state.beds[static_cast<std::size_t>(bed)];
        for (std::int32_t n = row.first(); n < row.end(); ++n) {
            if (!row.at(n).empty()) {
                held[{static_cast<Bed>(bed), n}] = {row.at(n).begin(), row.at(n).end()};
            }
        }
    }
    return held;
}

std::map<LoopIndex, int> timesSeen(const BedPicture& picture) {
    std::map<LoopIndex, int> seen;
    for (const SeenNeedle& needle : picture.needles) {
        for (const SeenLoop& loop : needle.loops) {
            ++seen[loop.loop];
        }
    }
    if (picture.flight) {
        for (const SeenLoop& loop : picture.flight->loops) {
            ++seen[loop.loop];
        }
    }
    return seen;
}

const SeenNeedle& find(const BedPicture& picture, Needle needle) {
    return *std::ranges::find(picture.needles, needle, &SeenNeedle::needle);
}

class RandomMotion : public testing::TestWithParam<unsigned> {
protected:
    Timeline m_timeline{test::randomProgram({.seed = GetParam(), .operations = 400}), genericProfile()};
};

TEST_P(RandomMotion, BeginsWithTheStateBeforeAndEndsWithTheStateAfter) {
    for (OperationIndex k = 0; k < m_timeline.operationCount(); ++k) {
        const BedMotion motion(m_timeline, k);
        for (const int end : {0, 1}) {
            const MachineState state = m_timeline.stateAfter(k + end);
            const BedPicture picture = motion.at(end, kAll);
            ASSERT_EQ(loopsOf(picture), loopsOf(state)) << "operation " << k << " phase " << end;
            ASSERT_EQ(picture.rack, state.rack);
            ASSERT_FALSE(picture.flight);
            for (const SeenNeedle& needle : picture.needles) {
                ASSERT_EQ(needle.height, 0);
                ASSERT_EQ(needle.latch, 0);
                for (const SeenLoop& loop : needle.loops) {
                    ASSERT_EQ(loop.place, LoopPlace::Hook);
                    ASSERT_EQ(loop.drawn, 1);
                }
            }
        }
    }
}

TEST_P(RandomMotion, EachOperationBeginsWithThePictureTheLastOneEndedWith) {
    for (OperationIndex k = 1; k < m_timeline.operationCount(); ++k) {
        ASSERT_EQ(BedMotion(m_timeline, k).at(0, kAll), BedMotion(m_timeline, k - 1).at(1, kAll)) << k;
    }
}

TEST_P(RandomMotion, LoopsThatStayAreSeenExactlyOnceAllTheTime) {
    for (OperationIndex k = 0; k < m_timeline.operationCount(); ++k) {
        const BedMotion motion(m_timeline, k);
        const auto before = timesSeen(motion.at(0, kAll));
        const auto after = timesSeen(motion.at(1, kAll));
        for (int i = 0; i <= 40; ++i) {
            const auto seen = timesSeen(motion.at(i / 40.0, kAll));
            for (const auto& [loop, times] : seen) {
                ASSERT_EQ(times, 1) << "loop " << loop << " operation " << k << " phase " << i / 40.0;
                ASSERT_TRUE(before.contains(loop) || after.contains(loop));
            }
            for (const auto& [loop, times] : before) {
                ASSERT_TRUE(seen.contains(loop) || !after.contains(loop))
                    << "loop " << loop << " operation " << k << " phase " << i / 40.0;
            }
        }
    }
}

TEST_P(RandomMotion, AWindowShowsAPartOfTheWhole) {
    const BedWindow window{3, 7};
    for (OperationIndex k = 0; k < m_timeline.operationCount(); k += 7) {
        const BedMotion motion(m_timeline, k);
        const BedPicture part = motion.at(0.7, window);
        const BedPicture whole = motion.at(0.7, kAll);
        for (const SeenNeedle& needle : part.needles) {
            ASSERT_GE(needle.pitches, window.first);
            ASSERT_LE(needle.pitches, window.last);
            ASSERT_EQ(needle, find(whole, needle.needle));
        }
        ASSERT_EQ(part.carriers, whole.carriers);
        std::vector<SeenLink> touching;
        for (const SeenLink& link : whole.links) {
            const double a = positionPitches(link.from.needle, whole.rack);
            const double b = positionPitches(link.to.needle, whole.rack);
            if (std::max(a, b) >= window.first && std::min(a, b) <= window.last) {
                touching.push_back(link);
            }
        }
        ASSERT_EQ(part.links, touching);
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomMotion, testing::Range(1U, 9U));

const char* kCourse = "in 1\nknit + f0 1\nknit + f1 1\nknit + f2 1\n"; // operations 0..3

TEST(BedMotion, KnitClearsTheLatchBeforeTheYarnAndKnocksOverAfterIt) {
    const Timeline timeline = test::timeline(std::string(kCourse) + "knit - f2 1\n");
    const BedMotion motion(timeline, 4);
    std::vector<LoopPlace> way;
    for (int i = 0; i <= 200; ++i) {
        const BedPicture picture = motion.at(i / 200.0, kAll);
        const auto& loops = find(picture, {Bed::Front, 2}).loops;
        if (loops.front().loop == 2 && (way.empty() || way.back() != loops.front().place)) {
            way.push_back(loops.front().place);
        }
        if (loops.size() == 2) {
            EXPECT_EQ(loops[1].loop, 3);
            EXPECT_NE(loops[0].place, LoopPlace::Hook)
                << "the old loop is out of the hook when the yarn comes";
        }
    }
    EXPECT_THAT(way, ElementsAre(LoopPlace::Hook, LoopPlace::Latch, LoopPlace::Shaft, LoopPlace::OverLatch,
                                 LoopPlace::KnockedOver));
}

TEST(BedMotion, ATuckKeepsTheOldLoopAboveTheLatch) {
    const Timeline timeline = test::timeline(std::string(kCourse) + "tuck - f2 1\n");
    const BedMotion motion(timeline, 4);
    double highest = 0;
    for (int i = 0; i <= 200; ++i) {
        const BedPicture picture = motion.at(i / 200.0, kAll);
        const SeenNeedle& needle = find(picture, {Bed::Front, 2});
        highest = std::max(highest, needle.height);
        EXPECT_EQ(needle.loops.front().loop, 2);
        EXPECT_TRUE(needle.loops.front().place == LoopPlace::Hook ||
                    needle.loops.front().place == LoopPlace::Latch);
    }
    EXPECT_GT(highest, 0.2);
    EXPECT_LT(highest, kLatchLength);
}

TEST(BedMotion, RackMovesTheRearBedEvenly) {
    const Timeline timeline = test::timeline("rack 1\nrack -1\n");
    const BedMotion motion(timeline, 1);
    for (int i = 0; i <= 10; ++i) {
        const BedPicture picture = motion.at(i / 10.0, {-4, 4});
        EXPECT_NEAR(picture.rack, 1 - 2 * i / 10.0, 1e-12);
        for (const SeenNeedle& needle : picture.needles) {
            EXPECT_NEAR(needle.pitches, positionPitches(needle.needle, picture.rack), 1e-12);
        }
    }
}

TEST(BedMotion, ATransferHandsTheLoopFromHighNeedleToTheOneInsideIt) {
    const Timeline timeline = test::timeline(std::string(kCourse) + "knit - b2 1\nxfer f2 b2\n");
    const BedMotion motion(timeline, 5);
    const Needle giver{Bed::Front, 2};
    const Needle taker{Bed::Rear, 2};
    const BedPicture up = motion.at(phase::kHandOver - 0.001, kAll);
    EXPECT_GT(find(up, giver).height, 0.99);
    EXPECT_GT(find(up, giver).height, kClearHeight) << "higher than for a stitch";
    EXPECT_EQ(find(up, giver).loops.front().place, LoopPlace::Shaft);
    EXPECT_GT(find(up, taker).height, 0.3) << "the other needle is inside the loop";
    const BedPicture between = motion.at(0.7, kAll);
    ASSERT_TRUE(between.flight);
    EXPECT_THAT(between.flight->loops, testing::SizeIs(1));
    EXPECT_THAT(find(between, giver).loops, IsEmpty());
    EXPECT_THAT(find(between, taker).loops, testing::SizeIs(1));
    EXPECT_EQ(loopsOf(motion.at(0.9, kAll)).at(taker), (std::vector<LoopIndex>{3, 2}));
}

TEST(BedMotion, ARefusedTransferKeepsItsLoopAllTheTime) {
    const Timeline timeline = test::timeline(std::string(kCourse) + "xfer f2 b0\n");
    const BedMotion motion(timeline, 4);
    for (int i = 0; i <= 20; ++i) {
        const BedPicture picture = motion.at(i / 20.0, kAll);
        EXPECT_EQ(loopsOf(picture), loopsOf(timeline.stateAfter(4)));
        EXPECT_EQ(find(picture, {Bed::Rear, 0}).height, 0);
    }
}

TEST(BedMotion, AMissMovesTheCarrierAndNoNeedle) {
    const Timeline timeline = test::timeline(std::string(kCourse) + "miss + f6 1\n");
    const BedMotion motion(timeline, 4);
    const BedPicture picture = motion.at(0.5, kAll);
    for (const SeenNeedle& needle : picture.needles) {
        EXPECT_EQ(needle.height, 0);
    }
    EXPECT_GT(picture.carriers.at(0).pitches, motion.at(0, kAll).carriers.at(0).pitches);
    EXPECT_EQ(motion.at(1, kAll).carriers.at(0).pitches, 6.5);
    EXPECT_EQ(picture.carriers.at(0).yarn, (YarnEnd{{Bed::Front, 2}, 2}));
}

TEST(BedMotion, TheYarnEndsAtTheNewLoopAsSoonAsItIsLaid) {
    const Timeline timeline = test::timeline(kCourse);
    const BedMotion motion(timeline, 3);
    EXPECT_EQ(motion.at(phase::kLaid - 0.01, kAll).carriers.at(0).yarn, (YarnEnd{{Bed::Front, 1}, 1}));
    EXPECT_EQ(motion.at(phase::kLaid, kAll).carriers.at(0).yarn, (YarnEnd{{Bed::Front, 2}, 2}));
    EXPECT_EQ(motion.at(0, kAll).links.size(), 1U);
    EXPECT_EQ(motion.at(1, kAll).links.size(), 2U);
}

TEST(BedMotion, TheCarriageGoesWithTheOperations) {
    const Timeline timeline = test::timeline(std::string(kCourse) + "knit - f2 1\nrack 1\n");
    EXPECT_FALSE(BedMotion(timeline, 0).at(1, kAll).carriage);
    EXPECT_EQ(BedMotion(timeline, 2).at(1, kAll).carriage, (SeenCarriage{1, +1}));
    EXPECT_EQ(BedMotion(timeline, 4).at(1, kAll).carriage, (SeenCarriage{2, -1}));
    EXPECT_EQ(BedMotion(timeline, 5).at(0.5, kAll).carriage, (SeenCarriage{2, -1}));
    EXPECT_EQ(workingNeedle(timeline.program(), 5), (Needle{Bed::Front, 2}));
    EXPECT_FALSE(workingNeedle(timeline.program(), 0));
}

TEST(BedMotion, SlidersAreSeenWhereTheProgramUsesThem) {
    const Timeline timeline = test::timeline(std::string(kCourse) + "xfer f2 bs2\nxfer bs2 f2\n");
    for (const auto& [operation, phase, loops] :
         {std::tuple{0, 0.0, 0U}, {4, 0.0, 0U}, {4, 1.0, 1U}, {5, 0.0, 1U}, {5, 1.0, 0U}}) {
        const BedPicture picture = BedMotion(timeline, operation).at(phase, kAll);
        const auto slider = std::ranges::find_if(
            picture.needles, [](const SeenNeedle& needle) { return isSlider(needle.needle.bed); });
        ASSERT_NE(slider, picture.needles.end());
        EXPECT_EQ(slider->needle, (Needle{Bed::RearSlider, 2}));
        EXPECT_EQ(slider->loops.size(), loops) << operation << ' ' << phase;
        EXPECT_EQ(slider + 1, picture.needles.end());
    }
    const Timeline without = test::timeline(std::string(kCourse) + "xfer f2 b2\n");
    for (const SeenNeedle& needle : BedMotion(without, 4).at(0.5, kAll).needles) {
        EXPECT_FALSE(isSlider(needle.needle.bed));
    }
}

TEST(BedMotion, OutsideTheProgramNothingMoves) {
    const Timeline timeline = test::timeline(kCourse);
    EXPECT_EQ(BedMotion(timeline, -1).at(0.5, kAll), BedMotion(timeline, 0).at(0, kAll));
    EXPECT_EQ(BedMotion(timeline, 99).at(0.3, kAll), BedMotion(timeline, 3).at(1, kAll));
    const Timeline empty(Program{}, genericProfile());
    EXPECT_THAT(BedMotion(empty, 0).at(0.5, {0, 3}).carriers, IsEmpty());
}

} // namespace
} // namespace knittsim::machine
