// Where the carriers stand when a needle works. A carrier's place in the program is beside its last needle;
// its body stops some pitches further out, and the yarn spans the way between (FORMATS of knitout 2,
// carriers).

#include "core/machine/checks/groups.h"

#include <algorithm>

namespace knittsim::machine {

namespace {

/// Needles of both beds that face each other may be named in either order, pitches.
constexpr double kFacing = 0.5;

class CarrierCheck : public CheckGroup {
public:
    CarrierCheck(const Timeline& timeline, Findings& findings)
        : CheckGroup(timeline, findings), m_told(m_program.header.carriers.size(), false) {}

    void before(const Operation& op, const MachineState& state) override {
        if (makesLoop(op.kind)) {
            checkSides(op, state);
        }
        if (carriesYarn(op.kind)) {
            checkRails(op, state);
        }
        if (carriesYarn(op.kind) || op.kind == OperationKind::Xfer) {
            checkOthers(op, state);
        }
    }

    void yarnMoved(CarrierIndex carrier, const CarrierPlace*, const CarrierPlace&) override {
        m_told[carrier] = false;
    }

private:
    /// The carrier must come to the needle from behind, seen in the direction of the stitch.
    bool mustComeBack(const Operation& op, const MachineState& state, CarrierIndex carrier) const {
        const CarrierState& c = state.carriers[carrier];
        if (!c.in || !c.placed) {
            return false;
        }
        const int forward = sign(op.direction);
        const double at = positionPitches(op.needle, state.rack);
        if (c.place.side != op.direction) { // it turned round where it stopped
            return (at - c.place.pitches + forward * m_profile.carrierStopPitches) * forward <= 0;
        }
        return c.place.needle == op.needle || (at - c.place.pitches) * forward < -kFacing;
    }

    void checkSides(const Operation& op, const MachineState& state) {
        int back = -1;
        int ready = -1;
        for (const CarrierIndex c : op.carriers) {
            if (!state.carriers[c].placed) {
                continue;
            }
            (mustComeBack(op, state, c) ? back : ready) = c;
        }
        if (back < 0) {
            return;
        }
        const std::string& late = nameOf(static_cast<CarrierIndex>(back));
        if (ready >= 0) {
            m_findings.report("KS0237", {nameOf(static_cast<CarrierIndex>(ready)), late, toString(op.needle)},
                              op.needle);
        } else {
            m_findings.report("KS0225", {late, toString(op.needle)}, op.needle);
        }
    }

    void checkRails(const Operation& op, const MachineState& state) {
        const double to = positionPitches(op.needle, state.rack);
        for (const CarrierIndex c : op.carriers) {
            if (!state.carriers[c].placed) {
                continue; // it is not known from which side it comes
            }
            const double from = state.carriers[c].place.pitches;
            const int rail = m_program.header.carriers[c].rail;
            for (std::size_t o = 0; o < state.carriers.size(); ++o) {
                const CarrierState& other = state.carriers[o];
                if (o == c || !other.placed || m_program.header.carriers[o].rail != rail) {
                    continue;
                }
                const double at = other.place.pitches;
                if ((from < at && to > at) || (from > at && to < at)) {
                    m_findings.report("KS0227", {nameOf(c), nameOf(static_cast<CarrierIndex>(o))}, op.needle);
                }
            }
        }
    }

    /// A needle works under the yarn of a waiting carrier, or a yarn moves past it.
    void checkOthers(const Operation& op, const MachineState& state) {
        const double at = positionPitches(op.needle, state.rack);
        const bool moves = !op.carriers.empty() && state.carriers[op.carriers[0]].placed;
        const double from = moves ? state.carriers[op.carriers[0]].place.pitches : at;
        for (std::size_t o = 0; o < state.carriers.size(); ++o) {
            const CarrierState& other = state.carriers[o];
            const auto carrier = static_cast<CarrierIndex>(o);
            if (!other.placed || m_told[o] || op.carriers.contains(carrier)) {
                continue;
            }
            const auto beyond = [&](double pitches) {
                return (pitches - other.place.pitches) * sign(other.place.side);
            };
            const double stop = m_profile.carrierStopPitches;
            const bool under = beyond(at) > 0 && beyond(at) <= stop && op.kind != OperationKind::Miss;
            const bool past =
                std::min(beyond(from), beyond(at)) <= 0 && std::max(beyond(from), beyond(at)) > stop;
            if (under || past) {
                m_told[o] = true; // until it moves
                m_findings.reportRun("KS0226", {toString(op.needle), nameOf(carrier)}, op.needle);
            }
        }
    }

    std::vector<bool> m_told; ///< by carrier: its yarn in the way is said
};

} // namespace

std::unique_ptr<CheckGroup> makeCarrierCheck(const Timeline& timeline, Findings& findings) {
    return std::make_unique<CarrierCheck>(timeline, findings);
}

} // namespace knittsim::machine
