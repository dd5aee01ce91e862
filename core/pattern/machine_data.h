#pragma once

#include "core/machine/profile_library.h"
#include "core/pattern/project.h"

namespace knittsim::pattern {

/// A program for the machine that will run it.
struct MachineData {
    machine::Program program;
    machine::MachineProfile machine;
};

/// The program that a file of this name is to hold: .dat is for Shima machines and .kc for Kniterate, all
/// else for the machine of the project. A project for another maker's machine is planned anew for the machine
/// of the format. These two formats always have a stitch number: where the chart begins without one, it is
/// that of the machine's usual loop length. Errors: those of compile().
Result<MachineData> machineDataFor(const std::filesystem::path& path, const Project& project,
                                   const machine::ProfileLibrary& machines);

} // namespace knittsim::pattern
