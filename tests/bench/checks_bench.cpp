// The checks of the machine: time for 50,000 operations, each operation, and as a ratio to emulating the same
// program without checking it.

#include "core/machine/checks/check.h"
#include "core/pattern/swatch.h"
#include "tests/support/random_program.h"

#include <benchmark/benchmark.h>

#include <chrono>

namespace {

using namespace knittsim;
using Clock = std::chrono::steady_clock;

constexpr int kOperations = 50'000;

double seconds(Clock::duration time) {
    return std::chrono::duration<double>(time).count();
}

double emulation(const machine::Program& program, const machine::MachineProfile& profile) {
    const auto start = Clock::now();
    for (int repeat = 0; repeat < 10; ++repeat) {
        machine::Emulator emulator(program, profile);
        while (!emulator.atEnd()) {
            emulator.step();
        }
        benchmark::DoNotOptimize(emulator.state().loopCount);
    }
    return seconds(Clock::now() - start) / 10;
}

/// All that the command does after reading: the timeline and the checks.
void checkProgram(benchmark::State& state, const machine::Program& program) {
    const machine::MachineProfile profile = machine::genericProfile();
    std::size_t findings = 0;
    const auto start = Clock::now();
    for (auto _ : state) {
        findings = machine::check(machine::Timeline(program, profile)).size();
    }
    const double each = seconds(Clock::now() - start) / static_cast<double>(state.iterations());
    const auto operations = static_cast<double>(program.operations.size());
    state.counters["operations"] = operations;
    state.counters["findings"] = static_cast<double>(findings);
    state.counters["ns/operation"] = each * 1e9 / operations;
    state.counters["ms for 50,000"] = each * 1e3 * kOperations / operations;
    state.counters["ratio to emulating"] = each / emulation(program, profile);
}

void checkPlain(benchmark::State& state) {
    checkProgram(state, pattern::makePlain(250, 200));
}
BENCHMARK(checkPlain)->Unit(benchmark::kMillisecond);

/// Every kind of operation on two beds.
void checkRandom(benchmark::State& state) {
    checkProgram(state, test::randomProgram({.seed = 5, .operations = kOperations}));
}
BENCHMARK(checkRandom)->Unit(benchmark::kMillisecond);

/// The worst for the rule that looks at racks: a rib of 250 needles, then nothing but racks.
void checkRacks(benchmark::State& state) {
    machine::Program program = pattern::makePlain(250, 1);
    for (std::size_t i = 0; i < program.operations.size(); i += 2) {
        program.operations[i].needle.bed = machine::Bed::Rear;
    }
    for (int i = 0; program.operations.size() < kOperations; ++i) {
        machine::Operation& rack = program.operations.emplace_back();
        rack.kind = machine::OperationKind::Rack;
        rack.value = i % 2 == 0 ? 1 : 0;
    }
    checkProgram(state, program);
}
BENCHMARK(checkRacks)->Unit(benchmark::kMillisecond);

} // namespace
