#include "core/fabric/fabric_builder.h"
#include "core/pattern/swatch.h"
#include "core/simulation/yarn_settling.h"

#include <benchmark/benchmark.h>

#include <cmath>
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

fabric::Fabric plain(int side, double loopLengthMm = machine::MachineProfile().defaultLoopLengthMm) {
    machine::MachineProfile profile = machine::genericProfile();
    profile.defaultLoopLengthMm = loopLengthMm;
    return fabric::buildFabric(machine::Timeline(pattern::makePlain(side, side), profile));
}

/// Without two wales and courses at each edge.
geometry::Measurement measureInner(const fabric::Fabric& fabric, const YarnSettling& settling, int side) {
    const std::vector<float> positions = entryPositions(fabric, settling.yarns(), settling.shape());
    return geometry::measure(fabric, positions, {2, side - 3, 2, side - 3});
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
        const geometry::Measurement inner = measureInner(fabric, settling, static_cast<int>(state.range(0)));
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

/// Plain knit of a tightness factor (sqrt(tex) / loop length in mm, in tenths), 30 x 30, from a wide and from
/// a narrow start.
void settleTightness(benchmark::State& state) {
    constexpr int kSide = 30;
    const double loopLength = std::sqrt(yarn::Yarn().tex) * 10 / static_cast<double>(state.range(0));
    const fabric::Fabric fabric = plain(kSide, loopLength);
    for (auto _ : state) {
        double wale[2] = {0, 0};
        double course[2] = {0, 0};
        for (const int narrow : {0, 1}) {
            YarnSettling::Options options;
            options.layout.wider = narrow != 0 ? 0.94 : 1.12;
            options.layout.higher = narrow != 0 ? 1.1 : 0.95;
            YarnSettling settling(fabric, {}, options);
            while (settling.step({})) {
            }
            const geometry::Measurement inner = measureInner(fabric, settling, kSide);
            wale[narrow] = inner.waleSpacingMm;
            course[narrow] = inner.courseSpacingMm;
            state.counters["residual"] = settling.report().residual;
            state.counters["passed"] = static_cast<double>(settling.audit().passThroughs());
        }
        state.counters["kw"] = loopLength / wale[0];
        state.counters["kc"] = loopLength / course[0];
        state.counters["kc_of_kw"] = wale[0] / course[0];
        state.counters["wale_of_other"] = wale[1] / wale[0];
        state.counters["course_of_other"] = course[1] / course[0];
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
    const fabric::Fabric fabric = plain(static_cast<int>(state.range(0)));
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
BENCHMARK(settleTightness)->Arg(12)->Arg(14)->Arg(16)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(againstCashKarp)->Arg(6)->Arg(16)->Iterations(1)->Unit(benchmark::kMillisecond);

} // namespace
