#pragma once

#include "core/formats/passes/pass.h"
#include "core/formats/passes/pass_rules.h"

#include <optional>
#include <string>
#include <vector>

namespace knittsim::formats::passes {

/// Lines up passes and keeps account of where every yarn hangs and where its carrier stands, so that the
/// carriers start on the right side and none lies across a needle that works.
///
/// How far from its last needle a carrier stops is not known, so it counts as anywhere from just beside it to
/// the end of the bed.
class YarnMover {
public:
    YarnMover(const PassRules& rules, std::size_t carrierCount) : m_rules(rules), m_yarns(carrierCount) {}

    /// Carriers that were brought in and wait for their first stitch.
    struct Arrival {
        machine::CarrierSet carriers;
        bool hook = false;
    };

    double rack() const { return m_rack; }
    void setRack(double rack) { m_rack = rack; }

    /// The front needle number at which a needle stands, rounded down.
    int slot(machine::Needle needle) const;

    void bringIn(const machine::CarrierSet& carriers, machine::OperationKind how);

    /// What `carriers` wait for, which they then no longer do.
    std::optional<Arrival> takeArrival(const machine::CarrierSet& carriers);

    /// Where the yarn of the carrier hangs, nothing before its first stitch.
    std::optional<machine::Needle> place(machine::CarrierIndex carrier) const;
    bool isIn(machine::CarrierIndex carrier) const { return m_yarns[carrier].in; }

    void takeOut(const machine::CarrierSet& carriers, bool hook, Pass pass);
    void releaseHook(const machine::CarrierSet& carriers, machine::Direction direction, Pass pass);

    /// Carries all yarns but those of `carriers` out of the way of a needle that is about to work.
    void clear(machine::Needle needle, const machine::CarrierSet& carriers, const Pass& pass);

    /// Joins the pass to the last one, or begins a new one after its carriers have been brought to the side
    /// from which they start. The pass has one cell.
    void add(Pass pass);

    /// The carriers have made a stitch or a miss.
    void stitched(const machine::CarrierSet& carriers, machine::Needle needle, machine::Direction direction);

    /// The loops of `from` hang on `to` now, and the yarns with them.
    void moved(machine::Needle from, machine::Needle to);

    void pause(std::string message);
    void endPass() { m_end = true; }

    /// The last pass, a split to sliders, gives back at the present racking. False when that cannot be.
    bool returnSliders();

    std::vector<Pass> takePasses() && { return std::move(m_passes); }

private:
    struct Place {
        machine::Needle needle;
        machine::Direction side = machine::Direction::Right;
    };
    struct Yarn {
        bool in = false;
        std::optional<Arrival> arrival;
        std::optional<Place> last;   ///< where the yarn hangs
        std::optional<Place> parked; ///< beside what its carrier stands
    };
    struct Kick {
        int slot;
        machine::CarrierSet carriers;
    };

    std::vector<Kick> kicksBefore(const Pass& pass) const;
    void kick(const Kick& kick, machine::Direction direction, Pass pass);
    Pass softMiss(int slot, const machine::CarrierSet& carriers, machine::Direction direction,
                  Pass pass) const;

    PassRules m_rules;
    std::vector<Yarn> m_yarns;
    std::vector<Pass> m_passes;
    double m_rack = 0;
    bool m_pause = false;
    bool m_end = false;
    std::string m_message;
};

} // namespace knittsim::formats::passes
