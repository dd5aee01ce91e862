#include "core/base/message_table.h"
#include "core/fabric/fabric_builder.h"
#include "core/formats/knitout/reader.h"
#include "core/formats/knitout/writer.h"
#include "core/formats/text.h"
#include "core/machine/timeline.h"
#include "tests/support/compare_programs.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace {

using namespace knittsim;

void require(bool condition, const std::string& what) {
    if (!condition) {
        std::fprintf(stderr, "violated: %s\n", what.c_str());
        std::abort();
    }
}

void checkFindings(const Diagnostics& diagnostics) {
    for (const Diagnostic& found : diagnostics) {
        require(findMessage(found.id) != nullptr, found.id + " is in the table");
        require(found.place.line >= 1 && found.place.column >= 1, found.id + " has a place");
        const std::string line = toLine(found);
        require(line.size() < 500, found.id + " is short");
        require(formats::isUtf8(line), found.id + " is UTF-8");
    }
    require(diagnostics.size() <= 200, "findings are bounded");
}

void checkRoundTrip(const machine::Program& program) {
    const std::string text = formats::knitout::write(program);
    const auto again = formats::knitout::parse(text, "again.k");
    require(again.hasValue(), "written text opens:\n" + text);
    const std::string difference = test::difference(program, again.value());
    require(difference.empty(), "round trip: " + difference + "\n" + text);
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
    for (const Diagnostic& found : timeline.diagnostics()) {
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

/// Any bytes: the reader gives findings or a program; every program survives writing, the machine and the
/// fabric.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    auto result = formats::knitout::parse(text, "fuzz.k");
    checkFindings(result.diagnostics());
    require(result.hasValue() != hasErrors(result.diagnostics()), "a program exactly when there is no error");
    if (!result) {
        return 0;
    }
    checkRoundTrip(result.value());
    const machine::Timeline timeline(std::move(result).value(), machine::genericProfile());
    checkMachine(timeline);
    checkFabric(fabric::buildFabric(timeline), timeline.loops().loops.size());
    checkFabric(fabric::buildFabric(timeline, timeline.operationCount() / 2),
                static_cast<std::size_t>(timeline.stateAfter(timeline.operationCount() / 2).loopCount));
    return 0;
}
