#pragma once

#include "core/machine/checks/check.h"

#include <span>
#include <string>

namespace knittsim::machine {

/// What was found in one file.
struct CheckedFile {
    std::string file;
    std::string profile; ///< id; empty where the file could not be read
    CheckResult result;
};

/// JSON: "files" with "file", "profile", "errors", "warnings", "infos" and "findings" (findings_json.h).
std::string toJson(std::span<const CheckedFile> files);

/// SARIF 2.1.0 (OASIS standard): one run, its rules, a result for each finding. What is turned off is an
/// external suppression with its reason.
std::string toSarif(std::span<const CheckedFile> files, const std::string& version);

/// For people: a line for each finding as compilers write it, then the counts and what is turned off.
std::string toText(const CheckedFile& file);

} // namespace knittsim::machine
