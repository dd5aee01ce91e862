#pragma once

#include "core/base/diagnostic.h"

#include <span>
#include <string>
#include <string_view>

namespace knittsim {

/// English text of one rule. {0}, {1}, ... stand for Diagnostic::arguments.
struct Message {
    std::string_view id;
    std::string_view name;  ///< short kebab-case name, for example "unknown-operation"
    std::string_view cause; ///< one sentence: what is wrong
    std::string_view cure;  ///< one sentence: what to do; may be empty
};

/// Every rule the program knows, sorted by id. The window translates `cause` and `cure`.
std::span<const Message> messages();

/// The rule with this id, or nullptr.
const Message* findMessage(std::string_view id);

/// Replaces {0}, {1}, ... in `pattern`. Missing arguments leave the braces as they are.
std::string fillMessage(std::string_view pattern, const std::vector<std::string>& arguments);

std::string causeText(const Diagnostic& diagnostic);
std::string cureText(const Diagnostic& diagnostic);

/// "file:line:column: error KS0003: cause cure", as compilers write it.
std::string toLine(const Diagnostic& diagnostic);

} // namespace knittsim
