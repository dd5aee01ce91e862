#include "tests/fuzz/checks.h"

#include "core/base/message_table.h"
#include "core/fabric/fabric_builder.h"
#include "core/formats/kcode/reader.h"
#include "core/formats/kcode/writer.h"
#include "core/formats/knitout/reader.h"
#include "core/formats/knitout/writer.h"
#include "core/formats/shima_dat/reader.h"
#include "core/formats/shima_dat/writer.h"
#include "core/formats/text.h"
#include "core/machine/checks/check.h"
#include "tests/support/compare_programs.h"
#include "tests/support/same_meaning.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace knittsim::test {

namespace {

void checkKnitout(const machine::Program& program) {
    const std::string text = formats::knitout::write(program);
    const auto again = formats::knitout::parse(text, "again.k");
    require(again.hasValue(), "written text opens:\n" + text);
    const std::string difference = test::difference(program, again.value());
    require(difference.empty(), "round trip: " + difference + "\n" + text);
}

void checkAgain(const machine::Program& program, const Result<machine::Program>& again, const char* format) {
    require(again.hasValue(), std::string("written ") + format + " opens");
    const std::string difference = differenceInMeaning(program, again.value());
    require(difference.empty(),
            std::string(format) + ": " + difference + "\n" + formats::knitout::write(program));
}

/// Going to a place directly and step by step gives the same machine.
void checkMachine(const machine::Timeline& timeline) {
    const machine::OperationIndex middle = timeline.operationCount() / 2;
    machine::Emulator emulator(timeline.program(), timeline.profile());
    while (emulator.state().nextOperation < middle) {
        emulator.step();
    }
    require(timeline.stateAfter(middle) == emulator.state(), "the timeline replays the machine");
    require(timeline.finalState().loopCount == static_cast<std::int32_t>(timeline.loops().loops.size()),
            "all loops are in the table");
    for (const Diagnostic& found : machine::check(timeline)) {
        require(findMessage(found.id) != nullptr, found.id + " is in the table");
    }
}

void checkFabric(const fabric::Fabric& fabric, std::size_t loopCount) {
    require(fabric.loops.size() == loopCount, "a fabric loop for each loop");
    require(fabric.lengths.size() == fabric.points.size(), "a length for each bonding point");
    for (std::size_t i = 0; i < fabric.points.size(); ++i) {
        require(std::isfinite(fabric.lengths[i]) && fabric.lengths[i] >= 0, "lengths are lengths");
        require(fabric.points[i].entry >= 0 && fabric.points[i].entry < fabric.entryCount, "entries exist");
    }
    for (const Vec3& position : fabric.machinePositions) {
        require(position.allFinite(), "positions are finite");
    }
}

} // namespace

void require(bool condition, const std::string& what) {
    if (!condition) {
        std::fprintf(stderr, "violated: %s\n", what.c_str());
        std::abort();
    }
}

void checkReading(const Result<machine::Program>& result) {
    for (const Diagnostic& found : result.diagnostics()) {
        require(findMessage(found.id) != nullptr, found.id + " is in the table");
        require(found.place.line >= 1 && found.place.column >= 1, found.id + " has a place");
        const std::string line = toLine(found);
        require(line.size() < 500, found.id + " is short");
        require(formats::isUtf8(line), found.id + " is UTF-8");
    }
    require(result.diagnostics().size() <= 200, "findings are bounded");
    require(result.hasValue() != hasErrors(result.diagnostics()), "a program exactly when there is no error");
}

void checkWriters(const machine::Program& program) {
    checkKnitout(program);
    machine::Program kept = program;
    kept.header.position = "Keep"; // so that the needles keep their numbers
    if (const auto dat = formats::shima_dat::write(kept)) {
        checkAgain(kept, formats::shima_dat::parse(dat.value(), "again.dat"), "dat");
    }
    if (const auto kcode = formats::kcode::write(kept, "again.kc")) {
        checkAgain(kept, formats::kcode::parse(kcode.value(), "again.kc"), "kc");
    }
}

void checkMachineAndFabric(machine::Program program) {
    const machine::Timeline timeline(std::move(program), machine::genericProfile());
    checkMachine(timeline);
    checkFabric(fabric::buildFabric(timeline), timeline.loops().loops.size());
    checkFabric(fabric::buildFabric(timeline, timeline.operationCount() / 2),
                static_cast<std::size_t>(timeline.stateAfter(timeline.operationCount() / 2).loopCount));
}

} // namespace knittsim::test
