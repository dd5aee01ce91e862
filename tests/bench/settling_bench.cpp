#include "core/fabric/fabric_builder.h"
#include "core/pattern/swatch.h"
#include "core/physics/bonding_point_model.h"
#include "core/physics/integrator.h"
#include "core/physics/stop_rule.h"

#include <benchmark/benchmark.h>

#include <ctime>
#include <map>
#include <string>

/// From the machine's positions to rest. Counts of work, and the ratio to a reference measured in the same
/// process: Cash-Karp on the same 20 x 20 swatch to a residual of 0.1 for the small nets; the first forces of
/// the net themselves for the large ones (how many evaluations' worth of time a settling takes).
namespace {

using namespace knittsim;
using physics::StopRule;

struct Outcome {
    double seconds = 0;
    double evaluations = 0;
    double steps = 0;
    double residual = 0;
};

double cpuSeconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

fabric::Fabric plain(int size) {
    return fabric::buildFabric(machine::Timeline(pattern::makePlain(size, size), machine::genericProfile()));
}

Outcome settle(const fabric::Fabric& fabric, const std::string& id, double limit) {
    const double begin = cpuSeconds();
    const physics::BondingPointModel net = physics::buildBondingPointModel(fabric, {});
    physics::Motion motion{physics::machinePositions(fabric), physics::Vector::Zero(net.model->size()), 0};
    StopRule rule;
    rule.setLimit(limit);
    rule.setReference(*net.model, motion.positions);
    const auto integrator = physics::makeIntegrator(id);
    integrator->initialise(*net.model, motion);
    Outcome outcome;
    StopRule::Verdict verdict = StopRule::Verdict::GoOn;
    while (verdict == StopRule::Verdict::GoOn) {
        const physics::StepReport report = integrator->step(motion, {});
        verdict = rule.judge(report, motion.positions, integrator->takesLargeSteps());
        outcome.evaluations += report.evaluations;
        outcome.steps += 1;
        outcome.residual = rule.residual(report.forceNorm);
    }
    outcome.seconds = cpuSeconds() - begin;
    return outcome;
}

/// CPU seconds of Cash-Karp on a plain swatch of this size to residual 0.1.
double cashKarpSeconds(int size) {
    static std::map<int, double> known;
    const auto found = known.find(size);
    if (found != known.end()) {
        return found->second;
    }
    return known[size] = settle(plain(size), "cash-karp", 0.1).seconds;
}

double forceSeconds(const fabric::Fabric& fabric) {
    const physics::BondingPointModel net = physics::buildBondingPointModel(fabric, {});
    const physics::Vector x = physics::machinePositions(fabric);
    physics::Vector gradient;
    constexpr int kRepeats = 10;
    const double begin = cpuSeconds();
    for (int i = 0; i < kRepeats; ++i) {
        benchmark::DoNotOptimize(net.model->evaluate(x, &gradient));
    }
    return (cpuSeconds() - begin) / kRepeats;
}

void report(benchmark::State& state, const Outcome& outcome) {
    state.counters["cpu_s"] = outcome.seconds;
    state.counters["evaluations"] = outcome.evaluations;
    state.counters["steps"] = outcome.steps;
    state.counters["residual"] = outcome.residual;
}

void againstCashKarp(benchmark::State& state, const char* id, double limit) {
    const fabric::Fabric fabric = plain(20);
    const double reference = cashKarpSeconds(20);
    Outcome outcome;
    for (auto _ : state) {
        outcome = settle(fabric, id, limit);
    }
    report(state, outcome);
    state.counters["of_cash_karp_to_0.1"] = outcome.seconds / reference;
}

/// 100 x 100 stitches to 1e-3: the figure to reach.
void figure(benchmark::State& state, const char* id) {
    const fabric::Fabric fabric = plain(100);
    const double force = forceSeconds(fabric);
    Outcome outcome;
    for (auto _ : state) {
        outcome = settle(fabric, id, 1e-3);
    }
    report(state, outcome);
    state.counters["in_forces"] = outcome.seconds / force;
}

const bool kRegistered = [] {
    for (const physics::IntegratorKind& kind : physics::integratorKinds()) {
        const std::string id = kind.id;
        benchmark::RegisterBenchmark(("settle_20x20_to_1e-3/" + id).c_str(), againstCashKarp, kind.id, 1e-3)
            ->Unit(benchmark::kMillisecond)
            ->MeasureProcessCPUTime();
    }
    for (const char* id : {"newton-cg", "kinsol", "fire", "l-bfgs"}) {
        benchmark::RegisterBenchmark(("settle_100x100_to_1e-3/" + std::string(id)).c_str(), figure, id)
            ->Unit(benchmark::kMillisecond)
            ->MeasureProcessCPUTime()
            ->Iterations(1);
    }
    return true;
}();

} // namespace
