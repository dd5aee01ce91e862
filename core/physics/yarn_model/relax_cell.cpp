#include "core/physics/yarn_model/relax_cell.h"

#include "core/physics/yarn_model/axis_term.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace knittsim::physics {

namespace {

/// Pull to the middle plane, by yarn of each node.
AxisTerm flatteningTerm(const YarnChains& chains, double stiffness) {
    const std::vector<double> yarn = nodeLengths(chains);
    std::vector<AxisTerm::Spring> springs;
    springs.reserve(yarn.size());
    for (const double length : yarn) {
        springs.push_back({static_cast<Entry>(springs.size()), 2, 0, stiffness * length});
    }
    return AxisTerm(std::move(springs));
}

double meanOf(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The proportions that the machine gives a loop.
KnitCellStart startOf(const CellOptions& options, double loopLength) {
    KnitCellStart start = options.start;
    if (options.machine) {
        start.widthFactor = loopLength / options.machine->waleSpacing;
        start.heightFactor = 1.25 * start.widthFactor;
    }
    start.widthFactor /= options.wider;
    start.heightFactor /= options.higher;
    return start;
}

template<class Same> int smallestPeriod(int size, Same same) {
    for (int period = 1; period < size; ++period) {
        if (size % period == 0 && same(period)) {
            return period;
        }
    }
    return size;
}

} // namespace

CellShape relaxCell(const KnitPurl& pattern, const std::vector<double>& loopLengths, const RodYarn& yarn,
                    const CellOptions& options) {
    CellShape result;
    result.loopLength = meanOf(loopLengths);
    result.nodesPerLoop = options.start.nodesPerLoop;
    result.chains = knitCell(pattern, loopLengths, yarn, startOf(options, result.loopLength));
    YarnModel model(result.chains);
    if (options.flattening > 0) {
        model.add(std::make_unique<AxisTerm>(flatteningTerm(result.chains, options.flattening)));
    }
    const Vector start = result.chains.start();
    Motion motion{start, Vector::Zero(start.size()), 0};
    FrictionTerm* const friction = options.machine ? addFriction(model, result.chains) : nullptr;
    result.relax = options.machine ? releaseCell(model, friction, motion, pattern.wales, pattern.courses,
                                                 *options.machine, options.relax)
                                   : relaxYarns(model, motion, options.relax);
    if (yarn.set > 0 && isAtRest(result.relax.verdict)) {
        model.takeSet(motion.positions);
        result.chains.restCurvature = model.bend().restCurvatures();
        const YarnRelaxReport before = result.relax;
        result.relax = makeLoadStep(model, friction, motion, {.relax = options.relax});
        result.relax.addWork(before);
    }
    result.shape = motion.positions;
    result.energy = model.elasticEnergy(result.shape);
    result.faults = findLoopFaults(pattern, result.chains, result.shape, options.start.nodesPerLoop);

    const auto size = at(result.shape, model.cellEntry());
    result.waleSpacing = size.x() / pattern.wales;
    result.courseSpacing = size.y() / pattern.courses;
    const Eigen::Map<const Eigen::Matrix3Xd> nodes(result.shape.data(), 3, model.nodeCount());
    result.thickness = nodes.row(2).maxCoeff() - nodes.row(2).minCoeff() + yarn.outerDiameter;
    return result;
}

Repeat smallestRepeat(const KnitPurl& pattern, const std::vector<double>& loopLengths) {
    const auto length = [&](int wale, int course) {
        return loopLengths[static_cast<std::size_t>(course % pattern.courses * pattern.wales +
                                                    wale % pattern.wales)];
    };
    const auto sameShifted = [&](int right, int up) {
        for (int course = 0; course < pattern.courses; ++course) {
            for (int wale = 0; wale < pattern.wales; ++wale) {
                const double here = length(wale, course);
                if (pattern.at(wale, course) != pattern.at(wale + right, course + up) ||
                    std::abs(here - length(wale + right, course + up)) > 1e-9 * here) {
                    return false;
                }
            }
        }
        return true;
    };
    Repeat repeat;
    repeat.pattern = {smallestPeriod(pattern.wales, [&](int p) { return sameShifted(p, 0); }),
                      smallestPeriod(pattern.courses, [&](int p) { return sameShifted(0, p); }),
                      {}};
    for (int course = 0; course < repeat.pattern.courses; ++course) {
        for (int wale = 0; wale < repeat.pattern.wales; ++wale) {
            repeat.pattern.faces.push_back(pattern.at(wale, course));
            repeat.loopLengths.push_back(length(wale, course));
        }
    }
    return repeat;
}

} // namespace knittsim::physics
