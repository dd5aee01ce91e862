#pragma once

#include "core/base/result.h"
#include "core/base/units.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace knittsim::machine {

/// Where the checks begin to complain (core/machine/checks).
struct ProfileLimits {
    double floatMm = 40; ///< longest float
    double floatNeedles = 20;
    int heldPasses = 16;   ///< passes of a yarn that a loop may wait for its stitch
    int tucksOnNeedle = 4; ///< tucks above each other without a stitch
    /// Way between the needles of two neighbouring loops of a yarn, as a multiple of the yarn between them.
    /// Above 1 the yarn comes out of the loops beside them.
    double stretch = 1.8;

    bool operator==(const ProfileLimits&) const = default;
};

/// How fast the carriage works, for estimates of knitting time.
struct ProfileSpeed {
    double knitMetresPerSecond = 0.8;     ///< of a stroke that makes stitches
    double transferMetresPerSecond = 0.5; ///< of a stroke that moves loops
    double turnSeconds = 0.6;             ///< from stroke to stroke, racking included
    bool assumed = true;                  ///< the profile names no speed: the values above

    bool operator==(const ProfileSpeed&) const = default;
};

/// What a machine can do and how much yarn it feeds. Read from resources/machines/*.json.
struct MachineProfile {
    std::string id;
    std::string name;
    std::vector<std::string> machineNames; ///< values of ';;Machine:' that mean it; a final * stands for any
    double gauge = 15;                     ///< needles per inch
    int needlesPerBed = 540;
    double bedGapMm = 2.2; ///< distance of the two needle rows
    double minRack = -8;   ///< pitches
    double maxRack = 8;
    std::vector<double> rackFractions{0, 0.25, 0.5, 0.75}; ///< allowed fractional parts
    std::vector<std::string> carriers;
    bool sliders = true;
    bool insertingHook = true;
    /// Needles right of its first stitch that the inserting hook blocks until it is released; the yarn must
    /// then start to the left. 0: not checked.
    int hookBlocksNeedles = 0;
    double carrierStopPitches = 2.5; ///< a carrier stops so far beyond its last needle
    int maxLoopsOnNeedle = 6;
    double defaultLoopLengthMm = 5; ///< yarn in one plain loop where the program names no stitch size
    std::vector<std::pair<double, double>> stitchTable; ///< stitch number -> loop length mm, sorted by number
    ProfileLimits limits;
    ProfileSpeed speed;
    std::vector<std::pair<std::string, std::string>> checksOff; ///< rule -> reason why it is not checked

    double pitchMm() const { return units::kMillimetresPerInch / gauge; }
    double bedLengthMm() const { return needlesPerBed * pitchMm(); }

    /// Yarn in one plain loop, mm: linear between table entries, the end values outside; the default with no
    /// table.
    double loopLengthMm(double stitchNumber) const;

    /// Yarn between two loops beyond the sinker of a plain loop, which spans one pitch: `wayPitches` along
    /// the bed, and from bed to bed also across the gap. mm, never negative.
    double extraYarnMm(double wayPitches, bool fromBedToBed) const;
};

/// Reads and checks one profile. Errors: KS0001, KS0007 and those of parseJson() and JsonReader.
Result<MachineProfile> readMachineProfile(const std::filesystem::path& path);
Result<MachineProfile> parseMachineProfile(std::string_view json, const std::string& file);

/// The built-in generic 15-gauge machine, used where nothing else is named. Same values as generic-e15.json.
MachineProfile genericProfile();

} // namespace knittsim::machine
