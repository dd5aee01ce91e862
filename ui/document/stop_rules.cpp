#include "ui/document/stop_rules.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

namespace knittsim::document {

using machine::Operation;
using machine::OperationIndex;
using machine::OperationKind;

StopFinder::StopFinder(std::shared_ptr<const machine::Timeline> timeline, const Diagnostics& problems)
    : m_timeline(std::move(timeline)) {
    for (const Diagnostic& problem : problems) {
        if (problem.severity != Severity::Info && problem.place.operation >= 0) {
            m_problems.push_back(problem.place.operation);
        }
    }
    std::ranges::sort(m_problems);
}

OperationIndex StopFinder::first(const StopRules& rules, OperationIndex from, OperationIndex to) const {
    if (!m_timeline || rules.empty()) {
        return -1;
    }
    for (OperationIndex i = std::max(0, from); i < std::min(to, m_timeline->operationCount()); ++i) {
        if (stops(rules, i)) {
            return i;
        }
    }
    return -1;
}

bool StopFinder::stops(const StopRules& rules, OperationIndex operation) const {
    const Operation& op = m_timeline->program().operations[static_cast<std::size_t>(operation)];
    if (rules.has(op.kind)) {
        return true;
    }
    const bool works = makesLoop(op.kind) || op.kind == OperationKind::Miss ||
                       op.kind == OperationKind::Xfer || op.kind == OperationKind::Drop ||
                       op.kind == OperationKind::Amiss;
    const bool aims = op.kind == OperationKind::Xfer || op.kind == OperationKind::Split;
    if (rules.needle && ((works && op.needle == *rules.needle) || (aims && op.target == *rules.needle))) {
        return true;
    }
    if (rules.racked && op.kind == OperationKind::Rack && op.value != 0) {
        return true;
    }
    if (rules.problem && std::ranges::binary_search(m_problems, operation)) {
        return true;
    }
    return rules.carrier && comesToWork(*rules.carrier, operation);
}

bool StopFinder::comesToWork(machine::CarrierIndex carrier, OperationIndex operation) const {
    const auto& operations = m_timeline->program().operations;
    const auto& now = operations[static_cast<std::size_t>(operation)];
    if (!carriesYarn(now.kind) || !now.carriers.contains(carrier)) {
        return false;
    }
    for (OperationIndex i = operation - 1; i >= 0; --i) {
        const Operation& before = operations[static_cast<std::size_t>(i)];
        if (carriesYarn(before.kind)) {
            return !before.carriers.contains(carrier);
        }
    }
    return true;
}

std::optional<machine::Needle> needleFromText(const std::string& text) {
    const std::size_t letters = text.find_first_of("-0123456789");
    if (letters == std::string::npos) {
        return std::nullopt;
    }
    const std::string bed = text.substr(0, letters);
    machine::Needle needle;
    const char* last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data() + letters, last, needle.index);
    constexpr std::array<std::string_view, machine::kBedCount> kBeds{"f", "b", "fs", "bs"}; // by Bed
    const auto found = std::ranges::find(kBeds, bed);
    if (error != std::errc{} || end != last || found == kBeds.end()) {
        return std::nullopt;
    }
    needle.bed = static_cast<machine::Bed>(found - kBeds.begin());
    return needle;
}

} // namespace knittsim::document
