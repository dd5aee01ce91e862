#pragma once

#include "core/base/result.h"
#include "core/machine/carrier_yarns.h"
#include "core/machine/profile.h"
#include "core/machine/program.h"
#include "core/pattern/project.h"

namespace knittsim::pattern {

struct Lifted {
    Project project;
    int kept = 0;      ///< courses that only their operations say (Course::program)
    Diagnostics notes; ///< KS0511 where there are such courses, KS0513
};

/// The chart of any program: needles by courses, each cell what the machine makes there.
///
/// A course is what passes of different carriers make of different wales; a pass that comes back, or follows
/// transfers, begins a new one. Each course is then compiled: where that gives the program's own operations
/// the chart says all, else it keeps them (ProgramCourse). So compiling the lifted chart gives the program
/// again, less rackings and stitch numbers that change nothing. Time is linear in the number of operations.
///
/// `yarns`: by carrier, for colours and library ids. Errors: KS0510, KS0512, KS0514, KS0515.
Result<Lifted> lift(const machine::Program& program, const machine::MachineProfile& machine,
                    const std::vector<machine::CarrierYarn>& yarns);

/// The chart of any file: a project as it is, machine data of any format lifted on the machine that it names.
/// Notes are with the value. Errors: those of readProjectFile(), formats::readProgram() and lift().
Result<Project> readAnyProject(const std::filesystem::path& path);

} // namespace knittsim::pattern
