#include "core/machine/profile.h"

#include "core/base/file.h"
#include "core/base/json_places.h"
#include "core/base/json_reader.h"
#include "core/machine/operation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace knittsim::machine {

namespace {

constexpr std::size_t kMaxProfileBytes = std::size_t{1} << 20;
constexpr double kMaxLoopLengthMm = 200;
constexpr std::size_t kMaxStitchEntries = 1000;
constexpr double kBedLengthTolerance = 0.02;

void readRack(JsonReader reader, MachineProfile& profile) {
    profile.minRack = reader.number("min", -1000, 0);
    profile.maxRack = reader.number("max", 0, 1000);
    profile.rackFractions.clear();
    for (const nlohmann::json& value : reader.array("fractions", 1, 100)) {
        if (!value.is_number() || value.get<double>() < 0 || value.get<double>() >= 1) {
            reader.report("fractions", value.dump(), "numbers from 0 to below 1");
            return;
        }
        profile.rackFractions.push_back(value.get<double>());
    }
    std::ranges::sort(profile.rackFractions);
    if (!profile.rackFractions.empty() && profile.rackFractions.front() != 0) {
        reader.report("fractions", "without 0", "0 among them, for transfers");
    }
    reader.rejectUnknownKeys();
}

std::vector<std::string> readCarriers(JsonReader& reader) {
    std::vector<std::string> carriers;
    for (const nlohmann::json& value : reader.array("carriers", 1, kMaxCarriers)) {
        const std::string name = value.is_string() ? value.get<std::string>() : std::string();
        if (name.empty() || std::ranges::count(carriers, name) > 0) {
            reader.report("carriers", value.dump(), "names that differ");
            break;
        }
        carriers.push_back(name);
    }
    return carriers;
}

std::vector<std::pair<double, double>> readStitchTable(JsonReader& reader, const std::string& file,
                                                       Diagnostics& diagnostics) {
    std::vector<std::pair<double, double>> table;
    const std::vector<nlohmann::json> entries = reader.array("stitch_table", 0, kMaxStitchEntries);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        JsonReader entry(entries[i], file, diagnostics, fmt::format("stitch_table.{}", i));
        const double number = entry.number("number", 0, 1e6);
        const double length = entry.number("loop_length_mm", 0.1, kMaxLoopLengthMm);
        if (!table.empty() && number <= table.back().first) {
            entry.report("number", fmt::format("{}", number),
                         fmt::format("more than {}", table.back().first));
        }
        entry.rejectUnknownKeys();
        table.emplace_back(number, length);
    }
    return table;
}

std::vector<std::string> readMachineNames(JsonReader& reader) {
    std::vector<std::string> names;
    for (const nlohmann::json& value : reader.array("machine_names", 0, 100)) {
        const std::string name = value.is_string() ? value.get<std::string>() : std::string();
        if (name.empty() || name == "*") {
            reader.report("machine_names", value.dump(), "names as ';;Machine:' gives them");
            break;
        }
        names.push_back(name);
    }
    return names;
}

ProfileLimits readLimits(JsonReader reader) {
    ProfileLimits limits;
    limits.floatMm = reader.number("float_mm", 1, 10'000);
    limits.floatNeedles = reader.number("float_needles", 1, 10'000);
    limits.heldPasses = reader.integer("held_passes", 1, 10'000);
    limits.tucksOnNeedle = reader.integer("tucks_on_needle", 1, 100);
    limits.stretch = reader.number("stretch", 0.1, 100);
    reader.rejectUnknownKeys();
    return limits;
}

ProfileSpeed readSpeed(JsonReader reader) {
    ProfileSpeed speed;
    speed.knitMetresPerSecond = reader.number("knit_m_per_s", 0.01, 10);
    speed.transferMetresPerSecond = reader.number("transfer_m_per_s", 0.01, 10);
    speed.turnSeconds = reader.number("turn_s", 0, 60);
    speed.assumed = false;
    reader.rejectUnknownKeys();
    return speed;
}

/// The length of the bed may be written for the reader's sake; it must agree with needles and gauge.
void checkBedLength(JsonReader& reader, const MachineProfile& profile) {
    if (!reader.has("bed_length_mm")) {
        return;
    }
    const double length = reader.number("bed_length_mm", 1, 100'000);
    if (std::abs(length - profile.bedLengthMm()) > kBedLengthTolerance * profile.bedLengthMm()) {
        reader.report("bed_length_mm", fmt::format("{}", length),
                      fmt::format("{:.0f}, as needles and gauge say", profile.bedLengthMm()));
    }
}

std::vector<std::pair<std::string, std::string>> readChecksOff(JsonReader reader) {
    std::vector<std::pair<std::string, std::string>> off;
    for (const std::string& rule : reader.keys()) {
        off.emplace_back(rule, reader.text(rule));
    }
    return off;
}

void checkSources(JsonReader reader) {
    for (const std::string& key : reader.keys()) {
        reader.text(key);
    }
}

MachineProfile readProfile(JsonReader& reader, const std::string& file, Diagnostics& diagnostics) {
    MachineProfile profile;
    profile.id = reader.text("id");
    profile.name = reader.text("name");
    profile.gauge = reader.number("gauge_needles_per_inch", 0.5, 100);
    profile.needlesPerBed = reader.integer("needles_per_bed", 1, 10'000);
    checkBedLength(reader, profile);
    if (reader.has("machine_names")) {
        profile.machineNames = readMachineNames(reader);
    }
    profile.bedGapMm = reader.number("bed_gap_mm", 0.1, 100);
    readRack(reader.object("rack"), profile);
    profile.carriers = readCarriers(reader);
    profile.sliders = reader.flag("sliders");
    profile.insertingHook = reader.flag("inserting_hook");
    profile.hookBlocksNeedles = reader.integer("hook_blocks_needles", 0, 1000);
    profile.carrierStopPitches = reader.number("carrier_stop_pitches", 0, 100);
    profile.maxLoopsOnNeedle = reader.integer("max_loops_on_needle", 1, 100);
    profile.defaultLoopLengthMm = reader.number("default_loop_length_mm", 0.1, kMaxLoopLengthMm);
    profile.stitchTable = readStitchTable(reader, file, diagnostics);
    profile.limits = readLimits(reader.object("limits"));
    if (reader.has("speed")) {
        profile.speed = readSpeed(reader.object("speed"));
    }
    if (reader.has("checks_off")) {
        profile.checksOff = readChecksOff(reader.object("checks_off"));
    }
    if (reader.has("sources")) {
        checkSources(reader.object("sources"));
    }
    reader.optionalText("note");
    reader.rejectUnknownKeys();
    return profile;
}

} // namespace

double MachineProfile::extraYarnMm(double wayPitches, bool fromBedToBed) const {
    const double way = std::hypot(wayPitches * pitchMm(), fromBedToBed ? bedGapMm : 0.0);
    return std::max(0.0, way - pitchMm());
}

double MachineProfile::loopLengthMm(double stitchNumber) const {
    if (stitchTable.empty()) {
        return defaultLoopLengthMm;
    }
    using Entry = std::pair<double, double>;
    const auto above = std::ranges::upper_bound(stitchTable, stitchNumber, {}, &Entry::first);
    if (above == stitchTable.begin()) {
        return stitchTable.front().second;
    }
    if (above == stitchTable.end()) {
        return stitchTable.back().second;
    }
    const Entry& below = *std::prev(above);
    const double part = (stitchNumber - below.first) / (above->first - below.first);
    return below.second + part * (above->second - below.second);
}

Result<MachineProfile> parseMachineProfile(std::string_view json, const std::string& file) {
    const Result<nlohmann::json> document = parseJson(json, file);
    if (!document) {
        return Result<MachineProfile>::failure(document.diagnostics());
    }
    Diagnostics diagnostics;
    JsonReader reader(document.value(), file, diagnostics);
    MachineProfile profile = readProfile(reader, file, diagnostics);
    if (hasErrors(diagnostics)) {
        tellLines(json, diagnostics);
        return Result<MachineProfile>::failure(std::move(diagnostics));
    }
    return profile;
}

Result<MachineProfile> readMachineProfile(const std::filesystem::path& path) {
    const Result<std::string> bytes = readFile(path, kMaxProfileBytes);
    if (!bytes) {
        return Result<MachineProfile>::failure(bytes.diagnostics());
    }
    return parseMachineProfile(bytes.value(), path.string());
}

MachineProfile genericProfile() {
    MachineProfile profile;
    profile.id = "generic-e15";
    profile.name = "Generic V-bed, 15 gauge";
    profile.carriers = {"1", "2", "3", "4", "5", "6", "7", "8", "9", "10"};
    profile.stitchTable = {{0, 4.0}, {60, 5.0}, {120, 6.5}};
    return profile;
}

} // namespace knittsim::machine
