#include "ui/views/step_player/playback.h"

#include <gtest/gtest.h>

namespace knittsim::ui {
namespace {

TEST(Playback, FractionsAddUpToTheExactSpeed) {
    for (const double speed : Playback::speeds()) {
        Playback playback;
        playback.setSpeed(speed);
        int done = 0;
        for (int tick = 0; tick < 1280; ++tick) {
            done += playback.advance(15.625); // 20 s in all
        }
        EXPECT_EQ(done, 20 * speed);
    }
}

TEST(Playback, TheFirstOperationComesAtOnceTheNextOnesAtTheSpeed) {
    Playback playback;
    playback.setSpeed(0.5);
    playback.makeDue();
    EXPECT_EQ(playback.advance(1), 1);
    EXPECT_EQ(playback.advance(900), 0);
    EXPECT_EQ(playback.advance(900), 0);
    EXPECT_EQ(playback.advance(250), 1);
}

TEST(Playback, AHangingWindowDoesNotSkipAhead) {
    Playback playback;
    playback.setSpeed(100);
    EXPECT_EQ(playback.advance(60'000), 100);
}

TEST(Playback, SpeedsEndAtBothEnds) {
    Playback playback;
    for (int i = 0; i < 50; ++i) {
        playback.changeSpeed(+1);
    }
    EXPECT_EQ(playback.speed(), Playback::speeds().back());
    for (int i = 0; i < 50; ++i) {
        playback.changeSpeed(-1);
    }
    EXPECT_EQ(playback.speed(), Playback::speeds().front());
}

} // namespace
} // namespace knittsim::ui
