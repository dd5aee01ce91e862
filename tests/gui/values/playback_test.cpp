#include "ui/views/step_player/playback.h"

#include <gtest/gtest.h>

namespace knittsim::ui {
namespace {

TEST(Playback, FractionsAddUpToTheExactSpeed) {
    for (const int speed : Playback::speeds()) {
        Playback playback;
        playback.setSpeed(speed);
        int done = 0;
        for (int tick = 0; tick < 640; ++tick) {
            done += playback.advance(15.625); // 10 s in all
        }
        EXPECT_EQ(done, 10 * speed);
    }
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
