#include "core/formats/formats.h"
#include "core/machine/checks/check.h"
#include "core/pattern/machine_data.h"
#include "core/pattern/sample_charts.h"
#include "core/pattern/swatch.h"
#include "knitted.h"

namespace knittsim::pattern {
namespace {

using machine::OperationKind;

machine::ProfileLibrary machines() {
    Diagnostics problems;
    auto library = machine::ProfileLibrary::read({machine::profileFolders().front()}, problems);
    EXPECT_TRUE(problems.empty());
    return library;
}

Project projectFor(const std::string& machine) {
    Project project;
    project.chart = plainChart(20, 12);
    project.chart.course(6).moves = cross(4, 1, 1, Front::Right);
    project.machine = machine;
    return project;
}

MachineData dataFor(const std::string& file, const Project& project) {
    const auto data = machineDataFor(file, project, machines());
    EXPECT_TRUE(data) << data.diagnostics()[0].id;
    return data ? data.value() : MachineData{};
}

TEST(MachineData, EveryFormatIsWrittenWhateverTheMachineOfTheChart) {
    for (const char* machine : {"generic-e15", "shima-swg", "kniterate", "stoll-cms"}) {
        for (const char* file : {"a.k", "a.dat", "a.KC"}) {
            const MachineData data = dataFor(file, projectFor(machine));
            EXPECT_TRUE(formats::writeProgram(data.program, file)) << machine << ' ' << file;
            for (const Diagnostic& finding : machine::check({data.program, data.machine})) {
                EXPECT_NE(finding.severity, Severity::Error) << machine << ' ' << file << ' ' << finding.id;
            }
        }
    }
}

TEST(MachineData, TheMachineIsThatOfTheFormat) {
    EXPECT_EQ(dataFor("a.k", projectFor("stoll-cms")).machine.id, "stoll-cms");
    EXPECT_EQ(dataFor("a.dat", projectFor("generic-e15")).machine.id, "shima-swg");
    const MachineData data = dataFor("a.kc", projectFor("generic-e15"));
    EXPECT_EQ(data.machine.id, "kniterate");
    EXPECT_EQ(count(data.program, OperationKind::InHook), 0) << "it has no inserting hook";
    EXPECT_EQ(count(dataFor("a.k", projectFor("generic-e15")).program, OperationKind::InHook), 1);
}

TEST(MachineData, LoopsAreAsLongAsInTheChart) {
    const MachineData plain = dataFor("a.k", projectFor("shima-swg"));
    const MachineData data = dataFor("a.dat", projectFor("shima-swg"));
    EXPECT_EQ(count(plain.program, OperationKind::StitchNumber), 0);
    ASSERT_EQ(count(data.program, OperationKind::StitchNumber), 1);
    const auto number =
        std::ranges::find(data.program.operations, OperationKind::StitchNumber, &machine::Operation::kind);
    EXPECT_EQ(data.machine.loopLengthMm(number->value), plain.machine.defaultLoopLengthMm);
    Project sized = projectFor("shima-swg");
    sized.chart.course(0).stitchNumber = 40;
    EXPECT_EQ(count(dataFor("a.dat", sized).program, OperationKind::StitchNumber), 1) << "as it is";
}

} // namespace
} // namespace knittsim::pattern
