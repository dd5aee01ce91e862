#pragma once

#include "core/machine/bed_picture.h"
#include "core/machine/needle_stroke.h"
#include "core/machine/timeline.h"

#include <optional>
#include <vector>

namespace knittsim::machine {

/// The needle an operation works at, else the one the last operation before it worked at.
std::optional<Needle> workingNeedle(const Program& program, OperationIndex operation);

/// One operation as it is seen on the needle beds, for every moment of it. A pure function of timeline,
/// operation and phase, so that it runs backwards as exactly as forwards; the end of an operation is the
/// begin of the next. Making one takes about as long as Timeline::stateAfter.
class BedMotion {
public:
    /// The timeline must outlive it. An operation outside the program shows the nearest state, at rest.
    BedMotion(const Timeline& timeline, OperationIndex operation);

    OperationIndex operation() const { return m_operation; }

    /// The moment `phase` in [0, 1]: 0 before the operation, 1 after it.
    BedPicture at(double phase, BedWindow window) const;

private:
    struct Move {
        Needle from;
        Needle to;
        std::vector<LoopIndex> loops; ///< as they lay on `from`
    };
    class Listener;
    struct Link {
        SeenLink before;
        SeenLink after;
        bool wasThere = false;
        bool isThere = false;
    };
    using LastLoops = std::vector<YarnEnd>; ///< by carrier

    void findCarriage();
    void findLinks();
    LastLoops lastLoops(const MachineState& state) const;
    double carriageAt(OperationIndex operation) const;
    Stroke strokeOf(Needle needle) const;
    SeenLoop seen(LoopIndex loop, const NeedlePose& pose) const;
    SeenNeedle needleAt(Needle needle, double t, double rack) const;
    std::span<const LoopIndex> oldLoops(Needle needle, double t) const;
    SeenCarrier carrierAt(CarrierIndex carrier, double t) const;
    double standingPlace(const CarrierState& state, CarrierIndex carrier) const;
    void addNeedles(BedPicture& picture, double t, BedWindow window) const;
    void addLinks(BedPicture& picture, double t, BedWindow window) const;

    const Timeline& m_timeline;
    OperationIndex m_operation;
    Operation m_op; ///< Pause outside the program
    MachineState m_before;
    MachineState m_after;
    std::optional<Move> m_move;
    std::vector<LoopIndex> m_made;
    Needle m_madeOn;
    std::vector<Link> m_links;
    LastLoops m_lastBefore;
    LastLoops m_lastAfter;
    std::optional<SeenCarriage> m_carriageBefore;
    std::optional<SeenCarriage> m_carriageAfter;
};

} // namespace knittsim::machine
