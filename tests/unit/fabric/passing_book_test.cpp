#include "core/fabric/passing_book.h"

#include <gmock/gmock.h>

#include <array>

namespace knittsim::fabric {
namespace {

using testing::ElementsAre;

constexpr Strand kA{Strand::Kind::Loop, 0};
constexpr Strand kB{Strand::Kind::Loop, 1};
constexpr Strand kX{Strand::Kind::Loop, 2};
constexpr Strand kY{Strand::Kind::Loop, 3};

/// Of four loops, by hand.
struct Book {
    Book() {
        for (int i = 0; i < 4; ++i) {
            book.addLoop();
        }
    }

    void pass(Strand over, Strand under, int sign) {
        const std::array pairs{PassingBook::Pair{over, under, sign}};
        book.pass(pairs, 0, ++moment);
    }

    /// Both at one moment, told in either order.
    void passBoth(const PassingBook::Pair& a, const PassingBook::Pair& b, bool aFirst) {
        const std::array pairs{aFirst ? a : b, aFirst ? b : a};
        book.pass(pairs, 0, ++moment);
    }

    /// The first passing of the two that lie on a strand.
    const Passing& firstOfTwo(Strand strand) const {
        EXPECT_EQ(book.on(strand).size(), 2U);
        return book.passings()[static_cast<std::size_t>(book.on(strand).at(0))];
    }

    PassingBook book;
    std::int32_t moment = 0;
};

TEST(PassingBook, ThereAndBackIsNothing) {
    Book test;
    test.pass(kA, kB, 1);
    test.pass(kA, kB, -1);
    EXPECT_TRUE(test.book.on(kA).empty());
    EXPECT_TRUE(test.book.on(kB).empty());
}

TEST(PassingBook, BackWithTheOtherOneInFrontStays) {
    Book test;
    test.pass(kA, kB, 1);
    test.pass(kB, kA, 1);
    EXPECT_THAT(test.book.on(kA), ElementsAre(0, 1));
}

TEST(PassingBook, AStrandThatRunsThroughTheGapIsSlidAcross) {
    Book test;
    test.pass(kA, kB, 1);
    test.pass(kA, kX, 1); // X comes from the right, past A and then past B
    test.pass(kB, kX, 1);
    test.pass(kA, kB, -1);
    EXPECT_TRUE(test.book.passings()[0].undone);
    EXPECT_THAT(test.book.on(kX), ElementsAre(2, 1)) << "now past B first";
}

/// Of two strands with as many passings in the gap one has another strand twice: nothing can slide there.
TEST(PassingBook, AStrandThatPassesTheGapTwiceIsInTheWay) {
    Book test;
    test.pass(kB, kY, -1);
    test.pass(kA, kB, 1);
    test.pass(kX, kB, 1);
    test.pass(kA, kX, 1);
    test.pass(kB, kX, 1);
    test.pass(kA, kY, -1);
    test.pass(kA, kB, -1);
    EXPECT_FALSE(test.book.passings()[1].undone);
    EXPECT_THAT(test.book.on(kA), ElementsAre(1, 3, 5, 6));
    EXPECT_THAT(test.book.on(kB), ElementsAre(0, 1, 2, 4, 6));
}

/// X passes A and B, which stand at one place, on its way to the right. When A goes to the right past B it is
/// known that it stood on the left, so that X met it first.
TEST(PassingBook, WhatStoodAtOnePlaceIsPutInOrderWhenItParts) {
    for (const bool leftFirst : {true, false}) {
        Book test;
        test.passBoth({kX, kA, 1}, {kX, kB, 1}, leftFirst);
        test.pass(kA, kB, 1);
        EXPECT_EQ(test.firstOfTwo(kX).under, kA);
    }
}

/// A stands on the right of B since it passed it. X, which then passes both at one moment on its way to the
/// right, meets B first, though A is older; the same on the way back.
TEST(PassingBook, WhatIsPassedAtOneMomentLiesInItsKnownOrder) {
    for (const bool leftFirst : {true, false}) {
        Book test;
        test.pass(kA, kB, 1);
        test.passBoth({kX, kB, 1}, {kA, kX, -1}, leftFirst);
        EXPECT_EQ(test.firstOfTwo(kX).other(kX), kB);
        test.pass(kA, kB, -1); // X lies in the gap and runs through
        EXPECT_TRUE(test.book.passings()[0].undone);
    }
}

/// Y passes in front of both A and B, X behind both: neither A nor B slides across them in front or behind,
/// but every single move is one.
TEST(PassingBook, AThirdMoveMayGoInFrontOfOneStrandAndBehindAnother) {
    Book test;
    test.pass(kA, kB, 1);
    test.pass(kY, kB, 1);
    test.pass(kY, kA, 1);
    test.pass(kB, kX, -1);
    test.pass(kA, kX, -1);
    test.pass(kA, kB, -1);
    EXPECT_TRUE(test.book.passings()[0].undone);
    EXPECT_THAT(test.book.on(kY), ElementsAre(2, 1));
    EXPECT_THAT(test.book.on(kX), ElementsAre(4, 3));
}

/// X runs in front of A, which is in front of B, and behind B: no move leads across the three.
TEST(PassingBook, AStrandInFrontOfTheFrontOneAndBehindTheRearOneIsInTheWay) {
    Book test;
    test.pass(kA, kB, 1);
    test.pass(kB, kX, -1);
    test.pass(kX, kA, 1);
    test.pass(kA, kB, -1);
    EXPECT_FALSE(test.book.passings()[0].undone);
    EXPECT_THAT(test.book.on(kX), ElementsAre(1, 2));
}

/// X ran through the gap to the right, was held there by Y and ran back: each time it is slid across.
TEST(PassingBook, AStrandMayRunThroughTheGapMoreThanOnce) {
    Book test;
    test.pass(kA, kB, 1);
    test.pass(kB, kX, -1);
    test.pass(kA, kX, -1);
    test.pass(kX, kY, 1);
    test.pass(kY, kX, 1);
    test.pass(kA, kX, 1);
    test.pass(kB, kX, 1);
    test.pass(kA, kB, -1);
    EXPECT_TRUE(test.book.passings()[0].undone);
    EXPECT_THAT(test.book.on(kX), ElementsAre(2, 1, 3, 4, 6, 5));
    EXPECT_THAT(test.book.on(kA), ElementsAre(2, 5));
    EXPECT_THAT(test.book.on(kB), ElementsAre(1, 6));
}

/// A and B face each other from the beginning and part, A on the left. X passes them one after the other.
/// Then A goes past B: so it stood on the right from the beginning, and X met B first.
TEST(PassingBook, WhatPartedAndGoesPastStoodTheOtherWayRoundFromTheBeginning) {
    Book test;
    test.book.part({kA, kB, -1});
    test.pass(kA, kX, -1);
    test.pass(kX, kB, 1);
    EXPECT_TRUE(test.book.turnRound({kA, kB, 1}));
    EXPECT_THAT(test.book.on(kX), ElementsAre(1, 0));
    test.pass(kA, kX, 1);
    test.pass(kX, kB, -1);
    EXPECT_TRUE(test.book.on(kX).empty()) << "X came back past A first";
}

/// X passed A only, that is, it ends between A and B: they cannot have stood the other way round.
TEST(PassingBook, WhatHasAStrandBetweenItDoesNotTurnRound) {
    Book test;
    test.book.part({kA, kB, -1});
    test.pass(kA, kX, -1);
    EXPECT_FALSE(test.book.turnRound({kA, kB, 1}));
    test.pass(kA, kB, 1);
    EXPECT_THAT(test.book.on(kB), ElementsAre(1));
}

/// What A passed before B was made does not lie between them.
TEST(PassingBook, WhatOneOfThemPassedBeforeTheOtherWasMadeIsNotInTheWay) {
    PassingBook book;
    book.addLoop();
    book.addFloat();
    const Strand early{Strand::Kind::Float, 0};
    const std::array pairs{PassingBook::Pair{kA, early, 1}};
    book.pass(pairs, 0, 1);
    book.bar(0, 1);
    book.addLoop(1); // in a split: drawn through A
    book.part({kA, kB, -1});
    EXPECT_TRUE(book.turnRound({kA, kB, 1}));
    book.bar(0, 2);
    EXPECT_FALSE(book.turnRound({kA, kB, -1})) << "a loop was drawn through A since";
}

/// A stood on the left of Y before they came to hang on one needle, which X passes to the right. On the way
/// back it passes Y first.
TEST(PassingBook, AStackIsPassedBackInItsOrder) {
    Book test;
    test.book.part({kA, kY, -1});
    const std::array there{PassingBook::Pair{kX, kA, 1}, PassingBook::Pair{kX, kY, 1}};
    test.book.pass(there, 0, ++test.moment);
    const std::array back{PassingBook::Pair{kX, kA, -1}, PassingBook::Pair{kX, kY, -1}};
    EXPECT_TRUE(test.book.passBack(back, 0, ++test.moment));
    EXPECT_TRUE(test.book.on(kX).empty());
}

/// The first of a stack has passed nothing: then nothing is undone.
TEST(PassingBook, AStackThatComesToFacePassesBackWithItsFirst) {
    Book test;
    test.pass(kA, kX, 1);
    const std::array back{PassingBook::Pair{kY, kX, -1}, PassingBook::Pair{kA, kX, -1}};
    EXPECT_FALSE(test.book.passBack(back, 0, ++test.moment));
    ASSERT_EQ(test.book.on(kA).size(), 1U);
    const auto sign = test.book.passings()[static_cast<std::size_t>(test.book.on(kA)[0])].sign;
    EXPECT_EQ(sign, 1);
    EXPECT_TRUE(test.book.on(kY).empty());
}

/// The limit that the header names. A lies in front of X and X in front of B; one third move of the three
/// leads from the first diagram to the second one. Then A and X are clasped and X goes back past B. From the
/// second diagram the move would have to be taken back before X is free of B.
TEST(PassingBook, AThirdMoveThatOnlyMakesRoomIsNotLookedFor) {
    const auto claspAndBack = [](Book& test) {
        test.pass(kX, kA, 1);
        test.pass(kX, kB, 1);
    };
    Book first;
    first.pass(kA, kX, 1);
    first.pass(kX, kB, -1);
    first.pass(kA, kB, -1);
    claspAndBack(first);
    EXPECT_TRUE(first.book.passings()[1].undone);
    Book second;
    second.pass(kA, kB, -1);
    second.pass(kX, kB, -1);
    second.pass(kA, kX, 1);
    claspAndBack(second);
    EXPECT_FALSE(second.book.passings()[1].undone) << "right, but with two crossings more";
    EXPECT_THAT(second.book.on(kB), ElementsAre(0, 1, 4));
}

} // namespace
} // namespace knittsim::fabric
