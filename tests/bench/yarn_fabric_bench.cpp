#include "core/fabric/fabric_builder.h"
#include "core/pattern/swatch.h"
#include "core/simulation/yarn_settling.h"

#include <benchmark/benchmark.h>

#include <ctime>

/// Whole fabrics of plain knit settled in the yarn model.
namespace {

using namespace knittsim;
using simulation::YarnSettling;

constexpr double kNearRest = 1.01; ///< energy over that of the shape of rest
constexpr double kPatience = 30;   ///< CPU seconds for Cash-Karp

double cpuSeconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

fabric::Fabric plain(int side) {
    return fabric::buildFabric(machine::Timeline(pattern::makePlain(side, side), machine::genericProfile()));
}

/// CPU seconds of one evaluation of energy and forces at a shape.
double forceSeconds(const YarnSettling& settling) {
    const physics::YarnModel model(settling.yarns().chains);
    physics::Vector gradient;
    model.evaluate(settling.shape(), &gradient);
    constexpr int kRepeats = 20;
    const double begin = cpuSeconds();
    for (int i = 0; i < kRepeats; ++i) {
        benchmark::DoNotOptimize(model.evaluate(settling.shape(), &gradient));
    }
    return (cpuSeconds() - begin) / kRepeats;
}

void settle(benchmark::State& state) {
    const fabric::Fabric fabric = plain(static_cast<int>(state.range(0)));
    for (auto _ : state) {
        const double start = cpuSeconds();
        benchmark::DoNotOptimize(simulation::guessYarns(fabric, {}));
        const double begin = cpuSeconds();
        state.counters["first_picture_s"] = begin - start;
        YarnSettling settling(fabric, {}, {});
        state.counters["laid_s"] = cpuSeconds() - begin;
        double grown = 0;
        while (settling.step({})) {
            grown = settling.phase() == YarnSettling::Phase::Growing ? cpuSeconds() - begin : grown;
        }
        const double seconds = cpuSeconds() - begin;
        const std::vector<float> positions = entryPositions(fabric, settling.yarns(), settling.shape());
        const int last = static_cast<int>(state.range(0)) - 3;
        const geometry::Measurement inner = geometry::measure(fabric, positions, {2, last, 2, last});
        const simulation::YarnAudit audit = settling.audit();
        state.counters["cpu_s"] = seconds;
        state.counters["growth_s"] = grown;
        state.counters["in_forces"] = seconds / forceSeconds(settling);
        state.counters["nodes"] = settling.yarns().chains.nodeCount();
        state.counters["steps"] = settling.report().steps;
        state.counters["evaluations"] = settling.report().evaluations;
        state.counters["residual"] = settling.report().residual;
        state.counters["overlaps"] = audit.coreOverlaps;
        state.counters["passed"] = static_cast<double>(audit.passThroughs());
        state.counters["kw"] = inner.loopLengthMm / inner.waleSpacingMm;
        state.counters["kc"] = inner.loopLengthMm / inner.courseSpacingMm;
    }
}

/// CPU seconds until the energy is at most `energy`; negative when that was not reached.
double secondsTo(const fabric::Fabric& fabric, const char* integrator, double energy) {
    YarnSettling settling(fabric, {}, {.layout = {}, .integrator = integrator});
    while (settling.phase() == YarnSettling::Phase::Growing) {
        settling.step({});
    }
    const double begin = cpuSeconds();
    while (cpuSeconds() - begin < kPatience) {
        const bool goesOn = settling.step({});
        if (settling.report().steps > 10 && settling.report().energy <= energy) {
            return cpuSeconds() - begin;
        }
        if (!goesOn) {
            break;
        }
    }
    return begin - cpuSeconds();
}

void againstCashKarp(benchmark::State& state) {
    const fabric::Fabric fabric = plain(6);
    for (auto _ : state) {
        YarnSettling rest(fabric, {}, {});
        while (rest.step({})) {
        }
        const double energy = kNearRest * rest.report().energy;
        const double own = secondsTo(fabric, "implicit", energy);
        const double cashKarp = secondsTo(fabric, "cash-karp", energy);
        state.counters["cpu_s"] = own;
        state.counters["reached"] = cashKarp > 0 ? 1 : 0;
        state.counters["of_cash_karp"] = own / std::abs(cashKarp); // at most, where it was not reached
    }
}

BENCHMARK(settle)->Arg(12)->Arg(30)->Arg(60)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(againstCashKarp)->Iterations(1)->Unit(benchmark::kMillisecond);

} // namespace
