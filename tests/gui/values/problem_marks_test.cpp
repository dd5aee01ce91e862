#include "tests/support/build.h"
#include "ui/document/problem_marks.h"

#include <gtest/gtest.h>

namespace knittsim::document {
namespace {

Diagnostic problem(const char* id, Severity severity, int operation) {
    return {id, severity, Place{.operation = operation}, {}};
}

// Operations: 0 in, 1 to 3 knit (loops 0 to 2), 4 rack, 5 xfer of f2, 6 out.
const char* const kProgram = "in 1\nknit + f1 1\nknit + f2 1\nknit + f3 1\nrack 1\nxfer f2 b1\nout 1\n";

TEST(ProblemMarks, TheWorstOneOfAStitchCountsAndNotesDoNot) {
    const machine::Timeline timeline = test::timeline(kProgram);
    const ProblemMarks marks =
        problemMarks(timeline, {problem("A", Severity::Info, 1), problem("B", Severity::Warning, 2),
                                problem("C", Severity::Error, 2), problem("D", Severity::Warning, 2)});
    ASSERT_EQ(marks.size(), 1u);
    EXPECT_EQ(marks.at(1).id, "C");
}

TEST(ProblemMarks, ATransferBelongsToTheStitchOfItsNeedle) {
    const machine::Timeline timeline = test::timeline(kProgram);
    EXPECT_EQ(problemMarks(timeline, {problem("A", Severity::Error, 5)}).begin()->first, 1);
}

TEST(ProblemMarks, WhatHasNoPlaceIsNotMarked) {
    const machine::Timeline timeline = test::timeline(kProgram);
    for (const int operation : {-1, 0, 4, 6, 7, 1000}) {
        EXPECT_TRUE(problemMarks(timeline, {problem("A", Severity::Error, operation)}).empty()) << operation;
    }
}

} // namespace
} // namespace knittsim::document
