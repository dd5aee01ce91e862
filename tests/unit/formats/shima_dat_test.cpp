#include "core/base/message_table.h"
#include "core/formats/knitout/reader.h"
#include "core/formats/knitout/writer.h"
#include "core/formats/shima_dat/layout.h"
#include "core/formats/shima_dat/raster.h"
#include "core/formats/shima_dat/reader.h"
#include "core/formats/shima_dat/writer.h"
#include "tests/support/random_program.h"
#include "tests/support/same_meaning.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace knittsim::formats::shima_dat {
namespace {

using testing::ElementsAre;

const std::string kHeader = ";!knitout-2\n;;Carriers: 1 2 3 4 5 6 7 8 9 10\n;;Position: Keep\n";

machine::Program program(const std::string& lines) {
    auto parsed = knitout::parse(kHeader + lines, "a.k");
    EXPECT_TRUE(parsed) << toLine(parsed.diagnostics().front());
    return parsed ? std::move(parsed).value() : machine::Program{};
}

std::string written(const std::string& lines) {
    const auto bytes = write(program(lines));
    EXPECT_TRUE(bytes) << toLine(bytes.diagnostics().front());
    return bytes ? bytes.value() : std::string();
}

Raster picture(const std::string& bytes) {
    Problems problems("a.dat", 1);
    return decode(bytes, problems);
}

/// Colours of the slots in the passes of a program, without the fixed rows.
std::vector<std::vector<int>> slots(const std::string& lines) {
    const Raster raster = picture(written(lines));
    std::vector<std::vector<int>> rows;
    for (int y = kRowsBelow + kFrameRows; y < raster.height - kRowsAbove - kFrameRows; ++y) {
        const auto row = raster.row(y).subspan(kMargin, static_cast<std::size_t>(raster.width - 2 * kMargin));
        rows.emplace_back(row.begin(), row.end());
    }
    return rows;
}

/// Value of an option line of the first pass; right-hand ones have negative numbers.
int option(const std::string& lines, int line, int pass = 0) {
    const Raster raster = picture(written(lines));
    const auto row = raster.row(kRowsBelow + kFrameRows + pass);
    const int column = line > 0 ? kMargin - kGap - 2 * line : raster.width - kMargin + kGap - 2 * line - 1;
    return row[static_cast<std::size_t>(column)];
}

std::string refusal(const std::string& lines) {
    const auto bytes = write(program(lines));
    return bytes ? std::string() : bytes.diagnostics().front().id;
}

/// The operations that come back, without the header.
std::string readBack(const std::string& lines) {
    const auto read = parse(written(lines), "a.dat");
    EXPECT_TRUE(read) << toLine(read.diagnostics().front());
    const std::string text = knitout::write(read.value());
    return text.substr(text.find("Keep\n") + 5);
}

TEST(DatRaster, CodesRunsOfOneRow) {
    Raster raster(600, 2);
    raster.pixels[3] = 7;
    raster.pixels[1199] = 9;
    const std::string bytes = encode(raster);
    // 3, 1, 255, 255, 86 and 255, 255, 89, 1 pixels
    EXPECT_EQ(bytes.size(), 0x600 + 2 * 9u);
    Problems problems("a.dat", 1);
    const Raster again = decode(bytes, problems);
    EXPECT_EQ(problems.errorCount(), 0);
    EXPECT_EQ(again.pixels, raster.pixels);
}

TEST(DatWriter, PutsOneDirectionIntoOnePass) {
    EXPECT_THAT(
        slots("in 1\nknit + f1 1\ntuck + b2 1\nmiss + f3 1\nknit - f3 1\nout 1\n"),
        ElementsAre(ElementsAre(51, 12, 216), ElementsAre(0, kStopMark, 51), ElementsAre(0, kStopMark, 16)));
}

TEST(DatWriter, JoinsBothBedsWhereTheyInterleave) {
    const std::string both = "in 1\nknit + f1 1\nknit + b1 1\nknit + f2 1\ntuck + b2 1\nout 1\n";
    EXPECT_THAT(slots("rack 0.25\n" + both).front(), ElementsAre(3, 41));
    EXPECT_THAT(slots(both),
                ElementsAre(ElementsAre(51, kStopMark), ElementsAre(16, kStopMark), ElementsAre(52, 51),
                            ElementsAre(kStopMark, 16), ElementsAre(kStopMark, 12)));
    EXPECT_THAT(slots("rack 0.25\nin 1\nknit - b1 1\nknit - f1 1\nout 1\n").front(), ElementsAre(3));
    EXPECT_EQ(option("rack 0.25\n" + both, left::kInterleaved), 1);
}

TEST(DatWriter, WritesRackingsOfBothSides) {
    for (const auto& [rack, amount, side, quarter] :
         {std::tuple{"0", 0, 10, 0}, std::tuple{"1", 0, 11, 0}, std::tuple{"3.25", 2, 11, 1},
          std::tuple{"-2", 2, 10, 0}, std::tuple{"-0.75", 1, 10, 1}}) {
        const std::string lines = std::string("rack ") + rack + "\nin 1\nknit + f9 1\nout 1\n";
        EXPECT_EQ(option(lines, left::kRacking), amount) << rack;
        EXPECT_EQ(option(lines, left::kRackingSide), side) << rack;
        EXPECT_EQ(option(lines, left::kInterleaved), quarter) << rack;
    }
}

TEST(DatWriter, NamesCarriersGripperAndHook) {
    const std::string lines = "inhook 3\nknit - f2 3\nreleasehook 3\nknit + f2 3\nouthook 3\n";
    EXPECT_EQ(option(lines, -right::kCarrier), 3);
    EXPECT_EQ(option(lines, -right::kGripper), 3);
    EXPECT_EQ(option(lines, -right::kHook), 10);
    EXPECT_EQ(option(lines, -right::kHook, 2), 90); // behind a pass that turns the carriage
    EXPECT_EQ(option(lines, -right::kGripper, 3), 103);
    EXPECT_EQ(option(lines, -right::kHook, 3), 20);
    EXPECT_EQ(option("in 4 7\nknit + f1 4 7\nout 4 7\n", -right::kCarrier), 47);
    EXPECT_EQ(option("in 4 10\nknit + f1 4 10\nout 4 10\n", -right::kCarrier), 40);
}

TEST(DatWriter, CarriesAYarnOutOfTheWay) {
    // Carrier 1 rests right of needle 3, on the way to needle 5, so it is carried to the left.
    EXPECT_THAT(slots("in 1\nknit + f1 1\nknit + f3 1\nin 2\nknit + f5 2\nout 1\nout 2\n"),
                ElementsAre(ElementsAre(51, 0, 51, kStopMark, 0), ElementsAre(0, kStopMark, 16, kStopMark, 0),
                            ElementsAre(0, 0, 0, kStopMark, 51), ElementsAre(0, kStopMark, 16, kStopMark, 0),
                            ElementsAre(0, 0, 0, kStopMark, 16), ElementsAre(0, 0, 0, kStopMark, 16)));
}

TEST(DatWriter, RefusesWhatTheFormatCannotSay) {
    EXPECT_EQ(refusal("in 1\nknit + f1 1\n"), "KS0210");
    EXPECT_EQ(refusal("knit + f1 1\n"), "KS0201");
    EXPECT_EQ(refusal("rack 9\nin 1\nknit + f1 1\nout 1\n"), "KS0139");
    EXPECT_EQ(refusal("rack 0.5\nin 1\nknit + f1 1\nout 1\n"), "KS0139");
    EXPECT_EQ(refusal("in 1 2 3\nknit + f1 1 2 3\nout 1 2 3\n"), "KS0139");
    EXPECT_EQ(refusal("in 10 2\nknit + f1 10 2\nout 10 2\n"), "KS0139");
    EXPECT_EQ(refusal("in 1\nknit + f1 1\nknit + f541 1\nout 1\n"), "KS0139");
    EXPECT_EQ(refusal("in 1\nknit + f0 1\nout 1\n"), "KS0139");
    EXPECT_EQ(refusal("stitch 10 20\nin 1\nknit + f1 1\nout 1\n"), "KS0139");
    EXPECT_EQ(refusal("x-speed-number 16\nin 1\nknit + f1 1\nout 1\n"), "KS0139");
    EXPECT_EQ(refusal("in 1\nout 1\n"), "KS0139");
    EXPECT_EQ(refusal("pause\n"), "KS0139");
    EXPECT_EQ(refusal("in 1 2\nknit + f1 1\nout 1\nout 2\n"), "KS0139");
}

TEST(DatReader, GivesBackWhatWasWritten) {
    const std::string lines =
        "x-speed-number 3\nx-stitch-number 12\nin 2\nknit + f1 2\ntuck + f2 2\nmiss + f3 2\n"
        "knit - f3 2\nsplit + f3 b3 2\nrack 2\nxfer b3 f5\nrack 0\ndrop f1\npause\namiss f2\n"
        "rack 0.25\nknit + f5 2\nknit + b5 2\nout 2\n";
    EXPECT_EQ(readBack(lines), lines);
    const auto read = parse(written(lines), "a.dat");
    EXPECT_EQ(test::differenceInMeaning(program(lines), read.value()), "");
    EXPECT_EQ(read.value().operations.front().line, 9); // five empty and three fixed rows below
}

TEST(DatReader, ReadsSplitsThatSlidersGiveBack) {
    const std::string lines = "in 1\nknit + f5 1\nknit + f6 1\nsplit - f6 bs6 1\nsplit - f5 bs5 1\nrack 2\n"
                              "xfer bs5 f7\nxfer bs6 f8\nrack 0\nout 1\n";
    EXPECT_THAT(slots(lines)[1], ElementsAre(127, 127));
    const auto read = parse(written(lines), "a.dat");
    ASSERT_TRUE(read) << toLine(read.diagnostics().front());
    EXPECT_EQ(test::differenceInMeaning(program(lines), read.value()), "");
}

TEST(DatReader, ReadsSliderTransfers) {
    const std::string lines = "in 1\nknit + f5 1\nout 1\nxfer f5 bs5\nrack 1\nxfer bs5 f6\nxfer f6 b5\n";
    const auto read = parse(written(lines), "a.dat");
    ASSERT_TRUE(read) << toLine(read.diagnostics().front());
    EXPECT_EQ(test::differenceInMeaning(program(lines), read.value()), "");
}

/// What happens to a picture with one changed pixel.
std::string foundAfter(int row, int column, int colour) {
    Raster raster = picture(written("in 1\nknit + f1 1\nknit + f2 1\nout 1\n"));
    raster.row(kRowsBelow + kFrameRows + row)[static_cast<std::size_t>(column)] =
        static_cast<std::uint8_t>(colour);
    const auto result = parse(encode(raster), "a.dat");
    return result.diagnostics().empty() ? std::string() : result.diagnostics().front().id;
}

TEST(DatReader, SaysWhatItDoesNotKnow) {
    const int rightValue = kMargin + 2 + kGap; // column of R1's value is one further
    EXPECT_EQ(foundAfter(0, kMargin, 51), "");
    EXPECT_EQ(foundAfter(0, kMargin, 77), "KS0134");
    EXPECT_EQ(foundAfter(0, kMargin - kGap - 2 * 8, 5), "KS0135");
    EXPECT_EQ(foundAfter(0, kMargin - kGap - 2 * left::kSliders, 5), "KS0136");
    EXPECT_EQ(foundAfter(0, rightValue + 2 * right::kCarrier - 1, 111), "KS0136");
    EXPECT_EQ(foundAfter(0, rightValue + 2 * right::kGripper - 1, 99), "KS0136");
    EXPECT_EQ(foundAfter(0, kMargin - kGap - 2 * 4 + 1, 9), "KS0133"); // a mark in the middle row
    EXPECT_EQ(foundAfter(-1, kMargin, 0), "KS0137");
}

TEST(DatReader, ChecksSizesBeforeItTakesMemory) {
    std::string bytes = written("in 1\nknit + f1 1\nout 1\n");
    const auto id = [](const std::string& text) { return parse(text, "a.dat").diagnostics().front().id; };
    EXPECT_EQ(id(bytes.substr(0, bytes.size() - 2)), "KS0131");
    EXPECT_EQ(id(bytes + "\x01\x01"), "KS0131");
    std::string huge = bytes;
    huge.replace(4, 4, "\xFF\xFF\xFF\xFF");
    EXPECT_EQ(id(huge), "KS0131");
    std::string turned = bytes;
    turned.replace(0, 2, "\xFF\xFF");
    EXPECT_EQ(id(turned), "KS0130");
    std::string crossing = bytes;
    crossing[0x601] = '\x7F';
    EXPECT_EQ(id(crossing), "KS0132");
}

TEST(DatRoundTrip, KeepsTheMeaningOfRandomPrograms) {
    int written = 0;
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
        test::RandomProgramOptions options;
        options.seed = seed;
        options.firstNeedle = 100;
        options.quarterRacks = false;
        options.carriers = seed % 2 == 0 ? 1 : 3;
        machine::Program random = test::randomProgram(options);
        random.header.position = "Keep";
        const auto bytes = write(random);
        if (!bytes) {
            // The only thing that these programs do and the format cannot.
            EXPECT_THAT(toLine(bytes.diagnostics().front()),
                        testing::AnyOf(testing::HasSubstr("cannot come in with a split"),
                                       testing::HasSubstr("first stitch together")))
                << seed;
            continue;
        }
        ++written;
        const auto read = parse(bytes.value(), "a.dat");
        ASSERT_TRUE(read) << toLine(read.diagnostics().front());
        EXPECT_EQ(test::differenceInMeaning(random, read.value()), "") << "seed " << seed;
    }
    EXPECT_GT(written, 30);
}

} // namespace
} // namespace knittsim::formats::shima_dat
