#pragma once

#include "core/machine/timeline.h"

#include <string>
#include <vector>

namespace knittsim::machine {

/// Everything that the rules of the machine find in a program, in its order: what the timeline met and what
/// the checks see. Walks over the program once. Thresholds are those of the timeline's profile.
Diagnostics check(const Timeline& timeline);

/// A rule that shall not count, and why.
struct Waiver {
    std::string rule; ///< id
    std::string reason;

    bool operator==(const Waiver&) const = default;
};

/// A finding of a rule that is turned off; kept with the reason.
struct Waived {
    Diagnostic finding;
    std::string reason;
};

struct CheckResult {
    Diagnostics findings; ///< that count
    std::vector<Waived> waived;
};

/// Takes out the findings of rules that are turned off.
CheckResult applyWaivers(Diagnostics findings, const std::vector<Waiver>& waivers);

/// The rules that a profile turns off. Errors: KS0008 for a rule that does not exist.
Result<std::vector<Waiver>> waiversOf(const MachineProfile& profile);

/// A waiver from "RULE=REASON"; the rule is an id or a name of the message table. Errors: KS0008, KS0244.
Result<Waiver> parseWaiver(const std::string& text);

} // namespace knittsim::machine
