#include "core/pattern/machine_data.h"

#include <algorithm>
#include <cmath>

namespace knittsim::pattern {

using machine::MachineProfile;

namespace {

/// Of ';;Machine:'; empty: a format for all machines.
std::string_view machineOf(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return extension == ".dat" ? "SWG" : extension == ".kc" ? "Kniterate" : "";
}

bool areOneMaker(const MachineProfile& a, const MachineProfile& b) {
    return std::ranges::any_of(a.machineNames, [&](const std::string& name) {
        return std::ranges::find(b.machineNames, name) != b.machineNames.end();
    });
}

/// Entry of the stitch table that is nearest to the loop length of programs without stitch number.
std::optional<double> usualStitchNumber(const MachineProfile& machine) {
    const auto& table = machine.stitchTable;
    const auto nearest = std::ranges::min_element(table, {}, [&](const std::pair<double, double>& entry) {
        return std::abs(entry.second - machine.defaultLoopLengthMm);
    });
    return nearest == table.end() ? std::nullopt : std::optional(nearest->first);
}

} // namespace

Result<MachineData> machineDataFor(const std::filesystem::path& path, const Project& project,
                                   const machine::ProfileLibrary& machines) {
    CompileOptions options = optionsOf(project, machines);
    Chart chart = project.chart;
    if (const std::string_view name = machineOf(path); !name.empty()) {
        const MachineProfile* maker = machines.findMachine(name);
        if (maker && !areOneMaker(*maker, options.machine)) {
            options.machine = *maker;
        }
        if (!chart.courses.empty() && !chart.courses.front().stitchNumber) {
            chart.courses.front().stitchNumber = usualStitchNumber(options.machine);
        }
    }
    Result<machine::Program> program = compile(chart, options);
    if (!program) {
        return Result<MachineData>::failure(program.diagnostics());
    }
    return MachineData{std::move(program).value(), std::move(options.machine)};
}

} // namespace knittsim::pattern
