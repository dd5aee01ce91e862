// Yarn that lies between two loops without being bound.

#include "core/machine/checks/groups.h"

#include <fmt/format.h>

#include <cmath>

namespace knittsim::machine {

namespace {

class FloatCheck : public CheckGroup {
public:
    using CheckGroup::CheckGroup;

    void loopMade(LoopIndex index) override {
        const Loop& loop = loopAt(index);
        const double mm = loop.wayPitches * m_profile.pitchMm();
        const ProfileLimits& limits = m_profile.limits;
        if (loop.wayPitches > limits.floatNeedles || mm > limits.floatMm) {
            m_findings.report("KS0233",
                              {nameOf(loop.carrier), fmt::format("{:.1f}", mm),
                               fmt::format("{:g}", loop.wayPitches), fmt::format("{:g}", limits.floatMm),
                               fmt::format("{:g}", limits.floatNeedles)},
                              loop.needle);
        }
    }
};

} // namespace

std::unique_ptr<CheckGroup> makeFloatCheck(const Timeline& timeline, Findings& findings) {
    return std::make_unique<FloatCheck>(timeline, findings);
}

} // namespace knittsim::machine
