#include "core/machine/checks/findings_json.h"

#include "core/base/message_table.h"

#include <nlohmann/json.hpp>

namespace knittsim::machine {

namespace {

using Json = nlohmann::ordered_json;

Json known(int number) {
    return number >= 0 ? Json(number) : Json(nullptr);
}

Json findingJson(const Diagnostic& finding) {
    const Message* message = findMessage(finding.id);
    return {{"rule", finding.id},
            {"name", message != nullptr ? Json(message->name) : Json(nullptr)},
            {"severity", toString(finding.severity)},
            {"line", known(finding.place.line)},
            {"column", known(finding.place.column)},
            {"operation", known(finding.place.operation)},
            {"needle", finding.place.needle.empty() ? Json(nullptr) : Json(finding.place.needle)},
            {"cause", causeText(finding)},
            {"cure", cureText(finding)}};
}

} // namespace

Json findingsJson(const CheckResult& result) {
    Json findings = Json::array();
    for (const Diagnostic& finding : result.findings) {
        findings.push_back(findingJson(finding));
    }
    for (const Waived& waived : result.waived) {
        findings.push_back(findingJson(waived.finding));
        findings.back()["off_reason"] = waived.reason;
    }
    return findings;
}

} // namespace knittsim::machine
