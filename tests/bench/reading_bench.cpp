#include "core/formats/knitout/reader.h"
#include "core/formats/knitout/writer.h"
#include "tests/support/random_program.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <limits>

namespace {

using namespace knittsim;
using Clock = std::chrono::steady_clock;

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

/// Seconds of one countLines over the text, the best of many.
double referenceSeconds() {
    double best = std::numeric_limits<double>::max();
    for (int i = 0; i < 50; ++i) {
        const auto begin = Clock::now();
        benchmark::DoNotOptimize(countLines(text()));
        best = std::min(best, std::chrono::duration<double>(Clock::now() - begin).count());
    }
    return best;
}

/// Runs the work as often as the library asks, and adds operations per second and the ratio of one run to
/// counting the lines of the same text.
template<class Work> void measure(benchmark::State& state, Work work) {
    static const double reference = referenceSeconds();
    const auto begin = Clock::now();
    for ([[maybe_unused]] auto iteration : state) {
        work();
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
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
