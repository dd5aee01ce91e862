#include "core/base/message_table.h"
#include "core/formats/knitout/writer.h"
#include "core/formats/sintral/reader.h"
#include "core/machine/timeline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace knittsim::formats::sintral {
namespace {

using machine::OperationKind;
using testing::ElementsAre;
using testing::HasSubstr;

machine::Program read(const std::string& text, const std::string& jacquard = {}) {
    auto result = parse({text, "a.sin"}, {jacquard, "a.jac"});
    EXPECT_TRUE(result) << toLine(result.diagnostics().front());
    return result ? std::move(result).value() : machine::Program{};
}

/// The first finding as "rule line:column".
std::string found(const std::string& text, const std::string& jacquard = {}) {
    const auto result = parse({text, "a.sin"}, {jacquard, "a.jac"});
    if (result.diagnostics().empty()) {
        return {};
    }
    const Diagnostic& first = result.diagnostics().front();
    return first.id + ' ' + std::to_string(first.place.line) + ':' + std::to_string(first.place.column);
}

/// The operations without the header, as knitout.
std::vector<std::string> lines(const machine::Program& program) {
    std::vector<std::string> list;
    const std::string text = knitout::write(program);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        if (text[at] != ';') {
            list.push_back(text.substr(at, end - at));
        }
        at = end + 1;
    }
    return list;
}

/// Stitches only: "k f1", "t b2", "d f1" in order.
std::string stitches(const machine::Program& program) {
    std::string text;
    for (const machine::Operation& op : program.operations) {
        if (op.kind == OperationKind::Knit || op.kind == OperationKind::Tuck ||
            op.kind == OperationKind::Drop) {
            text += std::string(text.empty() ? "" : " ") + machine::toString(op.kind)[0] +
                    machine::toString(op.needle);
        }
    }
    return text;
}

std::string withRange(const std::string& text) {
    return "START\nSEN=1-4\n" + text + "\nEND\n";
}

TEST(Sintral, KnitsAllNeedlesToAndFro) {
    const auto program = read("START\n"
                              "10 SEN=1-3 C the piece\n"
                              "20 << S:R-0; Y:2; S1\n"
                              "30 >> S1\n"
                              "END\n");
    EXPECT_THAT(lines(program), ElementsAre("in 2", "rack 0.25", "knit - f3 2", "knit - f2 2", "knit - f1 2",
                                            "knit + f1 2", "knit + f2 2", "knit + f3 2", "out 2"));
    EXPECT_EQ(program.operations[2].line, 3);
    EXPECT_EQ(program.operations[5].line, 4);
}

TEST(Sintral, WorksBothBedsInTheOrderOfTheirNeedles) {
    EXPECT_EQ(stitches(read("SEN=1-2\n<< S:R-R; Y:1; S1\n>> S1\n")), "kb2 kf2 kb1 kf1 kf1 kb1 kf2 kb2");
}

TEST(Sintral, TakesSystemsAndCarriersFromTheirCycles) {
    // Three systems, then the cycle goes on with the left-over entries.
    const auto program = read("SEN=1-1\n<< S:R-R/R-0/0-R; Y:2/5/6; T1 S1 S2\n>> T1 S1 S2\n<< S1\n>> S1\n");
    EXPECT_THAT(lines(program),
                ElementsAre("in 2", "rack 0.25", "knit - b1 2", "knit - f1 2", "in 5", "knit - f1 5", "in 6",
                            "knit - b1 6", "knit + f1 2", "knit + b1 2", "knit + f1 5", "knit + b1 6",
                            "knit - b1 2", "knit - f1 2", "knit + f1 5", "out 2", "out 5", "out 6"));
}

TEST(Sintral, RepeatsListsOfCarriers) {
    const auto program = read("SEN=1-1\nREP*4\n<> S:R-0; S1\nREPEND\n", {});
    EXPECT_EQ(stitches(program), "df1 df1 df1 df1"); // no carrier: the loops fall
    std::string carriers;
    for (const auto& op : read("SEN=1-1\nY:2(4/3) 1(5);\nS:R-0;\nREP*5\n<> S1\nREPEND\n").operations) {
        if (op.kind == OperationKind::Knit) {
            carriers += std::to_string(op.carriers[0]);
        }
    }
    EXPECT_EQ(carriers, "10102"); // places in the header: 3, 4, 5
}

TEST(Sintral, SelectsDirectlyFromTheLeftEndOfTheBed) {
    EXPECT_EQ(stitches(read("SEN=3-8\n<< S:DI.-0; Y:1; S1\n")), "kf7 kf5 kf3");
    EXPECT_EQ(stitches(read("SEN=2-7\n<< S:DII.-0; Y:1; S1\n")), "kf7 kf5 kf4 kf2");
    EXPECT_EQ(stitches(read(withRange("<< S:P-0; Y:1; S1"))), "tf4 tf3 tf2 tf1");
}

const std::string kRows = "1002 .AY.\n1003 A2.A\n";

TEST(Sintral, SelectsBySymbols) {
    const std::string head = "JA1=1002 PA:JA1; SEN=1-4\n";
    EXPECT_EQ(stitches(read(head + "<< S:<1+>.-AY; Y:1; S1\n", kRows)), "kf4 kb3 kb2 kf1");
    EXPECT_EQ(stitches(read(head + "<< S:<1+>NA-0; Y:1; S1\n", kRows)), "kf4 kf3 kf1");
    EXPECT_EQ(stitches(read(head + "<< S:<1+>A%Y-0; Y:1; S1\n", kRows)), "tf3 kf2");
    EXPECT_EQ(stitches(read(head + "<< S:<1+>A-0; Y:1; S1\n>> S:<1+>A-0; S1\n", kRows)), "kf2 kf1 kf4");
    EXPECT_EQ(stitches(read(head + "<< S:<2+>A-0; Y:1; S1\n>> S:<1->A-0; S1\n", kRows)), "kf4 kf1 kf2");
}

TEST(Sintral, PlacesAFieldOfTheJacquard) {
    EXPECT_EQ(stitches(read("FA=2-3; PM:101:FA;\n<< S:A-Y; Y:1; S1\n", kRows)), "kb102 kf101");
}

TEST(Sintral, FindsJacquardRowsInTheProgramToo) {
    EXPECT_EQ(stitches(read("SEN=1-4\n<< S:A-0; Y:1; S1\n1200 A..A\n")), "kf4 kf1");
}

TEST(Sintral, ReadsRunLengthsAndContinuedRows) {
    EXPECT_EQ(stitches(read("<< S:A-0; Y:1; S1\n", "1002 .2A2(A.)$\n1003 $A\n")), "kf8 kf6 kf4 kf3 kf2");
}

TEST(Sintral, TransfersBothWaysAtARacking) {
    EXPECT_THAT(lines(read("SEN=1-3\n<< S:U^SDI.; T1 VR2\n")),
                ElementsAre("rack 2", "xfer f1 b-1", "xfer f3 b1"));
    EXPECT_THAT(lines(read("SEN=1-2\n<< S:UVSR; S1\n")), ElementsAre("xfer b1 f1", "xfer b2 f2"));
    EXPECT_THAT(lines(read("SEN=1-2\n<< S:UXSDI.-D.I; S1\n")), ElementsAre("xfer f1 b1", "xfer b2 f2"));
}

TEST(Sintral, RacksForOneStroke) {
    EXPECT_THAT(lines(read("SEN=1-1\n<< S:0-R; Y:1; S1 VL3\n>> S1\n<< S1 V#\n")),
                ElementsAre("in 1", "rack -2.75", "knit - b1 1", "rack 0.25", "knit + b1 1", "rack 0.5",
                            "knit - b1 1", "out 1"));
}

TEST(Sintral, NamesStitchCamValues) {
    EXPECT_THAT(lines(read("SEN=1-1 NP5=11.5 NP6=9\n<< S:R(5)-R(6); Y:1; S1\n")),
                ElementsAre("in 1", "rack 0.25", "x-stitch-number 9", "knit - b1 1", "x-stitch-number 11.5",
                            "knit - f1 1", "out 1"));
}

TEST(Sintral, RepeatsCountsAndJumps) {
    EXPECT_EQ(stitches(read("SEN=1-1 Y:1;\nREP*2\nREP*3\n<> S:R-0; S1\nREPEND\nREPEND\n")),
              "kf1 kf1 kf1 kf1 kf1 kf1");
    EXPECT_EQ(stitches(read("SEN=1-1 Y:1; #5=3\n"
                            "10 <> S:R-0; S1\n"
                            "11 #5=#5-1\n"
                            "12 IF #5>0 GOTO 10\n"
                            "13 IFN #5=0 <> S1\n")),
              "kf1 kf1 kf1");
    EXPECT_EQ(stitches(read("SEN=1-1 Y:1;\n"
                            "10 GOSUB 100-101\n"
                            "20 GOSUB 101-101\n"
                            "30 END\n"
                            "100 <> S:R-0; S1\n"
                            "101 <> S:0-R; S1\n")),
              "kf1 kb1 kb1");
}

TEST(Sintral, ChecksTheDirectionOfTheCarriage) {
    EXPECT_EQ(found(withRange(">> S:R-0; Y:1; S1")), "KS0152 3:1");
    EXPECT_EQ(found(withRange("<< S:R-0; Y:1; S1\n>> S0\n<< S1")), "");
    EXPECT_EQ(found(withRange("<< S:R-0; Y:1; S1\n<< S1")), "KS0152 4:1");
}

TEST(Sintral, StopsAtWhatItDoesNotKnow) {
    const auto result = parse({withRange("<< S:R-0; Y:1; S1\n20 ASCON=1"), "a.sin"}, {});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.diagnostics().front().place.line, 4);
    EXPECT_THAT(toLine(result.diagnostics().front()), HasSubstr("'ASCON=1'"));
    EXPECT_EQ(found(withRange("VV1 << S:R-0; Y:1; S1")), "KS0150 3:1");
    EXPECT_EQ(found(withRange("<< S:R/R-0; Y:1; S1")), "KS0108 3:4");
    EXPECT_EQ(found(withRange("<< S:R-0; Y:x; S1")), "KS0108 3:11");
}

TEST(Sintral, KeepsWhatItDoesNotSimulateWithOneWarningAKind) {
    const std::string text =
        withRange("WM=7 MSEC=.70 W+P=3\nMCWS1-4 SBEG\nMCWS2-3\nFBEG:A;\nASK << S9\nFEND C A\n"
                  "<< S:R-0; Y:1; S1");
    // The body of a function is parsed like all lines.
    EXPECT_EQ(found(text), "KS0150 7:1");
    const auto result =
        parse({withRange("WM=7 MSEC=.70 W+P=3\nMCWS1-4 SBEG\nMCWS2-3\nFBEG:A;\n>> S:P-0; S1\nFEND C A\n"
                         "<< S:<A>R-0; Y:1; S1\nY:=A;"),
               "a.sin"},
              {});
    ASSERT_TRUE(result);
    std::string kinds;
    for (const Diagnostic& warning : result.diagnostics()) {
        kinds += warning.id + ' ' + warning.arguments.at(0) + '\n';
    }
    EXPECT_EQ(kinds, "KS0151 'MCWS1-4'\nKS0151 'SBEG'\nKS0151 'FBEG:A'\nKS0151 'S:<A>R-0'\nKS0151 'Y:=A'\n");
    EXPECT_EQ(stitches(result.value()), "kf4 kf3 kf2 kf1");
    EXPECT_THAT(lines(result.value()), testing::Contains("x-sintral WM=7"));
}

TEST(Sintral, SaysWhatIsMissing) {
    EXPECT_EQ(found("<< S:R-0; Y:1; S1\n"), "KS0154 1:1");
    EXPECT_EQ(found(withRange("<< S1")), "KS0159 3:1");
    EXPECT_EQ(found(withRange("REPEND")), "KS0159 3:1");
    EXPECT_EQ(found(withRange("GOTO 77")), "KS0155 3:1");
    EXPECT_EQ(found(withRange("GOSUB 1-2")), "KS0155 3:1");
    EXPECT_EQ(found(withRange("JA1=1007")), "KS0155 3:1");
    EXPECT_EQ(found(withRange("<< S:A-0; Y:1; S1")), "KS0157 3:1");
    EXPECT_EQ(found(withRange("<< S:<3+>A-0; Y:1; S1"), kRows), "KS0157 3:1");
    EXPECT_EQ(found(withRange("YG:6/23; << S:R-0; Y:1; S1")), "KS0158 3:1");
    EXPECT_EQ(found(withRange("YG:1/23; << S:R-0; Y:1; S1")), "");
    EXPECT_EQ(found(withRange("WM=1\n"), "1002 AA$\n"), "KS0153 1:1");
    EXPECT_EQ(found(withRange("WM=1\n"), "AA\n"), "KS0153 1:1");
    EXPECT_EQ(found(withRange("WM=1\n"), "1002 3(A\n"), "KS0153 1:6");
    EXPECT_EQ(found("START\nEND\n"), "KS0121 2:1");
}

TEST(Sintral, EndsEndlessPrograms) {
    EXPECT_EQ(found(withRange("10 GOTO 10")).substr(0, 6), "KS0156");
    EXPECT_EQ(found(withRange("10 <> S:0-0; S1\n11 GOTO 10")).substr(0, 6), "KS0156");
    EXPECT_EQ(found(withRange("10 GOSUB 10-10")).substr(0, 6), "KS0156");
    EXPECT_EQ(found(withRange("10 REP*2\n11 GOTO 10")).substr(0, 6), "KS0156");
}

/// The colours on the technical face of a jacquard are those of its picture, whatever its backing does.
TEST(Sintral, KnitsThePictureOfAJacquardOnTheFace) {
    const std::vector<std::string> picture{".A.AYY", "A.YA.Y", "YY..AA", ".AY.AY"};
    std::string rows;
    for (std::size_t i = 0; i < picture.size(); ++i) {
        rows += std::to_string(1002 + i) + ' ' + picture[i] + '\n';
    }
    const auto program = read("START\n"
                              "1 NP5=11 NP6=12 JA1=1002 PA:JA1; SEN=1-6 YG:2/34;\n"
                              "5 << S:R-R; Y:2; S1\n"
                              "6 >> S0\n"
                              "7 REP*4\n"
                              "10 << S:<1+>.(5)-R(6)/A-.Y/Y-.A; Y:2/3/4; SX SX SX\n"
                              "11 >> S0\n"
                              "12 REPEND\n"
                              "END\n",
                              rows);
    const machine::Timeline timeline(program, machine::genericProfile());
    EXPECT_TRUE(timeline.diagnostics().empty());
    std::vector<std::string> face(picture.size(), std::string(6, '?'));
    std::vector<std::size_t> next(7, 0);
    for (const machine::Loop& loop : timeline.loops().loops) {
        const auto wale = static_cast<std::size_t>(loop.needle.index);
        if (loop.needle.bed != machine::Bed::Front || loop.operation < 14) {
            continue; // the first course casts on
        }
        const std::string& name = program.header.carriers[loop.carrier].name;
        face.at(next[wale]++)[wale - 1] = name == "2" ? '.' : name == "3" ? 'A' : 'Y';
    }
    EXPECT_EQ(face, picture);
    EXPECT_FALSE(program.header.carriers[0].parksRight);
    EXPECT_TRUE(program.header.carriers[1].parksRight);
}

} // namespace
} // namespace knittsim::formats::sintral
