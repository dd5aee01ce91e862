#pragma once

#include "core/physics/bonding_point_model.h"
#include "core/physics/integrator.h"
#include "core/physics/stop_rule.h"
#include "tests/support/build.h"

#include <string>

namespace knittsim::physics::test {

/// `courses` courses over needles 0..wales-1, back and forth; `bed(wale)` is 'f' or 'b'.
template<class Bed> std::string backAndForth(int wales, int courses, Bed bed) {
    std::string lines = "in 1\n";
    for (int course = 0; course < courses; ++course) {
        for (int i = 0; i < wales; ++i) {
            const int wale = course % 2 == 0 ? i : wales - 1 - i;
            lines += std::string("knit ") + (course % 2 == 0 ? '+' : '-') + ' ' + bed(wale) +
                     std::to_string(wale) + " 1\n";
        }
    }
    return lines;
}

inline fabric::Fabric plain(int wales, int courses) {
    return knittsim::test::build(backAndForth(wales, courses, [](int) { return 'f'; }));
}

/// `width` wales on the front bed, `width` on the rear bed, and so on.
inline fabric::Fabric rib(int wales, int courses, int width = 1) {
    return knittsim::test::build(
        backAndForth(wales, courses, [width](int wale) { return wale / width % 2 == 0 ? 'f' : 'b'; }));
}

/// Courses alternate between the beds.
inline fabric::Fabric garter(int wales, int courses) {
    std::string lines = "in 1\n";
    for (int course = 0; course < courses; ++course) {
        const char bed = course % 2 == 0 ? 'f' : 'b';
        lines += course % 2 == 0 ? knittsim::test::pass("knit", bed, 0, wales - 1, 1)
                                 : knittsim::test::pass("knit", bed, wales - 1, 0, 1);
        for (int n = 0; n < wales && course + 1 < courses; ++n) {
            const std::string needle = std::to_string(n) + '\n';
            lines += std::string("xfer ") + bed + std::to_string(n) + ' ' + (bed == 'f' ? 'b' : 'f') + needle;
        }
    }
    return knittsim::test::build(lines);
}

struct Settled {
    Motion motion;
    StopRule::Verdict verdict = StopRule::Verdict::GoOn;
    int steps = 0;
    double energy = 0;
};

/// From the machine's positions until the stop rule says something.
inline Settled settle(Model& model, const fabric::Fabric& f, std::string_view integratorId = "newton-cg",
                      double limit = 1e-4) {
    Settled s;
    s.motion.positions = machinePositions(f);
    s.motion.velocities = Vector::Zero(s.motion.positions.size());
    StopRule rule;
    rule.setLimit(limit);
    rule.setReference(model, s.motion.positions);
    const auto integrator = makeIntegrator(integratorId);
    integrator->initialise(model, s.motion);
    while (s.verdict == StopRule::Verdict::GoOn) {
        const StepReport report = integrator->step(s.motion, {});
        s.verdict = rule.judge(report, s.motion.positions, integrator->takesLargeSteps());
        s.energy = report.potential;
        ++s.steps;
    }
    return s;
}

inline Eigen::Vector3d headOf(const fabric::Fabric& f, const Vector& x, int loop) {
    const auto head = static_cast<std::size_t>(f.loops[static_cast<std::size_t>(loop)].headLeft);
    return at(x, f.points[head].entry);
}

/// Loop at a wale and a course of a fabric knitted back and forth with `wales` loops a course.
inline int loopAt(int wale, int course, int wales) {
    return course * wales + (course % 2 == 0 ? wale : wales - 1 - wale);
}

/// Mean distance of neighbouring wales in a course, and of neighbouring courses in a wale, straight across.
inline double waleSpacing(const fabric::Fabric& f, const Vector& x, int wales, int course) {
    return (headOf(f, x, loopAt(wales - 1, course, wales)) - headOf(f, x, loopAt(0, course, wales))).norm() /
           (wales - 1);
}
inline double courseSpacing(const fabric::Fabric& f, const Vector& x, int wales, int courses, int wale) {
    return (headOf(f, x, loopAt(wale, courses - 1, wales)) - headOf(f, x, loopAt(wale, 0, wales))).norm() /
           (courses - 1);
}

} // namespace knittsim::physics::test
