#pragma once

#include "core/machine/checks/check_group.h"

#include <memory>

namespace knittsim::machine {

// One function for each group of rules; the ids are in rules.cpp. `timeline` and `findings` must outlive it.
std::unique_ptr<CheckGroup> makeHookCheck(const Timeline& timeline, Findings& findings);
std::unique_ptr<CheckGroup> makeNeedleCheck(const Timeline& timeline, Findings& findings);
std::unique_ptr<CheckGroup> makeCarrierCheck(const Timeline& timeline, Findings& findings);
std::unique_ptr<CheckGroup> makeSetCheck(const Timeline& timeline, Findings& findings);
std::unique_ptr<CheckGroup> makeLoopCheck(const Timeline& timeline, Findings& findings);
std::unique_ptr<CheckGroup> makeHeldCheck(const Timeline& timeline, Findings& findings);
std::unique_ptr<CheckGroup> makeFloatCheck(const Timeline& timeline, Findings& findings);
std::unique_ptr<CheckGroup> makeStretchCheck(const Timeline& timeline, Findings& findings);

} // namespace knittsim::machine
