#include "core/base/message_table.h"
#include "core/machine/checks/check.h"

#include <algorithm>

namespace knittsim::machine {

namespace {

/// The rule with this id or name.
const Message* findRuleText(std::string_view text) {
    const auto found =
        std::ranges::find_if(messages(), [&](const Message& m) { return m.id == text || m.name == text; });
    return found == messages().end() ? nullptr : &*found;
}

Result<Waiver> makeWaiver(const std::string& rule, const std::string& reason) {
    const Message* known = findRuleText(rule);
    if (known == nullptr) {
        return Diagnostic{
            "KS0008", Severity::Error, {}, {"rule", rule, "the rules of 'knittsim-cli check --rules'"}};
    }
    if (reason.empty()) {
        return Diagnostic{"KS0244", Severity::Error, {}, {rule}};
    }
    return Waiver{std::string(known->id), reason};
}

} // namespace

Result<Waiver> parseWaiver(const std::string& text) {
    const std::size_t equals = text.find('=');
    return equals == std::string::npos ? makeWaiver(text, {})
                                       : makeWaiver(text.substr(0, equals), text.substr(equals + 1));
}

Result<std::vector<Waiver>> waiversOf(const MachineProfile& profile) {
    std::vector<Waiver> waivers;
    for (const auto& [rule, reason] : profile.checksOff) {
        Result<Waiver> waiver = makeWaiver(rule, reason);
        if (!waiver) {
            return Result<std::vector<Waiver>>::failure(waiver.diagnostics());
        }
        waivers.push_back(std::move(waiver).value());
    }
    return waivers;
}

CheckResult applyWaivers(Diagnostics findings, const std::vector<Waiver>& waivers) {
    CheckResult result;
    for (Diagnostic& finding : findings) {
        const auto waiver = std::ranges::find(waivers, finding.id, &Waiver::rule);
        if (waiver == waivers.end()) {
            result.findings.push_back(std::move(finding));
        } else {
            result.waived.push_back({std::move(finding), waiver->reason});
        }
    }
    return result;
}

} // namespace knittsim::machine
