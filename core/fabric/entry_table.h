#pragma once

#include "core/fabric/fabric.h"

#include <vector>

namespace knittsim::fabric {

/// Rows of the bonding point table while they are being found: two heads for every loop, of which some turn
/// out to be the same place, and one row for every crossing of two strands.
class EntryTable {
public:
    explicit EntryTable(std::size_t loopCount) : m_joined(loopCount * 2) {
        for (std::size_t i = 0; i < m_joined.size(); ++i) {
            m_joined[i] = static_cast<std::int32_t>(i);
        }
    }

    static std::int32_t head(LoopIndex loop, Side side) { return loop * 2 + (side == Side::Right ? 1 : 0); }

    void join(std::int32_t a, std::int32_t b) {
        const std::int32_t rootA = root(a);
        const std::int32_t rootB = root(b);
        m_joined[static_cast<std::size_t>(rootA < rootB ? rootB : rootA)] = rootA < rootB ? rootA : rootB;
    }

    /// The row of a head; rows are numbered as they are first asked for.
    EntryIndex rowOf(std::int32_t head) {
        if (m_rows.empty()) {
            m_rows.assign(m_joined.size(), -1);
        }
        EntryIndex& row = m_rows[static_cast<std::size_t>(root(head))];
        if (row < 0) {
            row = m_rowCount++;
        }
        return row;
    }

    EntryIndex newRow() { return m_rowCount++; }
    EntryIndex rowCount() const { return m_rowCount; }

private:
    std::int32_t root(std::int32_t i) {
        while (m_joined[static_cast<std::size_t>(i)] != i) {
            auto& next = m_joined[static_cast<std::size_t>(i)];
            next = m_joined[static_cast<std::size_t>(next)];
            i = next;
        }
        return i;
    }

    std::vector<std::int32_t> m_joined; ///< union-find forest over heads
    std::vector<EntryIndex> m_rows;     ///< by root
    EntryIndex m_rowCount = 0;
};

} // namespace knittsim::fabric
