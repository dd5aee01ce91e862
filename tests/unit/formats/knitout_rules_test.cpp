#include "core/base/message_table.h"
#include "core/formats/knitout/reader.h"
#include "core/formats/text_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ostream>

namespace knittsim::formats::knitout {
namespace {

constexpr const char* kHeader = ";!knitout-2\n;;Carriers: 1 2 3\n";

/// A small broken file and the one finding it must give.
struct Rule {
    const char* name;
    std::string text;
    Diagnostic finding;
};

Diagnostic error(const char* id, int line, int column, std::vector<std::string> arguments = {}) {
    return {id, Severity::Error, Place{.file = "a.k", .line = line, .column = column}, std::move(arguments)};
}

Diagnostic warning(const char* id, int line, int column, std::vector<std::string> arguments = {}) {
    return {id, Severity::Warning, Place{.file = "a.k", .line = line, .column = column},
            std::move(arguments)};
}

std::ostream& operator<<(std::ostream& out, const Rule& rule) {
    return out << rule.name;
}

std::string body(const std::string& lines) {
    return kHeader + lines;
}

std::string header(const std::string& lines) {
    return ";!knitout-2\n" + lines + "pause\n";
}

std::string carriers(int count) {
    std::string line = ";;Carriers:";
    for (int i = 0; i < count; ++i) {
        line += ' ' + std::to_string(i);
    }
    return line + '\n';
}

class KnitoutRule : public testing::TestWithParam<Rule> {};

TEST_P(KnitoutRule, IsReportedOnceAtItsPlace) {
    const auto result = parse(GetParam().text, "a.k");
    ASSERT_EQ(result.diagnostics().size(), 1u) << toLine(result.diagnostics().back());
    Diagnostic found = result.diagnostics().front();
    found.place.operation = -1;
    EXPECT_EQ(found, GetParam().finding) << toLine(found);
    EXPECT_EQ(result.hasValue(), found.severity != Severity::Error);
}

TEST_P(KnitoutRule, HasSentencesForAllItsArguments) {
    const auto result = parse(GetParam().text, "a.k");
    for (const Diagnostic& found : result.diagnostics()) {
        ASSERT_NE(findMessage(found.id), nullptr) << found.id;
        EXPECT_THAT(causeText(found), testing::Not(testing::ContainsRegex("\\{[0-9]\\}")));
        EXPECT_THAT(cureText(found), testing::Not(testing::ContainsRegex("\\{[0-9]\\}")));
    }
}

const auto nameOf = [](const testing::TestParamInfo<Rule>& info) { return std::string(info.param.name); };

INSTANTIATE_TEST_SUITE_P(
    File, KnitoutRule,
    testing::Values(Rule{"NoMagic", ";;Carriers: 1\npause\n", warning("KS0101", 1, 1, {"';;Carriers: 1'"})},
                    Rule{"LateMagic", ";;Carriers: 1\n;!knitout-2\npause\n",
                         warning("KS0101", 1, 1, {"';;Carriers: 1'"})},
                    Rule{"MagicWithoutNumber", ";!knitout-two\n;;Carriers: 1\npause\n",
                         warning("KS0101", 1, 1, {"';!knitout-two'"})},
                    Rule{"ByteOrderMark", "\xEF\xBB\xBF" + body("pause\n"),
                         warning("KS0126", 1, 1)},
                    Rule{"NewerVersion", ";!knitout-3\n;;Carriers: 1\npause\n",
                         warning("KS0102", 1, 11, {"3"})},
                    Rule{"WindowsLineEnds", body("pause\r\npause\r\n"), warning("KS0112", 3, 6)},
                    Rule{"WindowsLineEndsFromTheTop", ";!knitout-2\r\n;;Carriers: 1\r\npause\r\n",
                         warning("KS0112", 1, 12)},
                    Rule{"NotUtf8",
                         body("pause ;\xFC"
                              "ber\n"),
                         warning("KS0113", 3, 8)},
                    Rule{"LongLine", body("pause\n;" + std::string(kMaxLineBytes, 'x') + "\npause\n"),
                         error("KS0116", 4, 1, {"65537", "65536"})},
                    Rule{"NulByte", body(std::string("pause\npau\0se\n\0\n", 15)), error("KS0122", 4, 4)},
                    Rule{"NoOperation", body("; nothing\n"), warning("KS0121", 3, 1)}),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    Header, KnitoutRule,
    testing::Values(
        Rule{"NoCarriersNeeded", ";!knitout-2\nknit + f1\n", warning("KS0103", 1, 1)},
        Rule{"NoCarriers", ";!knitout-2\n;c\nknit + f1 7\nknit + f2 8\nx-vis-color #000000 7\n",
             error("KS0103", 3, 11)},
        Rule{"EmptyCarriers", header(";;Carriers:\n"),
             error("KS0104", 2, 12, {"Carriers", "nothing", "the names of the carriers, for example 1 2 3"})},
        Rule{"CarrierTwice", header(";;Carriers: 1 2 1\n"),
             error("KS0104", 2, 17, {"Carriers", "'1' twice", "every carrier once"})},
        Rule{"ThreeSides", header(";;Carriers: A;B;C\n"),
             error("KS0104", 2, 13, {"Carriers", "'A;B;C'", "a rail such as L1,L2;R1"})},
        Rule{"NoSide", header(";;Carriers: A ;\n"),
             error("KS0104", 2, 15, {"Carriers", "';'", "a rail such as L1,L2;R1"})},
        Rule{"EmptyName", header(";;Carriers: A,,B\n"),
             error("KS0104", 2, 15, {"Carriers", "an empty name", "a name between the commas"})},
        Rule{"CommaAtTheEnd", header(";;Carriers: X;A,\n"),
             error("KS0104", 2, 17, {"Carriers", "an empty name", "a name between the commas"})},
        Rule{"FaultyCarriersAreSaidOnce", ";!knitout-2\n;;Carriers: ,\nknit + f1 1\n",
             error("KS0104", 2, 13, {"Carriers", "an empty name", "a name between the commas"})},
        Rule{"Gauge", header(";;Carriers: 1\n;;Gauge: fine\n"),
             error("KS0104", 3, 10, {"Gauge", "'fine'", "a number of needles per inch up to 1000"})},
        Rule{"GaugeZero", header(";;Carriers: 1\n;;Gauge: 0\n"),
             error("KS0104", 3, 10, {"Gauge", "'0'", "a number of needles per inch up to 1000"})},
        Rule{"GaugeNan", header(";;Carriers: 1\n;;Gauge: nan\n"),
             error("KS0104", 3, 10, {"Gauge", "'nan'", "a number of needles per inch up to 1000"})},
        Rule{"Width", header(";;Carriers: 1\n;;Width: 12.5\n"),
             error("KS0104", 3, 10, {"Width", "'12.5'", "a whole number of needles from 1 to 1000000"})},
        Rule{"Position", header(";;Carriers: 1\n;;Position: Middle\n"),
             error("KS0104", 3, 13, {"Position", "'Middle'", "Left, Center, Right or Keep"})},
        Rule{"Twice", header(";;Carriers: 1\n;;Gauge: 7\n;;Gauge: 15\n"), warning("KS0105", 4, 1, {"Gauge"})},
        Rule{"Late", body("pause\n;;Machine: SWGXYZ\n"), warning("KS0106", 4, 1, {"Machine"})},
        Rule{"YarnOfNoCarrier", header(";;Carriers: 1\n;;Yarn-9: wool\n"), warning("KS0109", 3, 8, {"9"})},
        Rule{"NoBlank", header(";;Carriers:1 2\n"), warning("KS0114", 2, 12, {"Carriers"})},
        Rule{"TooManyCarriers", header(carriers(65)), error("KS0117", 2, 13, {"65", "64"})},
        Rule{"Extension", header(";;Carriers: 1\n;;X-Presser: on\n"), warning("KS0120", 3, 1, {"X-Presser"})},
        Rule{"AfterAGap", header(";;Carriers: 1\n\n;;Gauge: 7\n"), warning("KS0123", 4, 1, {"Gauge"})}),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    Operation, KnitoutRule,
    testing::Values(
        Rule{"Unknown", body("  purl + f1 1\n"), error("KS0107", 3, 3, {"purl"})},
        Rule{"CapitalLetters", body("Knit + f1 1\n"), error("KS0107", 3, 1, {"Knit"})},
        Rule{"FreeText", body("cast on here\n"), error("KS0107", 3, 1, {"cast"})},
        Rule{"NoDirection", body("knit f1 1\n"), error("KS0108", 3, 6, {"'f1'", "a direction, + or -"})},
        Rule{"NoNeedle", body("knit +\n"),
             error("KS0108", 3, 7, {"nothing", "a needle such as f5, b-3 or fs2"})},
        Rule{"NoBed", body("knit + 5 1\n"),
             error("KS0108", 3, 8, {"'5'", "a needle such as f5, b-3 or fs2"})},
        Rule{"NoIndex", body("drop fs\n"),
             error("KS0108", 3, 6, {"'fs'", "a needle such as f5, b-3 or fs2"})},
        Rule{"BrokenIndex", body("drop f1x\n"),
             error("KS0108", 3, 6, {"'f1x'", "a needle such as f5, b-3 or fs2"})},
        Rule{"FractionalIndex", body("drop f1.5\n"),
             error("KS0108", 3, 6, {"'f1.5'", "a needle such as f5, b-3 or fs2"})},
        Rule{"NoTarget", body("xfer\tf1\n"),
             error("KS0108", 3, 8, {"nothing", "a needle such as f5, b-3 or fs2"})},
        Rule{"TooManyWords", body("xfer f1 b1 b2\n"),
             error("KS0108", 3, 12, {"'b2'", "the end of the operation"})},
        Rule{"NoNumber", body("rack half\n"), error("KS0108", 3, 6, {"'half'", "a number"})},
        Rule{"Nan", body("rack nan\n"), error("KS0108", 3, 6, {"'nan'", "a number"})},
        Rule{"Infinity", body("rack -inf\n"), error("KS0108", 3, 6, {"'-inf'", "a number"})},
        Rule{"TwoSigns", body("rack +-1\n"), error("KS0108", 3, 6, {"'+-1'", "a number"})},
        Rule{"DecimalComma", body("rack 0,25\n"), error("KS0108", 3, 6, {"'0,25'", "a number"})},
        Rule{"NothingToBringIn", body("in\n"), warning("KS0108", 3, 3, {"nothing", "a carrier"})},
        Rule{"PauseWithText", body("pause change the cone ;x\n"),
             warning("KS0108", 3, 7, {"'change the cone'", "the end of the operation"})},
        Rule{"UnknownCarrier", body("tuck - b2 1 4\n"), error("KS0109", 3, 13, {"4"})},
        Rule{"CarrierTwice", body("tuck - b2 1 2 1\n"), error("KS0110", 3, 15, {"1"})},
        Rule{"UnknownExtension", body("pause\nx-speed-number 3\nx-speed-number 4\n"),
             warning("KS0111", 4, 1, {"x-speed-number"})},
        Rule{"TypographicRacking",
             body("rack \xE2\x88\x92"
                  "1\n"),
             error("KS0118", 3, 6)},
        Rule{"TypographicDirection", body("knit \xE2\x80\x93 f1 1\n"), error("KS0118", 3, 6)},
        Rule{"TypographicNeedle",
             body("drop f\xE2\x88\x92"
                  "1\n"),
             error("KS0118", 3, 7)},
        Rule{"TypographicName", body("x\xE2\x80\x91stitch-number 3\n"), error("KS0118", 3, 2)},
        Rule{"NeedleTooFar", body("drop b1000001\n"),
             error("KS0119", 3, 6, {"needle", "'b1000001'", "-1000000", "1000000"})},
        Rule{"NeedleBeyondAnyInteger", body("drop f-99999999999999999999\n"),
             error("KS0119", 3, 6, {"needle", "'f-99999999999999999999'", "-1000000", "1000000"})},
        Rule{"RackTooFar", body("rack 1000.5\n"),
             error("KS0119", 3, 6, {"racking", "'1000.5'", "-1000", "1000"})},
        Rule{"RackBeyondAnyNumber", body("rack 1e999\n"),
             error("KS0119", 3, 6, {"racking", "'1e999'", "-1000", "1000"})},
        Rule{"ExtensionFaultIsKept", body("x-stitch-number loose\n"),
             warning("KS0108", 3, 17, {"'loose'", "a number"})},
        Rule{"NegativeStitchNumber", body("x-stitch-number -1\n"),
             warning("KS0119", 3, 17, {"stitch number", "'-1'", "0", "1000"})},
        Rule{"NoColour", body("x-vis-color red 1\n"),
             warning("KS0108", 3, 13, {"'red'", "a colour such as #26c6f6"})}),
    nameOf);

} // namespace
} // namespace knittsim::formats::knitout
