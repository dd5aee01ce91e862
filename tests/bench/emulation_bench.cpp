// The machine and the fabric: time for each operation and each stitch, and as a ratio to one pass over the
// same operations that only adds up needle numbers (the least anybody could do with them).

#include "core/fabric/fabric_builder.h"
#include "core/pattern/swatch.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <sys/resource.h>

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

double peakMemoryMB() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

void buildFrom(benchmark::State& state, machine::Program program) {
    const machine::Timeline timeline(std::move(program), machine::genericProfile());
    std::size_t loops = 0;
    std::size_t crossings = 0;
    const auto start = Clock::now();
    for (auto _ : state) {
        const fabric::Fabric fabric = fabric::buildFabric(timeline);
        loops = fabric.loops.size();
        crossings = fabric.crossings.size();
    }
    const double each = seconds(Clock::now() - start) / static_cast<double>(state.iterations());
    state.SetComplexityN(static_cast<benchmark::IterationCount>(loops));
    state.counters["loops"] = static_cast<double>(loops);
    state.counters["crossings"] = static_cast<double>(crossings);
    state.counters["ns/loop"] = each * 1e9 / static_cast<double>(loops);
    state.counters["ratio to bare sweep"] = each / bareSweep(timeline.program());
    state.counters["peak MB so far"] = peakMemoryMB();
}

void buildTheFabric(benchmark::State& state) {
    const auto side = static_cast<int>(state.range(0));
    buildFrom(state, pattern::makePlain(side, side));
}
BENCHMARK(buildTheFabric)
    ->Arg(32)
    ->Arg(100)
    ->Arg(316)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);

/// Plain with a cable of two and two loops on every six needles, every fourth course.
machine::Program makeCables(int side) {
    using machine::Bed;
    machine::Program program = pattern::makePlain(side, 1);
    const machine::Operation knit = *std::ranges::find_if(program.operations, [](const auto& op) {
        return op.kind == machine::OperationKind::Knit || op.kind == machine::OperationKind::Tuck;
    });
    const auto add = [&](machine::OperationKind kind) -> machine::Operation& {
        program.operations.emplace_back().kind = kind;
        return program.operations.back();
    };
    const auto move = [&](int rack, int first) {
        add(machine::OperationKind::Rack).value = rack;
        for (int needle = 0; needle + 6 <= side; needle += 6) {
            for (int i = 0; i < 2; ++i) {
                machine::Operation& xfer = add(machine::OperationKind::Xfer);
                xfer.needle = {Bed::Rear, needle + first + i};
                xfer.target = {Bed::Front, needle + first + i + rack};
            }
        }
    };
    while (!program.operations.empty() && !carriesYarn(program.operations.back().kind)) {
        program.operations.pop_back(); // the carrier stays in
    }
    for (int course = 1; course < side; ++course) {
        for (int i = 0; i < side; ++i) {
            machine::Operation& op = add(machine::OperationKind::Knit);
            op.direction = course % 2 == 0 ? machine::Direction::Right : machine::Direction::Left;
            op.needle = {Bed::Front, course % 2 == 0 ? i : side - 1 - i};
            op.carriers = knit.carriers;
        }
        if (course % 4 == 0) {
            for (int needle = 0; needle + 6 <= side; needle += 6) {
                for (int i = 0; i < 4; ++i) {
                    machine::Operation& xfer = add(machine::OperationKind::Xfer);
                    xfer.needle = {Bed::Front, needle + i};
                    xfer.target = {Bed::Rear, needle + i};
                }
            }
            move(2, 0);
            move(-2, 2);
            add(machine::OperationKind::Rack).value = 0;
        }
    }
    return program;
}

void buildCables(benchmark::State& state) {
    buildFrom(state, makeCables(static_cast<int>(state.range(0))));
}
BENCHMARK(buildCables)->Arg(32)->Arg(100)->Arg(316)->Unit(benchmark::kMillisecond)->Complexity(benchmark::oN);

} // namespace
