#include "core/pattern/cell_letters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace knittsim::pattern {

using nlohmann::json;

namespace {

struct Letter {
    Stitch stitch;
    char letter;
};
constexpr std::array kLetters{
    Letter{Stitch::Knit, 'k'},     Letter{Stitch::Purl, 'p'},     Letter{Stitch::Both, 'b'},
    Letter{Stitch::Tuck, 't'},     Letter{Stitch::Miss, 'm'},     Letter{Stitch::Rest, 'r'},
    Letter{Stitch::Empty, '.'},    Letter{Stitch::KnitTuck, 'f'}, Letter{Stitch::TuckKnit, 'g'},
    Letter{Stitch::TuckBoth, 'u'}, Letter{Stitch::RearTuck, 'q'}, Letter{Stitch::RearMiss, 'n'},
    Letter{Stitch::Drop, 'd'}};

char letterOf(Stitch stitch) {
    return std::ranges::find(kLetters, stitch, &Letter::stitch)->letter;
}

/// Of what stands in a file; kMaxChartYarns for anything else.
std::size_t yarnOf(char digit) {
    return digit >= '0' && digit <= '9'   ? static_cast<std::size_t>(digit - '0')
           : digit >= 'a' && digit <= 'z' ? static_cast<std::size_t>(digit - 'a') + 10
                                          : kMaxChartYarns;
}

} // namespace

char yarnDigit(std::size_t yarn) {
    return static_cast<char>(yarn < 10 ? '0' + yarn : 'a' + (yarn - 10));
}

std::string stitchLetters(std::span<const Cell> cells) {
    std::string text;
    for (const Cell& cell : cells) {
        text += letterOf(cell.stitch);
    }
    return text;
}

std::string yarnDigits(std::span<const Cell> cells) {
    std::string text;
    for (const Cell& cell : cells) {
        text += yarnDigit(cell.yarn);
    }
    return text.find_first_not_of(text[0]) == std::string::npos ? text.substr(0, 1) : text;
}

bool readCells(JsonReader& reader, std::span<Cell> cells) {
    const std::string stitches = reader.text("stitches");
    std::string yarns = reader.text("yarns");
    if (yarns.size() == 1) {
        yarns.assign(cells.size(), yarns[0]);
    }
    const std::string expected = fmt::format("{} letters", cells.size());
    for (const auto& [key, text] : {std::pair{"stitches", &stitches}, {"yarns", &yarns}}) {
        if (text->size() != cells.size()) {
            reader.report(key, fmt::format("a text of {} letters", text->size()), expected);
            return false;
        }
    }
    for (std::size_t at = 0; at < cells.size(); ++at) {
        const auto letter = std::ranges::find(kLetters, stitches[at], &Letter::letter);
        const std::size_t yarn = yarnOf(yarns[at]);
        if (letter == kLetters.end() || yarn == kMaxChartYarns) {
            reader.report(letter == kLetters.end() ? "stitches" : "yarns",
                          fmt::format("another letter at wale {}", at),
                          letter == kLetters.end() ? "one of kpbtmrfguqnd." : "0 to 9 or a to z");
            return false;
        }
        cells[at] = {letter->stitch, static_cast<std::uint8_t>(yarn)};
    }
    return true;
}

std::string movesText(const std::vector<LoopMove>& moves) {
    std::string text = "[";
    for (const LoopMove& move : moves) {
        text += fmt::format("{}[{}, {}]", text.size() > 1 ? ", " : "", move.from, move.to);
    }
    return text + ']';
}

std::vector<LoopMove> readMoves(JsonReader& reader) {
    std::vector<LoopMove> moves;
    if (!reader.has("moves")) {
        return moves;
    }
    for (const json& move : reader.array("moves", 0, kMaxWales)) {
        if (!move.is_array() || move.size() != 2 || !move[0].is_number_integer() ||
            !move[1].is_number_integer()) {
            reader.report("moves", move.dump(-1, ' ', true, json::error_handler_t::replace).substr(0, 40),
                          "a pair of wales");
            return {};
        }
        const auto wale = [](const json& v) {
            return static_cast<int>(std::clamp<std::int64_t>(v.get<std::int64_t>(), -1, kMaxWales));
        };
        moves.push_back({wale(move[0]), wale(move[1])});
    }
    return moves;
}

} // namespace knittsim::pattern
