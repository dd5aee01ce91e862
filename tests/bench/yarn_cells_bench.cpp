#include "core/fabric/fabric_builder.h"
#include "core/pattern/compile.h"
#include "core/pattern/swatch.h"
#include "core/physics/yarn_model/fabric_repeat.h"
#include "core/physics/yarn_model/yarn_units.h"
#include "core/yarn/yarn_library.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>
#include <random>
#include <string>

/// Repeats of knit and purl settled as periodic cells of the yarn model: work in evaluations of forces and in
/// times of one such evaluation, and spacings relative to plain knit in the same run.
namespace {

using namespace knittsim;
using physics::CellShape;
using physics::KnitPurl;
using physics::RodYarn;

double cpuSeconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// The acrylic of PHYSICS-REFERENCE 2.4.
RodYarn acrylic() {
    RodYarn yarn;
    yarn.coreDiameter = 0.44;
    yarn.contactStiffness = physics::kContactStiffness;
    return yarn;
}

CellShape settle(const KnitPurl& pattern, double loopLength, const RodYarn& yarn, const char* integrator) {
    physics::CellOptions options;
    options.relax.integrator = integrator;
    return relaxCell(pattern, std::vector<double>(pattern.faces.size(), loopLength), yarn, options);
}

/// CPU seconds of one evaluation of energy and forces at a cell's shape of rest.
double forceSeconds(const CellShape& cell) {
    const physics::YarnModel model(cell.chains);
    physics::Vector gradient;
    constexpr int kRepeats = 50;
    const double begin = cpuSeconds();
    for (int i = 0; i < kRepeats; ++i) {
        benchmark::DoNotOptimize(model.evaluate(cell.shape, &gradient));
    }
    return (cpuSeconds() - begin) / kRepeats;
}

void report(benchmark::State& state, const CellShape& cell, double seconds) {
    state.counters["cpu_s"] = seconds;
    state.counters["in_forces"] = seconds / forceSeconds(cell);
    state.counters["evaluations"] = cell.relax.evaluations;
    state.counters["verdict"] = static_cast<double>(cell.relax.verdict);
    state.counters["residual"] = cell.relax.residual;
    state.counters["overlaps"] = cell.relax.audit.coreOverlaps;
    state.counters["faults"] = static_cast<double>(cell.faults.size());
    state.counters["kw"] = cell.loopLength / cell.waleSpacing;
    state.counters["kc"] = cell.loopLength / cell.courseSpacing;
}

void settlePlain(benchmark::State& state, const char* integrator) {
    const auto side = static_cast<int>(state.range(0));
    const KnitPurl pattern{side, side, std::vector<int>(static_cast<std::size_t>(side * side), 1)};
    for (auto _ : state) {
        const double begin = cpuSeconds();
        const CellShape cell = settle(pattern, 8, acrylic(), integrator);
        const double seconds = cpuSeconds() - begin;
        report(state, cell, seconds);
    }
}

/// A cell from a wide, low and from a narrow, high first curve: from(wider, higher).
template<class From> void settleFromBoth(benchmark::State& state, const From& from) {
    const double begin = cpuSeconds();
    const CellShape wide = from(1.15, 0.95);
    const double seconds = cpuSeconds() - begin;
    report(state, wide, seconds);
    const CellShape narrow = from(0.85, 1.05);
    state.counters["faults_of_other"] = static_cast<double>(narrow.faults.size());
    state.counters["wale_of_other"] = narrow.waleSpacing / wide.waleSpacing;
    state.counters["course_of_other"] = narrow.courseSpacing / wide.courseSpacing;
}

/// Plain knit of a tightness factor (sqrt(tex) / loop length in mm, in tenths), off the machine, from a wide
/// and from a narrow first curve; without friction the first curve is all that it comes from.
void settleTightness(benchmark::State& state, bool rough) {
    const yarn::Yarn yarn;
    const double loopLength = std::sqrt(yarn.tex) * 10 / static_cast<double>(state.range(0));
    const physics::YarnUnits units = physics::unitsOf(yarn);
    const auto from = [&](double wider, double higher) {
        physics::CellOptions options;
        options.wider = wider;
        options.higher = higher;
        options.relax.residual = 2e-4;
        if (rough) {
            options.machine = physics::machineHold(machine::genericProfile().pitchMm(), units);
        }
        return relaxCell({2, 2, {1, 1, 1, 1}}, std::vector<double>(4, loopLength / units.lengthMm),
                         physics::toRod(yarn, units), options);
    };
    for (auto _ : state) {
        settleFromBoth(state, from);
        state.counters["kc_of_kw"] = state.counters["kc"] / state.counters["kw"];
    }
}

/// Random knit and purl, 8 x 8, fed and let go by our machine, from a wide, low and a narrow, high first
/// curve. The number is that of the cell.
void settleRandom(benchmark::State& state) {
    constexpr int kSide = 8;
    std::mt19937 random(static_cast<std::mt19937::result_type>(state.range(0)));
    pattern::Chart chart = pattern::plainChart(2 * kSide + 2, 2 * kSide + 2);
    for (int course = 0; course < chart.height(); ++course) {
        for (int wale = 0; wale < chart.width; ++wale) {
            const bool first = course < kSide && wale < kSide;
            chart.at(wale, course).stitch =
                first ? (random() % 2 == 0 ? pattern::Stitch::Knit : pattern::Stitch::Purl)
                      : chart.at(wale % kSide, course % kSide).stitch;
        }
    }
    const auto program = pattern::compile(chart, {.castOn = pattern::CastOn::Open});
    const machine::Timeline timeline(program.value(), machine::genericProfile());
    const auto found = physics::findFabricRepeat(fabric::buildFabric(timeline));
    const yarn::Yarn yarn;
    const physics::YarnUnits units = physics::unitsOf(yarn);
    std::vector<double> lengths = found->repeat.loopLengths;
    for (double& l : lengths) {
        l /= units.lengthMm;
    }
    const auto from = [&](double wider, double higher) {
        physics::CellOptions options;
        options.wider = wider;
        options.higher = higher;
        options.machine = physics::machineHold(machine::genericProfile().pitchMm(), units);
        return relaxCell(found->repeat.pattern, lengths, physics::toRod(yarn, units), options);
    };
    for (auto _ : state) {
        settleFromBoth(state, from);
        state.counters["stitches"] = static_cast<double>(lengths.size());
    }
}

struct Swatch {
    const char* name;
    machine::Program program;
};

enum class As : std::uint8_t {
    SameLength, ///< the same yarn for every stitch, no friction
    Fed,        ///< with the yarn from bed to bed, no friction
    Released,   ///< and let go from the machine under friction
};

/// The measured swatches of PHYSICS 3: one yarn, one stitch size, as our machine feeds them.
void settleSwatch(benchmark::State& state, const Swatch& swatch, As as) {
    const auto library = yarn::YarnLibrary::read(KNITTSIM_SOURCE_DIR "/resources/yarns");
    const yarn::Yarn* yarn = library ? library.value().find("acrylic-hb-2-28") : nullptr;
    if (yarn == nullptr) {
        state.SkipWithError("no yarn");
        return;
    }
    machine::MachineProfile profile = machine::genericProfile();
    profile.defaultLoopLengthMm = 6.8; // 60 wales in 99 mm and kw = 4.1
    const auto cellOf = [&](const machine::Program& program) {
        const machine::Timeline timeline(program, profile);
        const auto found = physics::findFabricRepeat(fabric::buildFabric(timeline));
        const physics::YarnUnits units = physics::unitsOf(*yarn);
        std::vector<double> lengths = found->repeat.loopLengths;
        for (double& l : lengths) {
            l = (as == As::SameLength ? profile.defaultLoopLengthMm : l) / units.lengthMm;
        }
        physics::CellOptions options;
        if (as == As::Released) {
            options.machine = physics::machineHold(profile.pitchMm(), units);
        }
        return relaxCell(found->repeat.pattern, lengths, physics::toRod(*yarn, units), options);
    };
    const CellShape plain = cellOf(pattern::makePlain(14, 12));
    for (auto _ : state) {
        const double begin = cpuSeconds();
        const CellShape cell = cellOf(swatch.program);
        const double seconds = cpuSeconds() - begin;
        report(state, cell, seconds);
        state.counters["width"] = cell.waleSpacing / plain.waleSpacing;
        state.counters["height"] = cell.courseSpacing / plain.courseSpacing;
        state.counters["wale_mm"] = cell.waleSpacing * yarn->outerDiameterMm;
        state.counters["course_mm"] = cell.courseSpacing * yarn->outerDiameterMm;
        state.counters["loop_mm"] = cell.loopLength * yarn->outerDiameterMm;
    }
}

BENCHMARK_CAPTURE(settleTightness, off_the_machine, true)
    ->Arg(12)
    ->Arg(14)
    ->Arg(16)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(settleTightness, without_friction, false)
    ->Arg(12)
    ->Arg(14)
    ->Arg(16)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

BENCHMARK(settleRandom)->DenseRange(1, 20)->Iterations(1)->Unit(benchmark::kMillisecond);

const bool kRegistered = [] {
    for (const char* id : {"newton-cg", "fire", "l-bfgs"}) {
        for (const int side : {1, 4, 8}) {
            // L-BFGS loses the symmetry of large cells and then needs some twenty seconds.
            if (side < 8 || std::string(id) != "l-bfgs") {
                benchmark::RegisterBenchmark(("plain_cell/" + std::string(id)).c_str(), settlePlain, id)
                    ->Arg(side)
                    ->Iterations(1)
                    ->Unit(benchmark::kMillisecond);
            }
        }
    }
    const std::vector<Swatch> swatches{
        {"plain", pattern::makePlain(14, 12)}, {"garter", pattern::makeGarter(14, 12)},
        {"rib", pattern::makeRib(14, 12)},     {"rib2", pattern::makeRib(14, 12, 2, 2)},
        {"seed", pattern::makeSeed(14, 12)},   {"moss", pattern::makeMoss(14, 12)},
    };
    for (const auto& [title, as] : {std::pair{"same_length/", As::SameLength}, std::pair{"fed/", As::Fed},
                                    std::pair{"released/", As::Released}}) {
        for (const Swatch& swatch : swatches) {
            const std::string name = title + std::string(swatch.name);
            benchmark::RegisterBenchmark(name.c_str(), settleSwatch, swatch, as)
                ->Iterations(1)
                ->Unit(benchmark::kMillisecond);
        }
    }
    return true;
}();

} // namespace
