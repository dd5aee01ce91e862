#pragma once

#include "core/base/file.h"
#include "core/export/report_time.h"
#include "core/fabric/fabric.h"
#include "core/machine/carrier_yarns.h"
#include "core/machine/checks/check.h"
#include "core/machine/timeline.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace knittsim::exports {

/// Counts of a program and its fabric.
struct Totals {
    std::size_t operations = 0;
    std::size_t passes = 0;
    std::size_t needles = 0; ///< that make loops
    std::size_t frontNeedles = 0;
    std::size_t rearNeedles = 0;
    int courses = 0; ///< of the fabric
    std::size_t loops = 0;
};

Totals countTotals(const machine::Program& program, const fabric::Fabric& fabric);

/// What one carrier feeds.
struct YarnUse {
    std::string carrier;
    std::string yarn; ///< name
    double tex = 0;   ///< g/km
    double metres = 0;
    double grams() const { return metres * tex / 1000; }
};

/// The longest way of a yarn from one loop to the next beyond the neighbouring needle.
struct LongestFloat {
    double mm = 0;
    double needles = 0; ///< pitches
    std::string carrier;
    Place place; ///< of the loop at its end
};

struct LargestRacking {
    double pitches = 0; ///< with its sign
    Place place;        ///< of the first operation that racks so far
};

/// What follows from the program; there is none for a file that cannot be read.
struct Knitting {
    std::string profileId;
    std::string profileName;
    Totals totals;
    std::vector<YarnUse> yarns; ///< used carriers in the order of the machine
    KnittingTime time;
    std::optional<LongestFloat> longestFloat;
    std::optional<LargestRacking> largestRacking; ///< nothing where the beds never move
};

Knitting describe(const machine::Timeline& timeline, const fabric::Fabric& fabric,
                  const std::vector<machine::CarrierYarn>& carriers);

/// All that quality assurance wants to know about one file.
struct Report {
    std::string file;
    std::string sha256; ///< of its bytes; empty where they cannot be read
    std::optional<Knitting> knitting;
    machine::CheckResult checks;
    std::string version; ///< of the program that writes the report
};

/// A page of its own for people: no scripts, no links to elsewhere, light and dark, prints well. All text of
/// the file is escaped.
std::string toHtml(const Report& report);

/// Keys are snake_case with their unit, courses count from 1; null stands for what there is not.
std::string toJson(const Report& report);

/// HTML or JSON by the extension, whole or not at all. Errors: KS0002, KS0025 for another extension.
Result<Written> writeReport(const Report& report, const std::filesystem::path& path);

} // namespace knittsim::exports
