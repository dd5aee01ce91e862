#include "core/formats/passes/settings.h"

#include "core/formats/text.h"

#include <cmath>
#include <optional>

namespace knittsim::formats::passes {

namespace {

constexpr double kMaxRoller = 100'000;

/// A table index: a number, or a letter for 10 and more.
std::optional<double> tableIndex(std::string_view text) {
    if (text.size() == 1 && text[0] >= 'A' && text[0] <= 'Z') {
        return 10 + (text[0] - 'A');
    }
    return parseNumber(text);
}

bool set(double& to, std::optional<double> number, double most) {
    if (!number || std::abs(*number) > most) {
        return false;
    }
    to = *number;
    return true;
}

} // namespace

bool Settings::setStitch(double number) {
    if (number < 0 || number > m_rules.maxStitchNumber || number != std::floor(number)) {
        return false;
    }
    m_stitch = static_cast<int>(number);
    return true;
}

bool Settings::isEndPass(std::string_view text) {
    return Tokens(text).next().text == "x-end-pass";
}

bool Settings::read(std::string_view text) {
    Tokens tokens(text);
    const std::string_view name = tokens.next().text;
    const std::string_view value = tokens.next().text;
    if (name == "x-speed-number") {
        const std::optional<double> speed = parseNumber(value);
        return speed && *speed >= 0 && *speed == std::floor(*speed) && set(m_speed, speed, m_rules.maxSpeed);
    }
    if (name == "x-presser-mode") {
        return readPresser(value);
    }
    if (name == "x-roller-advance") {
        return set(m_roller, parseNumber(value), kMaxRoller);
    }
    if (name == "x-add-roller-advance") {
        return set(m_addedRoller, parseNumber(value), kMaxRoller);
    }
    if (name == "x-xfer-stitch-number") {
        const std::optional<double> number = tableIndex(value);
        if (!number || *number < 0 || *number > m_rules.maxStitchNumber || *number != std::floor(*number)) {
            return false;
        }
        m_transferStitch = static_cast<int>(*number);
    }
    if (name == "x-xfer-style") {
        m_fourPasses = value == "four-pass";
        return m_fourPasses || value == "two-pass";
    }
    return true;
}

bool Settings::readPresser(std::string_view value) {
    if (value == "on") {
        m_presser = Presser::On;
    } else if (value == "auto") {
        m_presser = Presser::Auto;
    } else if (value == "off") {
        m_presser = Presser::Off;
    } else {
        return false;
    }
    return true;
}

Pass Settings::pass() const {
    Pass pass;
    pass.stitch = m_stitch;
    pass.speed = m_speed;
    return pass;
}

} // namespace knittsim::formats::passes
