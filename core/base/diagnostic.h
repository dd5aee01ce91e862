#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace knittsim {

enum class Severity : std::uint8_t { Info, Warning, Error };

std::string_view toString(Severity severity);

/// Where a diagnostic belongs. Every field is optional; -1 or empty means "not known".
struct Place {
    std::string file{};   ///< path as the caller gave it
    int line = -1;        ///< 1-based line of the file
    int column = -1;      ///< 1-based byte column of the line
    int operation = -1;   ///< 0-based index into machine::Program::operations
    int course = -1;      ///< 0-based fabric course
    std::string needle{}; ///< "f5", "b-3", "fs2", ...

    bool operator==(const Place&) const = default;
};

/// One finding. Carries no sentence: `id` and `arguments` are turned into text by message_table.h
/// (English) or by the window (translated), so that every user of the core sees the same finding.
struct Diagnostic {
    std::string id; ///< stable rule id, for example "KS0003"
    Severity severity = Severity::Error;
    Place place;
    std::vector<std::string> arguments; ///< values for {0}, {1}, ... of the message

    bool operator==(const Diagnostic&) const = default;
};

using Diagnostics = std::vector<Diagnostic>;

bool hasErrors(const Diagnostics& diagnostics);

/// Something worse than a note.
bool hasWarnings(const Diagnostics& diagnostics);

/// Errors and warnings; not notes.
std::size_t problemCount(const Diagnostics& diagnostics);

} // namespace knittsim
