#include "core/base/message_table.h"
#include "core/formats/knitout/reader.h"
#include "core/formats/knitout/writer.h"
#include "tests/support/compare_programs.h"
#include "tests/support/random_program.h"

#include <gtest/gtest.h>

namespace knittsim::formats::knitout {
namespace {

using machine::Bed;
using machine::Direction;
using machine::Operation;
using machine::OperationKind;
using machine::Program;

/// Empty when parse(write(p)) is p again.
std::string lossOf(const Program& program) {
    const std::string text = write(program);
    const auto again = parse(text, "again.k");
    if (!again) {
        return toLine(again.diagnostics().front()) + "\n" + text;
    }
    return test::difference(program, again.value());
}

Program withCarriers() {
    Program program;
    program.header.carriers = {
        {"A", 0, false, "red wool"}, {"B", 0, true, ""}, {"3", 1, true, ""}, {"4", 2, false, ""}};
    return program;
}

TEST(KnitoutRoundTrip, KeepsEveryHeader) {
    Program program = withCarriers();
    program.header.version = 3;
    program.header.machine = "SWG091N2";
    program.header.gauge = 7.3;
    program.header.position = "Center";
    program.header.width = 252;
    program.header.others = {
        {"X-Presser", "on"}, {"X-Empty", ""}, {"Note", "a; b: c"}, {"Yarn-9", "not here"}};
    EXPECT_EQ(lossOf(program), "");
    EXPECT_EQ(lossOf(Program{}), "");
}

TEST(KnitoutRoundTrip, KeepsEveryKindOfOperation) {
    for (int kind = 0; kind < machine::kOperationKindCount; ++kind) {
        Program program = withCarriers();
        program.texts = {kind == static_cast<int>(OperationKind::Colour) ? "#0a0b0c" : "x-own  word 7"};
        Operation op;
        op.kind = static_cast<OperationKind>(kind);
        // Every operation gets just what it has a place for.
        const bool extension = op.kind == OperationKind::Extension || op.kind == OperationKind::Colour;
        op.text = extension ? 0 : -1;
        switch (op.kind) {
        case OperationKind::Knit:
        case OperationKind::Tuck:
        case OperationKind::Split:
        case OperationKind::Miss:
        case OperationKind::YarnIn:
        case OperationKind::YarnOut:
            op.direction = Direction::Left;
            op.needle = {Bed::Rear, -7};
            op.carriers = {2, 0};
            op.target =
                op.kind == OperationKind::Split ? machine::Needle{Bed::FrontSlider, 3} : machine::Needle{};
            break;
        case OperationKind::Xfer:
            op.needle = {Bed::Front, 1};
            op.target = {Bed::Rear, 2};
            break;
        case OperationKind::Drop:
        case OperationKind::Amiss:
            op.needle = {Bed::RearSlider, 9};
            break;
        case OperationKind::StitchSize:
            op.value = 0.1;
            op.value2 = -12;
            break;
        case OperationKind::StitchNumber:
        case OperationKind::Rack:
            op.value = 1.0 / 3;
            break;
        case OperationKind::Extension:
        case OperationKind::Pause:
            break;
        default:
            op.carriers = {3};
        }
        program.operations = {op};
        EXPECT_EQ(lossOf(program), "") << machine::toString(op.kind);
    }
}

TEST(KnitoutRoundTrip, KeepsSourceComments) {
    Program program = withCarriers();
    program.operations.resize(2);
    program.sourceComments = {{0, ";!source: a"}, {0, ";!source:b "}, {2, ";!source: end"}};
    EXPECT_EQ(lossOf(program), "");
}

TEST(KnitoutWriter, LetsNoTextAddAnOperation) {
    Program program = withCarriers();
    program.header.machine = "x\npause";
    program.texts = {"x-evil 1\npause\r\npause"};
    program.operations.resize(1);
    program.operations[0].kind = OperationKind::Extension;
    program.operations[0].text = 0;
    program.sourceComments = {{0, ";!source: a\ndrop f1"}};
    const auto again = parse(write(program), "again.k");
    ASSERT_TRUE(again);
    EXPECT_EQ(again.value().operations.size(), 1u);
}

TEST(KnitoutWriter, PutsCarriersIntoTheOrderOfTheRails) {
    Program program;
    program.header.carriers = {{"back", 5, false, ""}, {"right", 1, true, ""}, {"left", 1, false, ""}};
    program.operations.resize(1);
    program.operations[0].kind = OperationKind::In;
    program.operations[0].carriers = {0, 1};
    const std::string text = write(program);
    EXPECT_NE(text.find(";;Carriers: left;right back\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\nin back right\n"), std::string::npos) << text;
}

TEST(KnitoutWriter, WritesWhatAPersonWouldWrite) {
    const std::string text =
        ";!knitout-2\n;;Carriers: 1 2\n;;Gauge: 15\nrack 0.25\nknit + f-1 1 2\nxfer f1 b2\nout 1\n";
    EXPECT_EQ(write(parse(text, "a.k").value()), text);
}

class RandomRoundTrip : public testing::TestWithParam<std::uint32_t> {};

TEST_P(RandomRoundTrip, LosesNothing) {
    const Program program = test::randomProgram({.seed = GetParam(), .operations = 500, .carriers = 4});
    ASSERT_GE(program.operations.size(), 500u);
    EXPECT_EQ(lossOf(program), "");
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomRoundTrip, testing::Range(1u, 41u));

} // namespace
} // namespace knittsim::formats::knitout
