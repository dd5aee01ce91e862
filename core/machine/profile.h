#pragma once

#include "core/base/result.h"
#include "core/base/units.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace knittsim::machine {

/// What a machine can do and how much yarn it feeds. Read from resources/machines/*.json.
struct MachineProfile {
    std::string id;
    std::string name;
    double gauge = 15; ///< needles per inch
    int needlesPerBed = 540;
    double bedGapMm = 2.2; ///< distance of the two needle rows
    double minRack = -8;   ///< pitches
    double maxRack = 8;
    std::vector<double> rackFractions{0, 0.25, 0.5, 0.75}; ///< allowed fractional parts
    std::vector<std::string> carriers;
    bool sliders = true;
    bool insertingHook = true;
    int maxLoopsOnNeedle = 6;
    double defaultLoopLengthMm = 5; ///< yarn in one plain loop where the program names no stitch size
    std::vector<std::pair<double, double>> stitchTable; ///< stitch number -> loop length mm, sorted by number

    double pitchMm() const { return units::kMillimetresPerInch / gauge; }

    /// Yarn in one plain loop, mm: linear between table entries, the end values outside; the default with no
    /// table.
    double loopLengthMm(double stitchNumber) const;

    /// Yarn between two loops beyond the sinker of a plain loop, which spans one pitch: `wayPitches` along
    /// the bed, and from bed to bed also across the gap. mm, never negative.
    double extraYarnMm(double wayPitches, bool fromBedToBed) const;
};

/// Reads and checks one profile. Errors: KS0001, KS0003..KS0005.
Result<MachineProfile> readMachineProfile(const std::filesystem::path& path);
Result<MachineProfile> parseMachineProfile(std::string_view json, const std::string& file);

/// The built-in generic 15-gauge machine, used where nothing else is named. Same values as generic-e15.json.
MachineProfile genericProfile();

} // namespace knittsim::machine
