#pragma once

#include "core/base/diagnostic.h"

#include <span>
#include <string_view>

namespace knittsim::machine {

/// One rule that a program is checked against. Name, cause and cure stand in core/base/message_table.h.
struct Rule {
    std::string_view id;
    Severity severity = Severity::Error;
};

/// All rules of the machine, sorted by id, whoever finds them: the emulator or one of the checks.
std::span<const Rule> rules();

/// The rule with this id, or nullptr.
const Rule* findRule(std::string_view id);

} // namespace knittsim::machine
