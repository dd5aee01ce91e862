#include "ui/document/course_scale.h"
#include "ui/document/step_marks.h"

#include <gtest/gtest.h>

namespace knittsim::document {
namespace {

using machine::Operation;
using machine::OperationKind;

machine::Program program(std::initializer_list<Operation> operations) {
    machine::Program made;
    made.header.carriers = {{"1", 0, false, ""}, {"2", 1, false, ""}};
    made.operations = operations;
    return made;
}

std::shared_ptr<const machine::Timeline> timelineOf(machine::Program program) {
    return std::make_shared<const machine::Timeline>(std::move(program), machine::MachineProfile{});
}

Operation knit(int needle, int carrier) {
    return {.kind = OperationKind::Knit,
            .carriers = {carrier},
            .needle = {machine::Bed::Front, needle},
            .target = {}};
}

// 0 knit f1, 1 knit f2, 2 knit f3 with the other carrier, 3 rack 1, 4 transfer f2 to b1, 5 rack 0, 6 knit f3
StopFinder finder() {
    return {timelineOf(program(
                {knit(1, 0),
                 knit(2, 0),
                 knit(3, 1),
                 {.kind = OperationKind::Rack, .carriers = {}, .needle = {}, .target = {}, .value = 1},
                 {.kind = OperationKind::Xfer,
                  .carriers = {},
                  .needle = {machine::Bed::Front, 2},
                  .target = {machine::Bed::Rear, 1}},
                 {.kind = OperationKind::Rack, .carriers = {}, .needle = {}, .target = {}},
                 knit(3, 1)})),
            {{.id = "KS0001", .severity = Severity::Warning, .place = {.operation = 6}, .arguments = {}}}};
}

TEST(StopRules, EachRuleFindsItsOperations) {
    const StopFinder stops = finder();
    StopRules kind;
    kind.set(OperationKind::Xfer, true);
    EXPECT_EQ(stops.first(kind, 0, 7), 4);
    EXPECT_EQ(stops.first(kind, 0, 4), -1);
    EXPECT_EQ(stops.first(kind, 5, 7), -1);
    StopRules needle;
    needle.needle = machine::Needle{machine::Bed::Rear, 1};
    EXPECT_EQ(stops.first(needle, 0, 7), 4);
    StopRules carrier;
    carrier.carrier = 1;
    EXPECT_EQ(stops.first(carrier, 0, 7), 2);
    EXPECT_EQ(stops.first(carrier, 3, 7), -1) << "it has worked before, no other one came between";
    StopRules racked;
    racked.racked = true;
    EXPECT_EQ(stops.first(racked, 0, 7), 3);
    EXPECT_EQ(stops.first(racked, 4, 7), -1) << "racking back to 0 is none";
    StopRules problem;
    problem.problem = true;
    EXPECT_EQ(stops.first(problem, 0, 7), 6);
    EXPECT_EQ(stops.first({}, 0, 7), -1);
}

TEST(StopRules, NeedlesAreReadAsKnitoutWritesThem) {
    using machine::Bed;
    using machine::Needle;
    for (const Needle needle : {Needle{Bed::Front, 5}, Needle{Bed::Rear, -3}, Needle{Bed::FrontSlider, 12},
                                Needle{Bed::RearSlider, 0}}) {
        EXPECT_EQ(needleFromText(machine::toString(needle)), needle);
    }
    for (const char* wrong : {"", "f", "5", "g5", "f5x", "f 5", "f99999999999", "fs"}) {
        EXPECT_EQ(needleFromText(wrong), std::nullopt) << wrong;
    }
}

TEST(StepMarks, PlayingStopsAfterTheOperationHoweverManyAreDue) {
    StepMarks marks;
    StopRules rules;
    rules.set(OperationKind::Xfer, true);
    marks.setRules(rules);
    const StepMarks::Move move = marks.play(finder(), 0, 7, 7);
    EXPECT_EQ(move.step, 5);
    EXPECT_TRUE(move.stops);
    const StepMarks::Move next = marks.play(finder(), 5, 7, 7);
    EXPECT_EQ(next.step, 7);
    EXPECT_TRUE(next.stops) << "the end";
}

TEST(StepMarks, ARangeIsPlayedAgainAfterItsEndWasShown) {
    StepMarks marks;
    marks.setLoopFrom(2);
    EXPECT_FALSE(marks.loops());
    marks.setLoopTo(5);
    ASSERT_TRUE(marks.loops());
    EXPECT_EQ(marks.play({}, 4, 100, 7).step, 5);
    EXPECT_FALSE(marks.play({}, 4, 100, 7).stops);
    EXPECT_EQ(marks.play({}, 5, 0, 7).step, 5);
    EXPECT_EQ(marks.play({}, 5, 1, 7).step, 2);
    EXPECT_EQ(marks.play({}, 0, 1, 7).step, 1) << "from before the range one gets into it";
    marks.setLoopTo(1);
    EXPECT_FALSE(marks.loops()) << "an end before the begin takes its place";
    EXPECT_EQ(marks.loopFrom(), StepMarks::kNone);
}

TEST(StepMarks, AShorterProgramTakesTheMarksBehindItsEnd) {
    StepMarks marks;
    marks.setBookmarks({2, 5, 9});
    marks.setLoopFrom(3);
    marks.setLoopTo(9);
    marks.endAt(5);
    EXPECT_EQ(marks.bookmarks(), (std::set<StepMarks::Step>{2, 5}));
    EXPECT_EQ(marks.loopFrom(), 3);
    EXPECT_EQ(marks.loopTo(), 5);
    EXPECT_EQ(marks.play({}, 5, 1, 5).step, 3) << "the range is still played again";
    marks.endAt(3);
    EXPECT_FALSE(marks.loops());
    EXPECT_EQ(marks.loopFrom(), StepMarks::kNone);
    EXPECT_EQ(marks.bookmarks().size(), 1U);
}

TEST(StepMarks, WhatIsKeptComesBackWhole) {
    StepMarks marks;
    marks.setBookmarks({2, 9});
    marks.setLoopFrom(3);
    marks.setLoopTo(9);
    StopRules rules;
    rules.set(OperationKind::Xfer, true);
    rules.set(OperationKind::Rack, true);
    rules.needle = machine::Needle{machine::Bed::Rear, -4};
    rules.carrier = machine::CarrierIndex{1};
    rules.problem = true;
    marks.setRules(rules);
    StepMarks other;
    other.toggleBookmark(7);
    ASSERT_TRUE(other.restore(marks.save()));
    EXPECT_EQ(other.bookmarks(), marks.bookmarks());
    EXPECT_EQ(other.loopFrom(), 3);
    EXPECT_EQ(other.loopTo(), 9);
    EXPECT_EQ(other.rules(), rules);
}

TEST(StepMarks, BrokenTextMarksNothing) {
    StepMarks marks;
    marks.toggleBookmark(7);
    for (const char* text : {"", "[1, 2]", "{\"bookmarks\": [1", "noise"}) {
        EXPECT_FALSE(marks.restore(text)) << text;
    }
    EXPECT_EQ(marks.bookmarks(), (std::set<StepMarks::Step>{7}));
    EXPECT_TRUE(marks.restore(R"({"bookmarks": [-3, "x", 4, 1e99], "from": -9, "kinds": ["sing"],
        "needle": "q7", "carrier": 4000})"));
    EXPECT_EQ(marks.bookmarks(), (std::set<StepMarks::Step>{4}));
    EXPECT_FALSE(marks.loops());
    EXPECT_TRUE(marks.rules().empty());
}

TEST(StepMarks, BookmarksAreWalkedInOrder) {
    StepMarks marks;
    for (const int step : {9, 3, 6}) {
        marks.toggleBookmark(step);
    }
    EXPECT_EQ(marks.bookmarkFrom(3, +1), 6);
    EXPECT_EQ(marks.bookmarkFrom(3, -1), StepMarks::kNone);
    EXPECT_EQ(marks.bookmarkFrom(9, +1), StepMarks::kNone);
    EXPECT_EQ(marks.bookmarkFrom(7, -1), 6);
    marks.toggleBookmark(6);
    EXPECT_EQ(marks.bookmarkFrom(7, -1), 3);
}

TEST(CourseScale, EveryStepLiesInOnePartAndInsideItsEnds) {
    const CourseScale scale({4, 4, 9}, 12);
    EXPECT_EQ(scale.partCount(), 3);
    EXPECT_EQ(scale.partOf(0), 0);
    EXPECT_EQ(scale.firstNear(0), 0);
    EXPECT_EQ(scale.lastNear(0), 4);
    for (int step = 1; step <= 12; ++step) {
        const int part = scale.partOf(step);
        EXPECT_GT(step, scale.end(part - 1));
        EXPECT_LE(step, scale.end(part));
        EXPECT_EQ(scale.firstNear(step), scale.end(part - 1));
        EXPECT_EQ(scale.lastNear(step), scale.end(part));
    }
    EXPECT_EQ(CourseScale().partCount(), 0);
}

} // namespace
} // namespace knittsim::document
