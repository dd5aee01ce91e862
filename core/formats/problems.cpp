#include "core/formats/problems.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace knittsim::formats {

void Problems::error(const char* id, Spot spot, std::vector<std::string> arguments) {
    if (full()) {
        return;
    }
    if (++m_errors > m_maxErrors) {
        push(Severity::Error, "KS0115", spot, {std::to_string(m_maxErrors)}, -1);
        return;
    }
    push(Severity::Error, id, spot, std::move(arguments), -1);
}

void Problems::warn(const char* id, Spot spot, std::vector<std::string> arguments, int operation) {
    if (warningsFull()) {
        return;
    }
    if (++m_warnings > kMaxWarnings) {
        push(Severity::Warning, "KS0124", spot, {std::to_string(kMaxWarnings)}, -1);
        return;
    }
    push(Severity::Warning, id, spot, std::move(arguments), operation);
}

void Problems::add(Severity severity, const char* id, Spot spot, std::vector<std::string> arguments) {
    if (severity == Severity::Error) {
        error(id, spot, std::move(arguments));
    } else {
        warn(id, spot, std::move(arguments));
    }
}

Diagnostics Problems::take() {
    // What a reader can tell only at the end may belong to an early line.
    std::stable_sort(m_list.begin(), m_list.end(), [](const Diagnostic& a, const Diagnostic& b) {
        return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
    });
    return std::exchange(m_list, {});
}

void Problems::push(Severity severity, const char* id, Spot spot, std::vector<std::string> arguments,
                    int operation) {
    Place place{.file = m_file, .line = spot.line, .column = spot.column, .operation = operation};
    m_list.push_back({id, severity, std::move(place), std::move(arguments)});
}

} // namespace knittsim::formats
