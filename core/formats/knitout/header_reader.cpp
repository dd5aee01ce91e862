#include "core/formats/knitout/header_reader.h"

#include "core/formats/text.h"

#include <algorithm>
#include <array>
#include <utility>

namespace knittsim::formats::knitout {

namespace {

constexpr std::string_view kYarnPrefix = "Yarn-";
constexpr double kMaxGauge = 1000;
constexpr std::int64_t kMaxWidth = 1'000'000;

bool startsWith(std::string_view text, std::string_view prefix) {
    return text.substr(0, prefix.size()) == prefix;
}

/// The text before the first `separator`, which is taken from `text` together with it.
std::string_view takePart(std::string_view& text, char separator) {
    const std::size_t end = text.find(separator);
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return part;
}

} // namespace

std::optional<HeaderLine> splitHeader(std::string_view line) {
    const std::size_t colon = line.find(':');
    if (!startsWith(line, ";;") || colon == std::string_view::npos || colon == 2) {
        return std::nullopt;
    }
    const std::string_view name = line.substr(2, colon - 2);
    if (std::any_of(name.begin(), name.end(), isBlank)) {
        return std::nullopt;
    }
    const std::string_view value = trim(line.substr(colon + 1));
    const std::size_t column =
        value.empty() ? colon + 2 : static_cast<std::size_t>(value.data() - line.data()) + 1;
    return HeaderLine{name, value, static_cast<int>(column), value.empty() || isBlank(line[colon + 1])};
}

bool isKnownHeader(std::string_view name) {
    constexpr std::array<std::string_view, 5> kNames{"Carriers", "Machine", "Gauge", "Position", "Width"};
    return startsWith(name, kYarnPrefix) || startsWith(name, "X-") ||
           std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

void HeaderReader::read(const HeaderLine& line, int lineNumber) {
    if (!line.blankAfterColon) {
        m_problems.warn("KS0114", {lineNumber, line.valueColumn}, {shown(line.name)});
    }
    if (!m_seen.emplace(line.name).second) {
        m_problems.warn("KS0105", {lineNumber, 1}, {shown(line.name)});
        return;
    }
    const Spot spot{lineNumber, line.valueColumn};
    if (line.name == "Carriers") {
        readCarriers(line, spot);
    } else if (line.name == "Gauge") {
        readGauge(line, spot);
    } else if (line.name == "Width") {
        readWidth(line, spot);
    } else if (line.name == "Position") {
        readPosition(line, spot);
    } else if (line.name == "Machine") {
        m_header.machine = line.value;
    } else if (startsWith(line.name, kYarnPrefix)) {
        m_yarns.push_back({std::string(line.name), std::string(line.value), lineNumber});
    } else {
        m_problems.warn("KS0120", {lineNumber, 1}, {shown(line.name)});
        m_header.others.emplace_back(line.name, line.value);
    }
}

void HeaderReader::finish() {
    for (Yarn& yarn : std::exchange(m_yarns, {})) {
        const std::string carrier = yarn.header.substr(kYarnPrefix.size());
        const auto found = std::find_if(m_header.carriers.begin(), m_header.carriers.end(),
                                        [&](const machine::Carrier& c) { return c.name == carrier; });
        if (found != m_header.carriers.end()) {
            found->yarn = std::move(yarn.value);
            continue;
        }
        const int column = 1 + static_cast<int>(std::string_view(";;").size() + kYarnPrefix.size());
        m_problems.warn("KS0109", {yarn.line, column}, {shown(carrier)});
        m_header.others.emplace_back(std::move(yarn.header), std::move(yarn.value));
    }
}

void HeaderReader::readCarriers(const HeaderLine& line, Spot spot) {
    m_sawCarriers = true;
    Tokens rails(line.value);
    int number = 0;
    for (Token rail = rails.next(); !rail.text.empty(); rail = rails.next()) {
        if (!readRail(rail.text, number++, {spot.line, spot.column + rail.column - 1})) {
            m_header.carriers.clear();
            return;
        }
    }
    if (number == 0) {
        badValue("Carriers", spot, "nothing", "the names of the carriers, for example 1 2 3");
    } else if (m_header.carriers.size() > machine::kMaxCarriers) {
        m_problems.error("KS0117", spot,
                         {std::to_string(m_header.carriers.size()), std::to_string(machine::kMaxCarriers)});
        m_header.carriers.clear();
    }
}

bool HeaderReader::readRail(std::string_view rail, int number, Spot spot) {
    std::string_view rest = rail;
    const std::string_view left = takePart(rest, ';');
    if (rest.find(';') != std::string_view::npos || (left.empty() && rest.empty())) {
        badValue("Carriers", spot, quoted(rail), "a rail such as L1,L2;R1");
        return false;
    }
    const Spot right{spot.line, spot.column + static_cast<int>(rest.data() - rail.data())};
    return readSide(left, number, false, spot) && readSide(rest, number, true, right);
}

bool HeaderReader::readSide(std::string_view names, int rail, bool right, Spot spot) {
    const bool any = !names.empty();
    const char* begin = names.data();
    for (bool more = any; more;) {
        const Spot at{spot.line, spot.column + static_cast<int>(names.data() - begin)};
        more = names.find(',') != std::string_view::npos;
        const std::string name(takePart(names, ','));
        if (name.empty()) {
            badValue("Carriers", at, "an empty name", "a name between the commas");
            return false;
        }
        // Looking for twins costs a walk over all carriers, so it ends with the greatest allowed number.
        const auto& known = m_header.carriers;
        const bool twin = known.size() <= machine::kMaxCarriers &&
                          std::any_of(known.begin(), known.end(),
                                      [&](const machine::Carrier& c) { return c.name == name; });
        if (twin) {
            badValue("Carriers", at, quoted(name) + " twice", "every carrier once");
            return false;
        }
        m_header.carriers.push_back({name, rail, right, {}});
    }
    return true;
}

void HeaderReader::readGauge(const HeaderLine& line, Spot spot) {
    const std::optional<double> gauge = parseNumber(line.value);
    if (gauge && *gauge > 0 && *gauge <= kMaxGauge) {
        m_header.gauge = gauge;
    } else {
        badValue("Gauge", spot, quoted(line.value), "a number of needles per inch up to 1000");
    }
}

void HeaderReader::readWidth(const HeaderLine& line, Spot spot) {
    const std::optional<std::int64_t> width = parseInteger(line.value);
    if (width && *width > 0 && *width <= kMaxWidth) {
        m_header.width = static_cast<int>(*width);
    } else {
        badValue("Width", spot, quoted(line.value), "a whole number of needles from 1 to 1000000");
    }
}

void HeaderReader::readPosition(const HeaderLine& line, Spot spot) {
    constexpr std::array<std::string_view, 4> kPositions{"Left", "Center", "Right", "Keep"};
    if (std::find(kPositions.begin(), kPositions.end(), line.value) != kPositions.end()) {
        m_header.position = line.value;
    } else {
        badValue("Position", spot, quoted(line.value), "Left, Center, Right or Keep");
    }
}

void HeaderReader::badValue(std::string_view name, Spot spot, std::string found, std::string expected) {
    m_problems.error("KS0104", spot, {std::string(name), std::move(found), std::move(expected)});
}

} // namespace knittsim::formats::knitout
