#pragma once

#include "core/base/diagnostic.h"
#include "core/machine/timeline.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace knittsim::document {

/// Where playing stops by itself. Empty: nowhere.
struct StopRules {
    std::uint32_t kinds = 0; ///< bit of each OperationKind to stop at
    std::optional<machine::Needle> needle;
    std::optional<machine::CarrierIndex> carrier; ///< when it comes to work after another one
    bool racked = false;                          ///< when the rear bed is moved to a racking that is not 0
    bool problem = false;                         ///< at an operation with a problem

    bool empty() const { return *this == StopRules{}; }
    bool has(machine::OperationKind kind) const { return (kinds & bitOf(kind)) != 0; }
    void set(machine::OperationKind kind, bool on) {
        kinds = on ? kinds | bitOf(kind) : kinds & ~bitOf(kind);
    }

    bool operator==(const StopRules&) const = default;

private:
    static std::uint32_t bitOf(machine::OperationKind kind) {
        return std::uint32_t{1} << static_cast<unsigned>(kind);
    }
};

/// Finds the operations of one program at which rules stop.
class StopFinder {
public:
    StopFinder() = default;
    StopFinder(std::shared_ptr<const machine::Timeline> timeline, const Diagnostics& problems);

    /// The first operation in [from, to) at which `rules` stop, or -1.
    machine::OperationIndex first(const StopRules& rules, machine::OperationIndex from,
                                  machine::OperationIndex to) const;

private:
    bool stops(const StopRules& rules, machine::OperationIndex operation) const;
    bool comesToWork(machine::CarrierIndex carrier, machine::OperationIndex operation) const;

    std::shared_ptr<const machine::Timeline> m_timeline;
    std::vector<machine::OperationIndex> m_problems; ///< rising
};

/// "f5", "b-3", "fs2": the needle; nothing for other text.
std::optional<machine::Needle> needleFromText(const std::string& text);

} // namespace knittsim::document
