#include "core/machine/checks/report.h"

#include "core/base/message_table.h"
#include "core/machine/checks/findings_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace knittsim::machine {

namespace {

using Json = nlohmann::ordered_json;

std::ptrdiff_t countOf(const CheckedFile& file, Severity severity) {
    return std::ranges::count(file.result.findings, severity, &Diagnostic::severity);
}

std::string plural(std::ptrdiff_t count, const char* word) {
    return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

} // namespace

std::string toJson(std::span<const CheckedFile> files) {
    Json list = Json::array();
    for (const CheckedFile& file : files) {
        list.push_back({{"file", file.file},
                        {"profile", file.profile.empty() ? Json(nullptr) : Json(file.profile)},
                        {"errors", countOf(file, Severity::Error)},
                        {"warnings", countOf(file, Severity::Warning)},
                        {"infos", countOf(file, Severity::Info)},
                        {"findings", findingsJson(file.result)}});
    }
    // Names of files and carriers may hold bytes that are not UTF-8.
    return Json{{"files", list}}.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string toText(const CheckedFile& file) {
    std::string text;
    for (const Diagnostic& finding : file.result.findings) {
        text += toLine(finding) + '\n';
    }
    text += fmt::format("{}: {}, {}, {}", file.file, plural(countOf(file, Severity::Error), "error"),
                        plural(countOf(file, Severity::Warning), "warning"),
                        plural(countOf(file, Severity::Info), "note"));
    text += file.profile.empty() ? "\n" : fmt::format(" (machine {})\n", file.profile);
    std::map<std::string, std::pair<std::ptrdiff_t, std::string>> off; // rule -> findings, reason
    for (const Waived& waived : file.result.waived) {
        auto& [count, reason] = off[waived.finding.id];
        ++count;
        reason = waived.reason;
    }
    for (const auto& [rule, kept] : off) {
        text += fmt::format("{}: {} of {} turned off: {}\n", file.file, plural(kept.first, "finding"), rule,
                            kept.second);
    }
    return text;
}

} // namespace knittsim::machine
