#include "core/base/message_table.h"
#include "core/formats/kcode/reader.h"
#include "core/formats/kcode/writer.h"
#include "core/formats/knitout/reader.h"
#include "core/formats/knitout/writer.h"
#include "core/formats/shima_dat/reader.h"
#include "core/formats/shima_dat/writer.h"
#include "core/formats/sintral/reader.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace knittsim::formats {
namespace {

struct Reader {
    const char* name;
    std::function<Result<machine::Program>(std::string_view)> read;
    std::function<std::string()> sample; ///< a file that opens
};

void PrintTo(const Reader& reader, std::ostream* out) {
    *out << reader.name;
}

machine::Program smallProgram() {
    return knitout::parse(";!knitout-2\n;;Carriers: 1 2\nin 1\nknit + f1 1\nknit + f2 1\ntuck - f2 1\nxfer "
                          "f1 b1\nout 1\n",
                          "a.k")
        .value();
}

const std::string kJacquard = "1002 .A2(A.)$\n1003 $A\n";

std::vector<Reader> readers() {
    return {{"knitout", [](std::string_view text) { return knitout::parse(text, "a.k"); },
             [] { return knitout::write(smallProgram()); }},
            {"dat", [](std::string_view bytes) { return shima_dat::parse(bytes, "a.dat"); },
             [] { return shima_dat::write(smallProgram()).value(); }},
            {"kcode", [](std::string_view text) { return kcode::parse(text, "a.kc"); },
             [] { return kcode::write(smallProgram(), "a.kc").value(); }},
            {"sintral",
             [](std::string_view text) {
                 return sintral::parse({text, "a.sin"}, {kJacquard, "a.jac"});
             },
             [] {
                 return std::string(
                     "START\n10 SEN=1-6 NP5=11 #5=2\n20 REP*3\n30 <> S:<0+>A(5)-R; Y:1/2; S1 VR1\n"
                     "40 REPEND\nIF #5=2 GOSUB 60-60\nEND\n60 S:<1+>R-0;\n");
             }},
            {"jacquard",
             [](std::string_view text) {
                 return sintral::parse({"<< S:A-0; Y:1; S1\n", "a.sin"}, {text, "a.jac"});
             },
             [] { return kJacquard; }}};
}

class BadInput : public testing::TestWithParam<Reader> {
protected:
    /// Opens, or says why not: every finding is in the table, has a place and is short, and there are few.
    bool opens(std::string_view bytes) {
        const auto result = GetParam().read(bytes);
        EXPECT_NE(result.hasValue(), hasErrors(result.diagnostics()));
        EXPECT_LE(result.diagnostics().size(), 200u);
        for (const Diagnostic& found : result.diagnostics()) {
            EXPECT_NE(findMessage(found.id), nullptr) << found.id;
            EXPECT_GE(found.place.line, 1) << found.id;
            EXPECT_GE(found.place.column, 1) << found.id;
            EXPECT_LT(toLine(found).size(), 500u) << found.id;
        }
        return result.hasValue();
    }

    /// The only finding, or how many there are.
    std::string onlyFinding(std::string_view bytes) {
        const auto result = GetParam().read(bytes);
        const auto& list = result.diagnostics();
        return list.size() == 1 ? list[0].id : std::to_string(list.size()) + " findings";
    }
};

TEST_P(BadInput, EveryBeginningOfAFileIsSafe) {
    const std::string whole = GetParam().sample();
    ASSERT_TRUE(opens(whole)) << toLine(GetParam().read(whole).diagnostics().front());
    const std::size_t step = whole.size() / 500 + 1;
    for (std::size_t size = 0; size < whole.size(); size += step) {
        opens(std::string_view(whole).substr(0, size));
    }
}

TEST_P(BadInput, ChangedBytesAreSafe) {
    const std::string whole = GetParam().sample();
    std::mt19937 random(7);
    for (int i = 0; i < 2000; ++i) {
        std::string bytes = whole;
        for (unsigned n = random() % 4; n <= 3; ++n) {
            bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
        }
        opens(bytes);
    }
}

TEST_P(BadInput, NoiseIsRefused) {
    std::mt19937 random(11);
    for (const std::size_t size : {1u, 100u, 5'000u, 2'000'000u}) {
        std::string noise(size, '\0');
        for (char& c : noise) {
            c = static_cast<char>(random() % 256);
        }
        EXPECT_FALSE(opens(noise)) << size;
    }
}

TEST_P(BadInput, AHundredMegabytesOfOneLineGiveOneMessage) {
    const std::string line(std::size_t{100} << 20, '9');
    const std::string id = onlyFinding(line);
    // The first line of knitout is missed besides; a picture is known by its header.
    EXPECT_EQ(id, GetParam().name == std::string("knitout") ? "2 findings"
                  : GetParam().name == std::string("dat")   ? "KS0130"
                                                            : "KS0116");
    EXPECT_FALSE(opens(line));
}

TEST_P(BadInput, OtherTextIsRefused) {
    std::string text;
    for (int i = 0; i < 1000; ++i) {
        text += "It was a bright cold day in April, and the needles were striking thirteen.\n";
    }
    EXPECT_FALSE(opens(text));
}

TEST_P(BadInput, NulBytesGiveOneMessage) {
    const std::string nul(std::size_t{10} << 20, '\0');
    EXPECT_FALSE(opens(nul));
    std::string lines;
    for (int i = 0; i < 100'000; ++i) {
        lines += std::string("\0\n", 2);
    }
    const std::string id = onlyFinding(lines);
    EXPECT_EQ(id, GetParam().name == std::string("knitout") ? "2 findings"
                  : GetParam().name == std::string("dat")   ? "KS0130"
                                                            : "KS0122");
}

TEST_P(BadInput, OtherEncodingsAreRefused) {
    const std::string text = GetParam().sample();
    std::string wide = "\xFF\xFE";
    for (const char c : text) {
        wide += c;
        wide += '\0';
    }
    EXPECT_FALSE(opens(wide));
}

TEST_P(BadInput, HugeNumbersAreSafe) {
    const std::string text = GetParam().sample();
    for (const char* number :
         {"99999999999999999999", "-99999999999999999999", "1e999", "2147483648", "4294967296"}) {
        for (std::size_t at = 0; at < text.size(); ++at) {
            if (std::isdigit(static_cast<unsigned char>(text[at])) != 0 &&
                (at < 300 || at + 300 > text.size())) {
                std::string bytes = text;
                bytes.replace(at, 1, number);
                opens(bytes);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, BadInput, testing::ValuesIn(readers()),
                         [](const auto& info) { return info.param.name; });

} // namespace
} // namespace knittsim::formats
