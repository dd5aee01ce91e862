#include "core/machine/checks/rules.h"

#include <algorithm>
#include <array>

namespace knittsim::machine {

namespace {

constexpr auto kRules = std::to_array<Rule>({
    // The emulator finds these.
    {"KS0201", Severity::Error},   // carrier used before in
    {"KS0202", Severity::Error},   // carrier brought in twice
    {"KS0203", Severity::Error},   // carrier out while not in
    {"KS0204", Severity::Error},   // hook still holds yarn
    {"KS0205", Severity::Error},   // release without hook
    {"KS0206", Severity::Error},   // not aligned
    {"KS0207", Severity::Error},   // same bed
    {"KS0208", Severity::Error},   // needle far off
    {"KS0209", Severity::Error},   // loop made on a slider
    {"KS0210", Severity::Warning}, // carrier never taken out
    {"KS0211", Severity::Warning}, // more findings of the emulator
    // hook_check
    {"KS0212", Severity::Error},   // inhook without release
    {"KS0213", Severity::Error},   // out while on the hook
    {"KS0214", Severity::Warning}, // released before a stitch
    {"KS0215", Severity::Warning}, // machine without hook
    {"KS0216", Severity::Error},   // hook enters in the wrong direction
    {"KS0217", Severity::Error},   // needle behind the hook
    // needle_check
    {"KS0218", Severity::Error}, // racking out of range
    {"KS0219", Severity::Error}, // racking between positions
    {"KS0220", Severity::Error}, // needle outside the bed
    {"KS0221", Severity::Error}, // machine without sliders
    {"KS0222", Severity::Error}, // slider to slider
    {"KS0223", Severity::Error}, // stitch while sliders hold
    {"KS0224", Severity::Info},  // nothing to move or drop
    // carrier_check
    {"KS0225", Severity::Info},  // carrier must be kicked back
    {"KS0226", Severity::Info},  // waiting yarn crosses a working carrier
    {"KS0227", Severity::Error}, // carriers collide
    // loop_check
    {"KS0228", Severity::Info},    // knit on an empty needle
    {"KS0229", Severity::Warning}, // dropped loop unravels
    {"KS0230", Severity::Info},    // loops left at the end
    {"KS0231", Severity::Warning}, // too many loops on a needle
    // held_check, float_check, loop_check, stretch_check
    {"KS0232", Severity::Warning}, // loop held too long
    {"KS0233", Severity::Warning}, // float too long
    {"KS0234", Severity::Warning}, // tuck stack
    {"KS0235", Severity::Error},   // loop stretched beyond its yarn
    // set_check; needle_check for the table
    {"KS0236", Severity::Warning}, // plating order changes
    {"KS0237", Severity::Warning}, // two carriers from different sides
    {"KS0238", Severity::Warning}, // unused carrier
    {"KS0239", Severity::Warning}, // stitch size out of table
    {"KS0240", Severity::Warning}, // first stitch with another set
    {"KS0241", Severity::Warning}, // carrier that the machine lacks
    // Told with them.
    {"KS0242", Severity::Warning}, // no profile for the machine
    {"KS0243", Severity::Info},    // more findings of a rule
});

static_assert(std::is_sorted(kRules.begin(), kRules.end(),
                             [](const Rule& a, const Rule& b) { return a.id < b.id; }));

} // namespace

std::span<const Rule> rules() {
    return kRules;
}

const Rule* findRule(std::string_view id) {
    const auto* found = std::ranges::lower_bound(kRules, id, {}, &Rule::id);
    return found != kRules.end() && found->id == id ? found : nullptr;
}

} // namespace knittsim::machine
