#include "core/machine/carrier_yarns.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <optional>

namespace knittsim::machine {

namespace {

using yarn::Colour;

constexpr std::array<Colour, 8> kCalmColours{{{222, 214, 196},
                                              {62, 104, 142},
                                              {186, 84, 66},
                                              {106, 138, 92},
                                              {214, 164, 74},
                                              {128, 98, 142},
                                              {88, 96, 104},
                                              {196, 134, 150}}};

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

std::optional<Colour> parseColour(std::string_view text) {
    std::uint32_t value = 0;
    if (text.size() != 7 || text.front() != '#') {
        return std::nullopt;
    }
    const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), value, 16);
    if (error != std::errc{} || end != text.data() + text.size()) {
        return std::nullopt;
    }
    return Colour{static_cast<std::uint8_t>(value >> 16U), static_cast<std::uint8_t>(value >> 8U),
                  static_cast<std::uint8_t>(value)};
}

const yarn::Yarn* findNamed(const yarn::YarnLibrary& library, const std::string& text) {
    if (const yarn::Yarn* found = library.find(text)) {
        return found;
    }
    const std::string wanted = lower(text);
    const auto& yarns = library.yarns();
    const auto found = std::find_if(yarns.begin(), yarns.end(), [&](const yarn::Yarn& candidate) {
        return lower(candidate.id) == wanted || lower(candidate.name) == wanted;
    });
    return found == yarns.end() ? nullptr : &*found;
}

std::vector<std::optional<Colour>> firstColours(const Program& program) {
    std::vector<std::optional<Colour>> colours(program.header.carriers.size());
    for (const Operation& op : program.operations) {
        if (op.kind != OperationKind::Colour || op.text < 0) {
            continue;
        }
        const auto colour = parseColour(program.texts[static_cast<std::size_t>(op.text)]);
        for (const CarrierIndex carrier : op.carriers) {
            if (carrier < colours.size() && !colours[carrier]) {
                colours[carrier] = colour;
            }
        }
    }
    return colours;
}

void markUsed(const Program& program, std::vector<CarrierYarn>& carriers) {
    for (const Operation& op : program.operations) {
        if (!carriesYarn(op.kind)) {
            continue;
        }
        for (const CarrierIndex carrier : op.carriers) {
            if (carrier < carriers.size()) {
                carriers[carrier].used = true;
            }
        }
    }
}

} // namespace

std::vector<CarrierYarn> carrierYarns(const Program& program, const yarn::YarnLibrary& library,
                                      const yarn::Yarn& fallback) {
    const auto colours = firstColours(program);
    std::vector<CarrierYarn> carriers(program.header.carriers.size());
    markUsed(program, carriers);
    std::size_t calm = 0;
    for (std::size_t i = 0; i < carriers.size(); ++i) {
        const Carrier& carrier = program.header.carriers[i];
        carriers[i].carrier = carrier.name;
        const yarn::Yarn* named = carrier.yarn.empty() ? nullptr : findNamed(library, carrier.yarn);
        carriers[i].yarn = named ? *named : fallback;
        if (!named && carriers[i].used) {
            carriers[i].yarn.colour = kCalmColours[calm++ % kCalmColours.size()];
        }
        if (colours[i]) {
            carriers[i].yarn.colour = *colours[i];
        }
    }
    return carriers;
}

std::vector<yarn::Yarn> yarnsOf(const std::vector<CarrierYarn>& carriers) {
    std::vector<yarn::Yarn> yarns;
    yarns.reserve(carriers.size());
    for (const CarrierYarn& carrier : carriers) {
        yarns.push_back(carrier.yarn);
    }
    return yarns;
}

bool sameBody(const yarn::Yarn& a, const yarn::Yarn& b) {
    return a.tex == b.tex && a.outerDiameterMm == b.outerDiameterMm && a.coreDiameterMm == b.coreDiameterMm &&
           a.axialStiffnessMilliNewton == b.axialStiffnessMilliNewton &&
           a.bendingStiffness == b.bendingStiffness && a.friction == b.friction;
}

} // namespace knittsim::machine
