#pragma once

#include "core/base/result.h"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace knittsim {

/// Parses JSON text. Errors: those of whyNotText(); KS0003 with line, column (1-based, in bytes) and the
/// parser's words.
Result<nlohmann::json> parseJson(std::string_view text, const std::string& file);

/// Reads checked values of one JSON object and gathers everything that is wrong with them.
///
/// Every reading function marks its key as known and returns a harmless value when the key is missing
/// (KS0005) or its value is wrong (KS0004), so that one pass reports all problems. Keys are reported with
/// their path, for example "surface.plies"; what lies in a missing or wrong object is not reported again.
/// After kMaxProblems comes KS0115 and nothing more. The object and the diagnostics must outlive the reader.
class JsonReader {
public:
    static constexpr std::size_t kMaxProblems = 20;

    JsonReader(const nlohmann::json& value, std::string file, Diagnostics& diagnostics,
               std::string path = {});

    bool has(const std::string& key) const;

    /// Text that is not empty.
    std::string text(const std::string& key);
    /// One of `allowed`.
    std::string choice(const std::string& key, const std::vector<std::string>& allowed);
    double number(const std::string& key, double min, double max);
    int integer(const std::string& key, int min, int max);
    bool flag(const std::string& key);
    /// Reader of the object at `key`.
    JsonReader object(const std::string& key);
    /// Values of the array at `key`; empty when it is missing, no array, or not of min..max values.
    std::vector<nlohmann::json> array(const std::string& key, std::size_t min, std::size_t max);
    /// Text that may be missing or empty.
    std::string optionalText(const std::string& key);
    /// Names of the keys of this object in the order of the alphabet.
    std::vector<std::string> keys() const;

    /// Problems reported so far, by any reader of these diagnostics.
    std::size_t problemCount() const { return m_diagnostics->size(); }
    /// KS0004 at `key`: it is `found`, expected `expected`.
    void report(const std::string& key, std::string found, std::string expected);
    /// KS0004 for every key that no function above has asked for.
    void rejectUnknownKeys();

private:
    void add(Diagnostic problem);
    const nlohmann::json* find(const std::string& key, const std::string& expected);
    std::string pathOf(const std::string& key) const;

    const nlohmann::json* m_object;
    std::string m_file;
    std::string m_path;
    Diagnostics* m_diagnostics;
    std::vector<std::string> m_known;
};

/// `value` rounded to 12 significant decimal digits: undoes the noise that a change of units leaves.
double roundDecimal(double value);

} // namespace knittsim
