#include "core/export/report.h"

#include "core/base/file.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace knittsim::exports {

namespace {

using machine::OperationIndex;

Place placeOf(const machine::Program& program, OperationIndex operation) {
    return Place{.file = program.file,
                 .line = program.operations[static_cast<std::size_t>(operation)].line,
                 .operation = operation};
}

std::vector<YarnUse> yarnUses(const fabric::Fabric& fabric,
                              const std::vector<machine::CarrierYarn>& carriers) {
    std::vector<double> metres(carriers.size(), 0.0);
    for (const fabric::Yarn& yarn : fabric.yarns) {
        metres[yarn.carrier] += yarn.lengthMm / 1000;
    }
    std::vector<YarnUse> uses;
    for (std::size_t i = 0; i < carriers.size(); ++i) {
        if (metres[i] > 0) {
            uses.push_back({carriers[i].carrier, carriers[i].yarn.name, carriers[i].yarn.tex, metres[i]});
        }
    }
    return uses;
}

std::optional<LongestFloat> findLongestFloat(const machine::Timeline& timeline,
                                             const fabric::Fabric& fabric) {
    const auto& loops = timeline.loops().loops;
    const auto longest = std::ranges::max_element(loops, {}, &machine::Loop::wayPitches);
    if (longest == loops.end() || longest->wayPitches <= 1) {
        return std::nullopt;
    }
    const machine::Program& program = timeline.program();
    LongestFloat found{.mm = longest->wayPitches * timeline.profile().pitchMm(),
                       .needles = longest->wayPitches,
                       .carrier = program.header.carriers[longest->carrier].name,
                       .place = placeOf(program, longest->operation)};
    found.place.needle = machine::toString(longest->needle);
    found.place.course = fabric.loops[static_cast<std::size_t>(longest - loops.begin())].course;
    return found;
}

std::optional<LargestRacking> findLargestRacking(const machine::Program& program) {
    std::optional<LargestRacking> largest;
    for (std::size_t i = 0; i < program.operations.size(); ++i) {
        const machine::Operation& op = program.operations[i];
        if (op.kind == machine::OperationKind::Rack && op.value != 0 &&
            (!largest || std::abs(op.value) > std::abs(largest->pitches))) {
            largest = {op.value, placeOf(program, static_cast<OperationIndex>(i))};
        }
    }
    return largest;
}

} // namespace

Totals countTotals(const machine::Program& program, const fabric::Fabric& fabric) {
    std::set<machine::Needle> needles;
    for (const machine::Operation& op : program.operations) {
        if (machine::makesLoop(op.kind)) {
            needles.insert(op.needle);
        }
    }
    const auto front = static_cast<std::size_t>(
        std::ranges::count_if(needles, [](machine::Needle n) { return machine::isFront(n.bed); }));
    return {.operations = program.operations.size(),
            .passes = machine::findPasses(program).size(),
            .needles = needles.size(),
            .frontNeedles = front,
            .rearNeedles = needles.size() - front,
            .courses = fabric.courseCount,
            .loops = fabric.loops.size()};
}

Knitting describe(const machine::Timeline& timeline, const fabric::Fabric& fabric,
                  const std::vector<machine::CarrierYarn>& carriers) {
    const machine::Program& program = timeline.program();
    return {.profileId = timeline.profile().id,
            .profileName = timeline.profile().name,
            .totals = countTotals(program, fabric),
            .yarns = yarnUses(fabric, carriers),
            .time = estimateTime(program, timeline.profile()),
            .longestFloat = findLongestFloat(timeline, fabric),
            .largestRacking = findLargestRacking(program)};
}

Result<Written> writeReport(const Report& report, const std::filesystem::path& path) {
    const std::string extension = lowerExtension(path);
    if (extension == ".html" || extension == ".htm") {
        return writeFileAtomically(path, toHtml(report));
    }
    if (extension == ".json") {
        return writeFileAtomically(path, toJson(report));
    }
    return Diagnostic{"KS0025",
                      Severity::Error,
                      Place{.file = path.string()},
                      {extension.empty() ? "no extension" : extension}};
}

} // namespace knittsim::exports
