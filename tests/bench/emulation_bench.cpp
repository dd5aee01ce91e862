// The machine and the fabric: time for each operation and each stitch, and as a ratio to one pass over the
// same operations that only adds up needle numbers (the least anybody could do with them).

#include "core/fabric/fabric_builder.h"
#include "core/pattern/swatch.h"

#include <benchmark/benchmark.h>

#include <chrono>

namespace {

using namespace knittsim;
using Clock = std::chrono::steady_clock;

double seconds(Clock::duration time) {
    return std::chrono::duration<double>(time).count();
}

/// Seconds for one bare pass over the operations, measured in the same run.
double bareSweep(const machine::Program& program) {
    const auto start = Clock::now();
    for (int repeat = 0; repeat < 10; ++repeat) {
        std::int64_t sum = 0;
        for (const machine::Operation& op : program.operations) {
            sum += op.needle.index;
        }
        benchmark::DoNotOptimize(sum);
    }
    return seconds(Clock::now() - start) / 10;
}

void emulate(benchmark::State& state) {
    const auto side = static_cast<int>(state.range(0));
    const machine::Program program = pattern::makePlain(side, side);
    const machine::MachineProfile profile = machine::genericProfile();
    const auto start = Clock::now();
    for (auto _ : state) {
        machine::Emulator emulator(program, profile);
        while (!emulator.atEnd()) {
            emulator.step();
        }
        benchmark::DoNotOptimize(emulator.state().loopCount);
    }
    const double each = seconds(Clock::now() - start) / static_cast<double>(state.iterations());
    state.counters["operations"] = static_cast<double>(program.operations.size());
    state.counters["ns/operation"] = each * 1e9 / static_cast<double>(program.operations.size());
    state.counters["ratio to bare sweep"] = each / bareSweep(program);
}
BENCHMARK(emulate)->Arg(100)->Arg(316)->Unit(benchmark::kMillisecond);

/// The machine after an operation somewhere in the middle, as scrubbing asks for it.
void anyMoment(benchmark::State& state) {
    const machine::Timeline timeline(pattern::makePlain(316, 316), machine::genericProfile());
    const machine::OperationIndex count = timeline.operationCount();
    machine::OperationIndex at = 0;
    for (auto _ : state) {
        at = (at + 37619) % count;
        benchmark::DoNotOptimize(timeline.stateAfter(at).loopCount);
    }
    state.counters["operations"] = static_cast<double>(count);
    state.counters["keyframes"] = static_cast<double>(timeline.keyframeCount());
}
BENCHMARK(anyMoment)->Unit(benchmark::kMillisecond);

void buildTheFabric(benchmark::State& state) {
    const auto side = static_cast<int>(state.range(0));
    const machine::Timeline timeline(pattern::makePlain(side, side), machine::genericProfile());
    const auto start = Clock::now();
    for (auto _ : state) {
        benchmark::DoNotOptimize(fabric::buildFabric(timeline).entryCount);
    }
    const double each = seconds(Clock::now() - start) / static_cast<double>(state.iterations());
    const double stitches = static_cast<double>(side) * side;
    state.counters["stitches"] = stitches;
    state.counters["ns/stitch"] = each * 1e9 / stitches;
    state.counters["ratio to bare sweep"] = each / bareSweep(timeline.program());
}
BENCHMARK(buildTheFabric)->Arg(32)->Arg(100)->Arg(316)->Unit(benchmark::kMillisecond);

} // namespace
