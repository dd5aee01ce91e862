#include "core/formats/knitout/reader.h"
#include "core/formats/knitout/writer.h"
#include "tests/support/random_program.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>

namespace {

using namespace knittsim;

const machine::Program& program() {
    static const machine::Program program = test::randomProgram(
        {.seed = 7, .operations = 100'000, .firstNeedle = -100, .width = 200, .carriers = 6});
    return program;
}

const std::string& text() {
    static const std::string text = formats::knitout::write(program());
    return text;
}

/// The least that any reader must do: look at every byte once.
std::ptrdiff_t countLines(std::string_view bytes) {
    return std::count(bytes.begin(), bytes.end(), '\n');
}

/// Processor time of this program, seconds: other programs on the machine do not change it.
double processorSeconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Seconds of one countLines over the text.
double referenceSeconds() {
    constexpr int kRuns = 200;
    const double begin = processorSeconds();
    for (int i = 0; i < kRuns; ++i) {
        benchmark::DoNotOptimize(countLines(text()));
    }
    return (processorSeconds() - begin) / kRuns;
}

/// Runs the work as often as the library asks, and adds operations per second and the ratio of one run to
/// counting the lines of the same text.
template<class Work> void measure(benchmark::State& state, Work work) {
    countLines(text()); // makes the text before the clock runs
    static const double reference = referenceSeconds();
    const double begin = processorSeconds();
    for ([[maybe_unused]] auto iteration : state) {
        work();
    }
    const double seconds = processorSeconds() - begin;
    const auto operations = static_cast<double>(program().operations.size());
    state.counters["operations"] = operations;
    state.counters["operations_per_second"] =
        benchmark::Counter(operations, benchmark::Counter::kIsIterationInvariantRate);
    state.counters["times_counting_lines"] = seconds / static_cast<double>(state.iterations()) / reference;
    state.SetBytesProcessed(static_cast<std::int64_t>(text().size()) * state.iterations());
}

void countLinesOfText(benchmark::State& state) {
    measure(state, [] { benchmark::DoNotOptimize(countLines(text())); });
}

void readKnitout(benchmark::State& state) {
    measure(state, [&] {
        auto result = formats::knitout::parse(text(), "bench.k");
        if (!result) {
            state.SkipWithError("the program does not open");
        }
        benchmark::DoNotOptimize(result);
    });
}

void writeKnitout(benchmark::State& state) {
    measure(state, [] {
        auto written = formats::knitout::write(program());
        benchmark::DoNotOptimize(written);
    });
}

BENCHMARK(countLinesOfText)->Unit(benchmark::kMillisecond);
BENCHMARK(readKnitout)->Unit(benchmark::kMillisecond);
BENCHMARK(writeKnitout)->Unit(benchmark::kMillisecond);

} // namespace
