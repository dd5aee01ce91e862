#include "core/formats/kcode/action.h"

#include "core/formats/kcode/layout.h"
#include "core/formats/text.h"

#include <array>
#include <cmath>
#include <utility>

namespace knittsim::formats::kcode {

namespace {

constexpr double kMaxNumber = 1'000'000;

std::optional<BedWork> bedWork(std::string_view name) {
    constexpr std::array<std::pair<std::string_view, BedWork>, 5> kNames{{{"Kn", BedWork::Knit},
                                                                          {"Tu", BedWork::Tuck},
                                                                          {"Tr", BedWork::Give},
                                                                          {"Rl", BedWork::TakeLeft},
                                                                          {"Rr", BedWork::TakeRight}}};
    for (const auto& [known, work] : kNames) {
        if (known == name) {
            return work;
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<Action> parseAction(std::string_view line, int lineNumber, Problems& problems) {
    const auto wrong = [&](const Token& token, const char* expected) {
        problems.error("KS0108", {lineNumber, token.column}, {quoted(token.text), expected});
        return std::nullopt;
    };
    Tokens tokens(line);
    Action action;
    action.direction = tokens.next().text[0] == '>' ? machine::Direction::Right : machine::Direction::Left;
    const Token type = tokens.next();
    const std::size_t dash = type.text.find('-');
    const auto front = bedWork(type.text.substr(0, dash));
    const auto rear = dash == std::string_view::npos ? std::nullopt : bedWork(type.text.substr(dash + 1));
    const bool stitches = front && rear && *front <= BedWork::Tuck && *rear <= BedWork::Tuck;
    const bool moves =
        front && rear &&
        ((*front == BedWork::Give && takes(*rear)) || (takes(*front) && *rear == BedWork::Give));
    if (!stitches && !moves) {
        return wrong(type, "a type such as Kn-Kn, Kn-Tu, Tr-Rr or Rl-Tr");
    }
    action.front = *front;
    action.rear = *rear;
    const Token carrier = tokens.next();
    const auto number = parseInteger(carrier.text);
    if (!number || *number < 0 || *number > kCarriers) {
        return wrong(carrier, "a carrier from 0 to 6");
    }
    action.carrier = static_cast<int>(*number);
    const std::array<double*, 2> values{&action.speed, &action.roller};
    // Editors write one more number, which is not known.
    for (std::size_t i = 0; i < 3 && (i < 2 || !tokens.peek().text.empty()); ++i) {
        const Token token = tokens.next();
        const auto value = parseNumber(token.text);
        if (!value || std::abs(*value) > kMaxNumber) {
            return wrong(token, i == 0 ? "a speed" : "a take-down");
        }
        if (i < 2) {
            *values[i] = *value;
        }
    }
    if (!tokens.peek().text.empty()) {
        return wrong(tokens.peek(), "the end of the line");
    }
    return action;
}

} // namespace knittsim::formats::kcode
