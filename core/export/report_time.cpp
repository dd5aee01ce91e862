#include "core/export/report_time.h"

#include <algorithm>

namespace knittsim::exports {

namespace {

using machine::Direction;
using machine::Operation;
using machine::OperationKind;

/// Needles from the first to the last one of a stroke.
struct Extent {
    double first = 0;
    double last = 0;

    void take(double at) {
        first = std::min(first, at);
        last = std::max(last, at);
    }
};

class Carriage {
public:
    explicit Carriage(const machine::MachineProfile& profile) : m_profile(profile) {
        m_time.speed = profile.speed;
    }

    void knit(Direction direction, const Extent& extent) {
        endTransfers();
        if (m_side == sign(direction)) {
            ++m_time.emptyStrokes;
            m_time.knitMetres += metres(extent);
        }
        ++m_time.knitStrokes;
        m_time.knitMetres += metres(extent);
        m_side = sign(direction);
    }

    /// One loop moves; joins those of the same bed before it.
    void transfer(machine::Bed bed, double at) {
        if (m_moves && m_bed != bed) {
            endTransfers();
        }
        if (!m_moves) {
            m_moves = true;
            m_transfers = {at, at};
            m_bed = bed;
        }
        m_transfers.take(at);
    }

    void endTransfers() {
        if (m_moves) {
            ++m_time.transferStrokes;
            m_time.transferMetres += metres(m_transfers);
            m_side = -m_side;
            m_moves = false;
        }
    }

    const KnittingTime& time() const { return m_time; }

private:
    double metres(const Extent& extent) const {
        const double pitches = extent.last - extent.first + 2 * m_profile.carrierStopPitches;
        return pitches * m_profile.pitchMm() / 1000;
    }

    const machine::MachineProfile& m_profile;
    KnittingTime m_time;
    int m_side = 0;       ///< of the bed on which the carriage stands: -1 left, +1 right, 0 not known
    bool m_moves = false; ///< loops of m_bed, in a stroke that has not ended
    Extent m_transfers;
    machine::Bed m_bed{};
};

} // namespace

KnittingTime estimateTime(const machine::Program& program, const machine::MachineProfile& profile) {
    Carriage carriage(profile);
    const std::vector<machine::Pass> passes = machine::findPasses(program);
    std::size_t next = 0;
    double rack = 0;
    for (std::size_t i = 0; i < program.operations.size(); ++i) {
        const Operation& op = program.operations[i];
        if (next < passes.size() && static_cast<std::size_t>(passes[next].first) == i) {
            const machine::Pass& pass = passes[next++];
            const double at = machine::positionPitches(op.needle, rack);
            Extent extent{at, at};
            const std::size_t end = i + static_cast<std::size_t>(pass.count);
            for (; i < end; ++i) {
                if (machine::carriesYarn(program.operations[i].kind)) {
                    extent.take(machine::positionPitches(program.operations[i].needle, rack));
                }
            }
            --i;
            carriage.knit(pass.direction, extent);
        } else if (op.kind == OperationKind::Rack) {
            carriage.endTransfers();
            rack = op.value;
        } else if (op.kind == OperationKind::Xfer || op.kind == OperationKind::Drop ||
                   op.kind == OperationKind::Amiss || op.kind == OperationKind::Split) {
            carriage.transfer(op.needle.bed, machine::positionPitches(op.needle, rack));
        }
    }
    carriage.endTransfers();
    return carriage.time();
}

} // namespace knittsim::exports
