#pragma once

#include "core/formats/problems.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace knittsim::formats::sintral {

/// Rows of symbols, one symbol a needle, the first knitted row first.
class Jacquard {
public:
    static constexpr std::size_t kMaxColumns = 10'000;
    static constexpr std::size_t kMaxSymbols = std::size_t{64} << 20; ///< of all rows

    /// Reads "1002 .AY6.3(G.)": a line number, then symbols, nX for n times X, n(XYZ) for n times a group;
    /// '$' at the end of a line and at the beginning of the next joins them to one row. False, and KS0153,
    /// when it is none.
    bool addLine(std::string_view line, Spot spot, Problems& problems);

    /// To be called at the end of the text.
    bool finish(Spot spot, Problems& problems);

    int rowCount() const { return static_cast<int>(m_rows.size()); }
    const std::string& row(int index) const { return m_rows[static_cast<std::size_t>(index)]; }

    /// Index of the row that begins at this line number, -1 where none does.
    int findRow(int lineNumber) const;

private:
    std::vector<std::string> m_rows;
    std::map<int, int> m_byLine;
    std::size_t m_symbols = 0;
    bool m_open = false; ///< the last row goes on
};

} // namespace knittsim::formats::sintral
