#include "core/simulation/surroundings.h"

#include "core/physics/plate_term.h"
#include "core/physics/yarn_model/floor_term.h"
#include "core/physics/yarn_model/gravity_term.h"

#include <algorithm>
#include <array>
#include <limits>

namespace knittsim::simulation {

namespace {

using physics::Entry;

constexpr double kPlates = 0.1; ///< stiffness against that of a segment
constexpr double kFloor = 10;

/// By node, EI/d^2.
std::vector<double> weights(const FabricYarns& yarns) {
    std::vector<double> result = physics::nodeLengths(yarns.chains);
    for (const physics::Chain& chain : yarns.chains.chains) {
        for (Entry e = chain.first; e < chain.first + chain.count; ++e) {
            result[static_cast<std::size_t>(e)] *= yarns.weightOfYarn[static_cast<std::size_t>(chain.yarn)];
        }
    }
    return result;
}

std::vector<double> radii(const FabricYarns& yarns) {
    std::vector<double> result(static_cast<std::size_t>(yarns.chains.nodeCount()), 0);
    for (const physics::Chain& chain : yarns.chains.chains) {
        const double radius = 0.5 * yarns.chains.yarns[static_cast<std::size_t>(chain.yarn)].outerDiameter;
        std::fill_n(result.begin() + chain.first, chain.count, radius);
    }
    return result;
}

void pin(physics::YarnModel& model, const std::vector<Entry>& nodes) {
    for (const Entry e : nodes) {
        model.setPinned(e, true);
    }
}

} // namespace

std::span<const SurroundingsInfo> surroundingsKinds() {
    static constexpr std::array kKinds{
        SurroundingsInfo{Surroundings::Flat, "flat", "Pressed flat",
                         "Between two soft plates, as swatches are measured; edges cannot curl"},
        SurroundingsInfo{Surroundings::Table, "table", "On a table", "Its weight on a plane; edges may curl"},
        SurroundingsInfo{Surroundings::Hanging, "hanging", "Hanging",
                         "Its weight pulls at the last course, which is held"},
        SurroundingsInfo{Surroundings::Pinned, "pinned", "Pinned at the edges",
                         "The loops at its edges stay where they are"},
        SurroundingsInfo{Surroundings::Free, "free", "Free",
                         "Nothing holds it and it is shaken: no friction, edges curl"}};
    return kKinds;
}

std::vector<Entry> edgeNodes(const fabric::Fabric& fabric, const FabricYarns& yarns) {
    std::vector<Entry> nodes;
    for (const fabric::YarnCourse& course : fabric.courses) {
        if (course.count > 0) {
            nodes.push_back(yarns.nodeOfPoint[static_cast<std::size_t>(course.first)]);
            nodes.push_back(yarns.nodeOfPoint[static_cast<std::size_t>(course.first + course.count - 1)]);
        }
    }
    std::erase_if(nodes, [](Entry e) { return e < 0; });
    nodes.insert(nodes.end(), yarns.onComb.begin(), yarns.onComb.end());
    nodes.insert(nodes.end(), yarns.onHolder.begin(), yarns.onHolder.end());
    return nodes;
}

std::vector<Entry> topNodes(const fabric::Fabric& fabric, const FabricYarns& yarns) {
    if (!yarns.onHolder.empty()) {
        return yarns.onHolder;
    }
    std::vector<Entry> nodes;
    for (std::size_t e = 0; e < yarns.piece.size(); ++e) {
        const auto loop =
            static_cast<std::size_t>(fabric.points[static_cast<std::size_t>(yarns.piece[e])].loop);
        if (fabric.loops[loop].course == fabric.courseCount - 1) {
            nodes.push_back(static_cast<Entry>(e));
        }
    }
    return nodes;
}

void surround(physics::YarnModel& model, const fabric::Fabric& fabric, const FabricYarns& yarns,
              const physics::Vector& x, Surroundings surroundings, double halfGap) {
    switch (surroundings) {
    case Surroundings::Flat:
        model.add(std::make_unique<physics::PlateTerm>(halfGap, kPlates * model.stiffnessScale()));
        break;
    case Surroundings::Table: {
        std::vector<double> bodies = radii(yarns);
        double lowest = std::numeric_limits<double>::max();
        for (std::size_t e = 0; e < bodies.size(); ++e) {
            lowest = std::min(lowest, physics::at(x, static_cast<Entry>(e)).z() - bodies[e]);
        }
        model.add(
            std::make_unique<physics::FloorTerm>(lowest, std::move(bodies), kFloor * model.stiffnessScale()));
        model.add(std::make_unique<physics::GravityTerm>(weights(yarns), -Eigen::Vector3d::UnitZ()));
        break;
    }
    case Surroundings::Hanging:
        pin(model, topNodes(fabric, yarns));
        model.add(std::make_unique<physics::GravityTerm>(weights(yarns), -Eigen::Vector3d::UnitY()));
        break;
    case Surroundings::Pinned:
        pin(model, edgeNodes(fabric, yarns));
        break;
    case Surroundings::Free:
        break;
    }
}

} // namespace knittsim::simulation
