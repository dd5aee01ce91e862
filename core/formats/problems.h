#pragma once

#include "core/base/diagnostic.h"

#include <cstddef>
#include <string>
#include <vector>

namespace knittsim::formats {

/// Warnings after which further ones are left out (KS0124 says so).
constexpr int kMaxWarnings = 100;

/// Errors after which a reader stops.
constexpr int kMaxErrors = 20;

/// Operations and source comments of one program; more end the reading (KS0125). Bounds the memory.
constexpr std::size_t kMaxOperations = 1'000'000;

/// A place in the file that is being read; both 1-based, the column in bytes.
struct Spot {
    int line = 1;
    int column = 1;
};

/// What a reader finds, within bounds: after `maxErrors` errors comes KS0115 and the list is full; after
/// kMaxWarnings warnings comes KS0124.
class Problems {
public:
    Problems(std::string file, int maxErrors) : m_file(std::move(file)), m_maxErrors(maxErrors) {}

    void error(const char* id, Spot spot, std::vector<std::string> arguments = {});
    void warn(const char* id, Spot spot, std::vector<std::string> arguments = {}, int operation = -1);

    /// error() or warn() by severity.
    void add(Severity severity, const char* id, Spot spot, std::vector<std::string> arguments);

    /// Reading should stop.
    bool full() const { return m_errors > m_maxErrors; }
    bool warningsFull() const { return m_warnings > kMaxWarnings; }
    int errorCount() const { return m_errors; }

    /// Sorted by line and column.
    Diagnostics take();

private:
    void push(Severity severity, const char* id, Spot spot, std::vector<std::string> arguments,
              int operation);

    std::string m_file;
    int m_maxErrors;
    int m_errors = 0;
    int m_warnings = 0;
    Diagnostics m_list;
};

} // namespace knittsim::formats
