#pragma once

#include "core/formats/problems.h"
#include "core/machine/program.h"

#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace knittsim::formats::knitout {

/// A line ';;Name: value'.
struct HeaderLine {
    std::string_view name;
    std::string_view value; ///< trimmed
    int valueColumn = 1;    ///< 1-based, in bytes
    bool blankAfterColon = true;
};

/// The parts of a line that begins with ';;', or nothing when it is an ordinary comment.
std::optional<HeaderLine> splitHeader(std::string_view line);

/// A header of the specification, or an extension of it ('X-...').
bool isKnownHeader(std::string_view name);

/// Turns header lines into a Header. Reports KS0104, KS0105, KS0109, KS0114, KS0117, KS0120.
class HeaderReader {
public:
    /// Both must outlive the reader.
    HeaderReader(machine::Header& header, Problems& problems) : m_header(header), m_problems(problems) {}

    void read(const HeaderLine& line, int lineNumber);

    /// To be called after the last header line: gives the carriers their yarns.
    void finish();

    /// A line ';;Carriers:' was there, whether right or wrong.
    bool sawCarriers() const { return m_sawCarriers; }

private:
    struct Yarn {
        std::string header;
        std::string value;
        int line;
    };

    void readCarriers(const HeaderLine& line, Spot spot);
    bool readRail(std::string_view rail, int number, Spot spot);
    bool readSide(std::string_view names, int rail, bool right, Spot spot);
    void readGauge(const HeaderLine& line, Spot spot);
    void readWidth(const HeaderLine& line, Spot spot);
    void readPosition(const HeaderLine& line, Spot spot);
    void badValue(std::string_view name, Spot spot, std::string found, std::string expected);

    machine::Header& m_header;
    Problems& m_problems;
    std::unordered_set<std::string> m_seen;
    std::vector<Yarn> m_yarns;
    bool m_sawCarriers = false;
};

} // namespace knittsim::formats::knitout
