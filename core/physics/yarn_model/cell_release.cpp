#include "core/physics/yarn_model/cell_release.h"

#include "core/physics/yarn_model/cell_load_term.h"

namespace knittsim::physics {

namespace {
/// Of the springs that hold the width, by course, EI/d^3: a cell yields some thousand times more.
constexpr double kHold = 1e3;
} // namespace

MachineHold machineHold(double pitchMm, const YarnUnits& units) {
    return {pitchMm / units.lengthMm, kTakeDownMilliNewton / units.forceMilliNewton()};
}

YarnRelaxReport releaseCell(YarnModel& model, FrictionTerm* friction, Motion& motion, int wales, int courses,
                            const MachineHold& hold, const YarnRelaxOptions& options) {
    auto term = std::make_unique<CellLoadTerm>(model.cellEntry());
    CellLoadTerm& load = *term;
    model.add(std::move(term));
    load.hold(CellLoadTerm::Width, wales * hold.waleSpacing, kHold * courses);
    load.pull(CellLoadTerm::Height, wales * hold.takeDown);
    YarnRelaxReport report = relaxYarns(model, motion, options);

    const double width = load.force(CellLoadTerm::Width, motion.positions);
    const double height = load.force(CellLoadTerm::Height, motion.positions);
    for (int step = 1; step <= hold.steps && isAtRest(report.verdict); ++step) {
        const double share = 1 - static_cast<double>(step) / hold.steps;
        const double left = share * share; // most happens when little is left
        load.pull(CellLoadTerm::Width, left * width);
        load.pull(CellLoadTerm::Height, left * height);
        YarnRelaxReport next = makeLoadStep(model, friction, motion, {.relax = options});
        next.addWork(report);
        report = next;
    }
    return report;
}

} // namespace knittsim::physics
