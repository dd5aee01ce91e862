#include "core/base/message_table.h"
#include "core/formats/kcode/reader.h"
#include "core/formats/kcode/writer.h"
#include "core/formats/knitout/reader.h"
#include "core/formats/knitout/writer.h"
#include "tests/support/random_program.h"
#include "tests/support/same_meaning.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace knittsim::formats::kcode {
namespace {

using testing::HasSubstr;

const std::string kHeader = ";!knitout-2\n;;Carriers: 1 2 3 4 5 6\n;;Position: Keep\n";

machine::Program program(const std::string& lines) {
    auto parsed = knitout::parse(kHeader + lines, "a.k");
    EXPECT_TRUE(parsed) << toLine(parsed.diagnostics().front());
    return parsed ? std::move(parsed).value() : machine::Program{};
}

std::string written(const std::string& lines) {
    const auto text = write(program(lines), "a.kc");
    EXPECT_TRUE(text) << toLine(text.diagnostics().front());
    return text ? text.value() : std::string();
}

std::string refusal(const std::string& lines) {
    const auto text = write(program(lines), "a.kc");
    return text ? std::string() : text.diagnostics().front().id;
}

/// A needle line with the given first needles, the rest at rest, 20 needles in all.
std::string needles(const std::string& first) {
    return std::string(15, '.') + first + std::string(20 - first.size(), '_') + std::string(15, '.');
}

std::string sizes(char size = '5') {
    return std::string(50, size);
}

std::string pass(const std::string& front, const std::string& rear, const std::string& action,
                 char size = '5') {
    return "FRNT:" + needles(front) + "\nSTIF:" + sizes(size) + "\nREAR:" + needles(rear) +
           "\nSTIR:" + sizes(size) + '\n' + action + '\n';
}

/// The operations without the header.
std::string readBack(const std::string& text) {
    const auto read = parse(text, "a.kc");
    EXPECT_TRUE(read) << toLine(read.diagnostics().front());
    if (!read) {
        return {};
    }
    const std::string knitout = knitout::write(read.value());
    return knitout.substr(knitout.find("Width: 252\n") + 11);
}

/// The first finding as "rule line:column".
std::string found(const std::string& text) {
    const auto result = parse(text, "a.kc");
    if (result.diagnostics().empty()) {
        return {};
    }
    const Diagnostic& first = result.diagnostics().front();
    return first.id + ' ' + std::to_string(first.place.line) + ':' + std::to_string(first.place.column);
}

TEST(KcodeReader, ReadsStitchesInTheDirectionOfThePass) {
    EXPECT_EQ(readBack("HOME\nRACK:0\n" + pass("-_-", "_-", "<< Kn-Tu 3 100 100") + "RACK:0.5\n" +
                       pass("--", "--", ">> Kn-Kn 3 100 100")),
              "in 3\nx-stitch-number 5\nknit - f3 3\ntuck - b2 3\nknit - f1 3\nrack 0.5\n"
              "knit + f1 3\nknit + b1 3\nknit + f2 3\nknit + b2 3\nout 3\n");
}

TEST(KcodeReader, TakesPassesWithoutYarnAsDropAndMiss) {
    EXPECT_EQ(readBack(pass("-", "_-", ">> Kn-Kn 0 100 100") + pass("-", "", "<< Tu-Tu 0 100 100")),
              "drop f1\ndrop b2\namiss f1\n");
}

TEST(KcodeReader, ReadsTransfersAndSplits) {
    EXPECT_EQ(readBack("RACK:2\n" + pass("__--", "--", "<< Tr-Rl 0 100 0")),
              "rack 2\nxfer f4 b2\nxfer f3 b1\n");
    EXPECT_EQ(readBack("RACK:-1\n" + pass("-", "_-", ">> Rr-Tr 0 100 0")), "rack -1\nxfer b2 f1\n");
    // A needle that nothing receives from knits.
    EXPECT_EQ(readBack(pass("---", "_-", ">> Tr-Rr 1 100 0", 'A')),
              "in 1\nx-stitch-number 10\nknit + f1 1\nsplit + f2 b2 1\nknit + f3 1\nout 1\n");
    EXPECT_EQ(found("RACK:0.5\n" + pass("-", "-", ">> Tr-Rr 0 100 0")), "KS0146 6:1");
}

TEST(KcodeReader, TakesCarriersOutWhereTheCommentSaysSo) {
    EXPECT_EQ(readBack(pass("-", "", ">> Kn-Kn 1 100 100") + "// x; carrier out\n" +
                       pass("-", "", "<< Kn-Kn 1 100 100") + pass("-", "", ">> Kn-Kn 1 100 100")),
              "in 1\nx-stitch-number 5\nknit + f1 1\nknit - f1 1\nout 1\nin 1\nknit + f1 1\nout 1\n");
}

TEST(KcodeReader, TakesStopsAway) {
    const std::string stops =
        ".../..2.........." + std::string("-_2\\") + std::string(18, '_') + std::string(15, '.');
    EXPECT_EQ(readBack("FRNT:" + stops + "\nSTIF:" + sizes() + "\nREAR:" + needles("") + "\nSTIR:" + sizes() +
                       "\n>> Kn-Kn 2 300 50 7\n"),
              "in 2\nx-speed-number 300\nx-roller-advance 50\nx-stitch-number 5\nknit + f1 2\nout 2\n");
}

TEST(KcodeReader, TakesOtherLinesBetweenPassesAsTexts) {
    const auto result = parse("HOME\nchange the yarn\n" + pass("-", "", ">> Kn-Kn 1 100 100"), "a.kc");
    ASSERT_EQ(result.diagnostics().size(), 1u);
    EXPECT_EQ(result.diagnostics()[0].id, "KS0142");
    ASSERT_TRUE(result);
    EXPECT_THAT(knitout::write(result.value()), HasSubstr("pause change the yarn\n"));
}

TEST(KcodeReader, SaysWhatIsWrong) {
    const std::string good = pass("-", "", ">> Kn-Kn 1 100 100");
    EXPECT_EQ(found("HOME\n"), "KS0140 1:1");
    EXPECT_EQ(found(""), "KS0140 1:1");
    EXPECT_EQ(found(good + "FRNT:" + needles("-") + "\n"), "KS0141 6:1");
    EXPECT_EQ(found("STIF:" + sizes() + "\n"), "KS0141 1:1");
    EXPECT_EQ(found("FRNT:" + needles("-") + "\nFRNT:" + needles("-") + "\n"), "KS0141 2:1");
    EXPECT_EQ(found("FRNT:" + needles("-x") + "\n"), "KS0143 1:22");
    EXPECT_EQ(found("FRNT:" + std::string(14, '.') + "--" + std::string(15, '.') + "\n"), "KS0143 1:20");
    EXPECT_EQ(found("FRNT:" + needles("-") + ".\n"), "KS0143 1:56");
    EXPECT_EQ(found("FRNT:" + needles("-") + "\nSTIF:55a\n"), "KS0144 2:8");
    EXPECT_EQ(found("FRNT:" + needles("-") + "\nSTIF:555\n"), "KS0145 2:1");
    EXPECT_EQ(found(pass("-", "", ">> Kn-Rr 1 100 100")), "KS0108 5:4");
    EXPECT_EQ(found(pass("-", "", ">> Kn-Kn 7 100 100")), "KS0108 5:10");
    EXPECT_EQ(found(pass("-", "", ">> Kn-Kn 1 100")), "KS0108 5:15");
    EXPECT_EQ(found(pass("-", "", ">> Kn-Kn 1 1e99 1")), "KS0108 5:12");
    EXPECT_EQ(found("RACK:x\n" + good), "KS0108 1:6");
    EXPECT_EQ(found("RACK:1e9\n" + good), "KS0119 1:6");
    EXPECT_EQ(found(good), "");
}

TEST(KcodeWriter, RefusesWhatTheMachineCannotDo) {
    EXPECT_EQ(refusal("in 1\nknit + f1 1\n"), "KS0210");
    EXPECT_EQ(refusal("inhook 1\nknit + f1 1\nreleasehook 1\nouthook 1\n"), "KS0149");
    EXPECT_EQ(refusal("in 1 2\nknit + f1 1 2\nout 1 2\n"), "KS0149");
    EXPECT_EQ(refusal("in 1\nknit + f253 1\nout 1\n"), "KS0149");
    EXPECT_EQ(refusal("in 1\nknit + f0 1\nout 1\n"), "KS0149");
    EXPECT_EQ(refusal("x-stitch-number 36\nin 1\nknit + f1 1\nout 1\n"), "KS0149");
    EXPECT_EQ(refusal("in 1\nknit + f1 1\nxfer f1 bs1\nout 1\n"), "KS0149");
    EXPECT_EQ(refusal("pause\nin 1\nknit + f1 1\nout 1\n"), "KS0149");
    EXPECT_EQ(refusal("x-carrier-spacing 1.5\nin 1\nknit + f1 1\nout 1\n"), "KS0149");
    EXPECT_EQ(refusal("pause RACK:3\nin 1\nknit + f1 1\nout 1\n"), "KS0149");
    EXPECT_EQ(refusal("pause change the yarn\nin 1\nknit + f1 1\nout 1\n"), "");
}

TEST(KcodeWriter, KnitsAndTucksOfOneBedAreTwoPasses) {
    const std::string text = written("in 1\nknit + f1 1\ntuck + f2 1\nout 1\n");
    EXPECT_THAT(text, HasSubstr(">> Kn-Kn 1 100 100"));
    EXPECT_THAT(text, HasSubstr(">> Tu-Tu 1 100 100"));
    EXPECT_THAT(written("rack 0.5\nin 1\nknit + f1 1\ntuck + b1 1\nout 1\n"),
                HasSubstr(">> Kn-Tu 1 100 100"));
}

TEST(KcodeWriter, StopsCarriersApart) {
    const std::string text = written("in 1\nknit + f1 1\nin 2\nknit + f1 2\nout 1\nout 2\n");
    // Carrier 1 stops two needles behind needle 1, carrier 2 two further.
    EXPECT_THAT(text, HasSubstr("-__1\\_"));
    EXPECT_THAT(text, HasSubstr("-____2\\_"));
    EXPECT_THAT(written("x-carrier-stopping-distance 4\nin 1\nknit + f1 1\nout 1\n"), HasSubstr("-____1\\_"));
}

TEST(KcodeRoundTrip, KeepsTheMeaningOfRandomPrograms) {
    for (std::uint32_t seed = 1; seed <= 40; ++seed) {
        test::RandomProgramOptions options;
        options.seed = seed;
        options.firstNeedle = 100;
        options.carriers = 1;
        options.extensions = false;
        options.quarterRacks = false;
        machine::Program random = test::randomProgram(options);
        random.header.position = "Keep";
        const auto text = write(random, "a.kc");
        ASSERT_TRUE(text) << toLine(text.diagnostics().front());
        const auto read = parse(text.value(), "a.kc");
        ASSERT_TRUE(read) << toLine(read.diagnostics().front());
        EXPECT_EQ(test::differenceInMeaning(random, read.value()), "") << "seed " << seed;
    }
}

} // namespace
} // namespace knittsim::formats::kcode
