#include "core/fabric/braid_word.h"
#include "tests/support/build.h"

#include <gmock/gmock.h>

namespace knittsim::fabric {
namespace {

using test::build;
using test::pass;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Optional;

using Strands = std::vector<std::vector<LoopIndex>>;
enum class Front { Left, Right };

std::string xfer(char from, int a, char to, int b) {
    return "xfer " + (from + std::to_string(a)) + ' ' + (to + std::to_string(b)) + '\n';
}

/// `width` needles from `at` change places with the next `width`; the loops of one half lie in front.
std::string cable(int at, int width, Front front) {
    std::string lines;
    for (int i = 0; i < 2 * width; ++i) {
        lines += xfer('f', at + i, 'b', at + i);
    }
    const auto move = [&](int first, int by) {
        lines += "rack " + std::to_string(by) + '\n';
        for (int i = 0; i < width; ++i) {
            lines += xfer('b', first + i, 'f', first + i + by);
        }
    };
    if (front == Front::Left) {
        move(at, width);
        move(at + width, -width);
    } else {
        move(at + width, -width);
        move(at, width);
    }
    return lines + "rack 0\n";
}

const std::string kSix = "in 1\n" + pass("knit", 'f', 0, 5, 1);
const Strands kSingles{{0}, {1}, {2}};
const Strands kPairs{{0, 1}, {2, 3}, {4, 5}};

TEST(Braid, OneCableIsOneLetter) {
    EXPECT_THAT(braidWord(build(kSix + cable(0, 1, Front::Left)), kSingles), Optional(ElementsAre(1)));
    EXPECT_THAT(braidWord(build(kSix + cable(0, 1, Front::Right)), kSingles), Optional(ElementsAre(-1)));
    EXPECT_THAT(braidWord(build(kSix + cable(1, 1, Front::Left)), kSingles), Optional(ElementsAre(2)));
    EXPECT_THAT(braidWord(build(kSix), kSingles), Optional(IsEmpty()));
}

TEST(Braid, ThreeCablesOverThreeStrands) {
    const std::string plait = cable(0, 1, Front::Left) + cable(1, 1, Front::Right) + cable(0, 1, Front::Left);
    EXPECT_THAT(braidWord(build(kSix + plait), kSingles), Optional(ElementsAre(1, -2, 1)));
}

TEST(Braid, ThreeCablesOfTwoLoopsEach) {
    const std::string plait = cable(0, 2, Front::Left) + cable(2, 2, Front::Right) + cable(0, 2, Front::Left);
    const Fabric fabric = build(kSix + plait);
    EXPECT_EQ(fabric.crossings.size(), 3U * 16U);
    EXPECT_THAT(braidWord(fabric, kPairs), Optional(ElementsAre(1, -2, 1)));
}

TEST(Braid, AllSixLettersOfAPlaitStay) {
    std::string plait;
    for (int i = 0; i < 3; ++i) {
        plait += cable(0, 1, Front::Left) + cable(1, 1, Front::Right);
    }
    EXPECT_THAT(braidWord(build(kSix + plait), kSingles), Optional(ElementsAre(1, -2, 1, -2, 1, -2)))
        << "every two strands come back to each other's place, and still nothing comes undone";
}

TEST(Braid, AFullTwistStaysAndItsInverseUndoesIt) {
    const std::string twist = cable(0, 1, Front::Left) + cable(0, 1, Front::Left);
    EXPECT_THAT(braidWord(build(kSix + twist), kSingles), Optional(ElementsAre(1, 1)));
    const std::string back = cable(0, 1, Front::Right) + cable(0, 1, Front::Right);
    EXPECT_THAT(braidWord(build(kSix + twist + back), kSingles), Optional(IsEmpty()));
    EXPECT_TRUE(build(kSix + twist + back).crossings.empty());
}

TEST(Braid, AWordAndItsInverseComeToNothing) {
    const std::string word = cable(0, 1, Front::Left) + cable(1, 1, Front::Right) +
                             cable(0, 1, Front::Right) + cable(1, 1, Front::Left);
    const std::string inverse = cable(1, 1, Front::Right) + cable(0, 1, Front::Left) +
                                cable(1, 1, Front::Left) + cable(0, 1, Front::Right);
    EXPECT_EQ(build(kSix + word).crossings.size(), 4U * 4U);
    EXPECT_TRUE(build(kSix + word + inverse).crossings.empty());
}

// The braid relation: 1 2 1 = 2 1 2, so one after the inverse of the other is nothing. This takes the third
// Reidemeister move.
TEST(Braid, TheBraidRelationHolds) {
    const std::string one = cable(0, 1, Front::Left) + cable(1, 1, Front::Left) + cable(0, 1, Front::Left);
    const std::string otherBack =
        cable(1, 1, Front::Right) + cable(0, 1, Front::Right) + cable(1, 1, Front::Right);
    EXPECT_EQ(build(kSix + one).crossings.size(), 3U * 4U);
    EXPECT_TRUE(build(kSix + one + otherBack).crossings.empty());
}

TEST(Braid, AStrandThroughTheGapIsSlidOut) {
    // The second loop passes behind the first and the third one; the third follows it to the rear bed, and
    // both come back. Only the first and the third have changed places with the second.
    const Fabric fabric =
        build("in 1\n" + pass("knit", 'f', 0, 2, 1) + "xfer f2 b2\nrack -3\nxfer f0 b3\nrack 0.25\n");
    // b2 went from 2 to -1 and back; b3 stands at 3.25.
    EXPECT_THAT(braidWord(fabric, kSingles), Optional(ElementsAre(-1, 2)));
}

TEST(Braid, HalfAPairIsNoBraidOfPairs) {
    EXPECT_EQ(braidWord(build(kSix + cable(1, 1, Front::Left)), kPairs), std::nullopt);
}

} // namespace
} // namespace knittsim::fabric
