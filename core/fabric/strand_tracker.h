#pragma once

#include "core/fabric/passing_book.h"
#include "core/machine/emulator.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace knittsim::fabric {

/// Listens to the machine and keeps the books of who passes whom and who is in front.
///
/// The held loops and open floats are the strands of a braid that grows with time. Their order along the bed
/// is known at every moment: front needle i stands at i, rear needle j at j + rack, a carrier just beside its
/// needle. A strand on the front bed lies in front of a float, a float in front of a strand on the rear bed,
/// floats among each other in the order of the carriers' rails (on one rail: of the carriers). Two strands
/// that change their order make a passing; PassingBook undoes those that come to nothing. Formal background:
/// Lin et al., "Semantics and Scheduling for Machine Knitting Compilers" (SIGGRAPH 2023).
///
/// Racks that follow each other without anything between them are one rack.
///
/// Strands that meet while the bed racks pass in the order of time, those that meet at one moment in the
/// order of their age, so that nothing depends on which bed moves or from which side one looks.
///
/// Loops that face each other (same place, both beds) have not passed yet. At rack 0.25 the rear loop stands
/// to the right of the front loop with its number, and between racks 0 and 0.25 nothing passes. A rear loop
/// that comes to face a front loop has passed it when it goes on, not when it goes back. Loops that faced
/// each other from the beginning have no order until they part, and their ways past each other do not count
/// if they may as well have stood the other way round from the beginning (PassingBook). All loops of a needle
/// go the same way: those that have no order with what they face take over that of the others.
class StrandTracker : public machine::EmulationListener {
public:
    /// `emulator` is the one that will be stepped; it must outlive the tracker.
    StrandTracker(const machine::Emulator& emulator, const machine::Program& program);

    /// To be called after the last operation.
    void finish() { applyRack(); }

    const PassingBook& book() const { return m_book; }

    std::int32_t floatCount() const { return static_cast<std::int32_t>(m_loopAfter.size()); }

    /// The loop a float leads to, or -1 when it never led to one.
    LoopIndex loopAfterFloat(std::int32_t number) const {
        return m_loopAfter[static_cast<std::size_t>(number)];
    }

    /// Where a loop was when the next loop came through it or when it was dropped.
    struct Fate {
        Needle needle;
        double rack = 0;
        Loop::End end = Loop::End::Held;
        bool crowded = false; ///< see Loop::crowded
    };
    const std::vector<Fate>& fates() const { return m_fates; }

    void yarnMoved(CarrierIndex, const machine::CarrierPlace*, const machine::CarrierPlace&) override;
    void loopMade(LoopIndex) override;
    void loopsMoved(Needle from, Needle to, std::span<const LoopIndex>) override;
    void loopsDropped(Needle, std::span<const LoopIndex>) override;
    void racked(double from, double to) override;
    void yarnCut(CarrierIndex) override;

private:
    /// Place in the order along the bed. `side` -1, 0, +1: left of, on, right of a needle at `x`. Of several
    /// yarns on one side of a needle the one that came last is nearest to the needle. What has one key stands
    /// at one place: a stack, yarns of one operation, loops that face each other and have no order yet.
    struct Key {
        double x = 0;
        int side = 0;
        OperationIndex rank = 0;
        auto operator<=>(const Key&) const = default;
    };
    struct Yarn {
        bool open = false;
        Key key;
        std::int32_t number = 0; ///< of the open float
    };
    struct Met {
        Key key;
        Strand strand;
        int layer; ///< +1 front bed, 0 between the beds, -1 rear bed
        CarrierIndex carrier;
    };
    /// What a rear needle meets while the bed racks, `way` from where it started.
    struct RackMeeting {
        Key way;
        LoopIndex eldest; ///< of the two needles: an order of what happens at one moment
        std::int32_t rear;
        Met met;
    };
    static constexpr std::array kFrontBeds{machine::Bed::Front, machine::Bed::FrontSlider};
    static constexpr std::array kRearBeds{machine::Bed::Rear, machine::Bed::RearSlider};
    static bool isWhole(double place) { return place == std::floor(place); }

    /// A carrier on its way to its next place.
    struct Way {
        CarrierIndex carrier;
        Key to;
    };

    void moveYarns(std::span<const Way> together);
    void collectLoops(machine::Bed bed, const Key& low, const Key& high);
    void collectYarns(const Key& low, const Key& high, const machine::CarrierSet& except);
    void sortMet(int direction);
    void pairYarns(std::span<const Way> together, const Met& met, int direction);
    bool isInFront(CarrierIndex carrier, const Met& met) const;
    void applyRack();
    std::vector<std::int32_t> rearNeedles(double rack) const;
    LoopIndex eldestLoop(std::span<const machine::Bed> beds, double place) const;
    void collectRackMeetings(std::int32_t rear, double from, double to);
    void passRackMeetings(int direction);
    void pairRear(Strand over, std::int32_t rear, int direction, double place);
    void passRear();
    void turnFree();
    void leaveFacing(std::int32_t rear, double place, int direction);
    void comeToFace(std::int32_t rear, double place, int direction);
    void pairFacing(std::int32_t rear, double place, int direction);
    double placeOf(const Key& key) const;
    bool isCrowded(Needle needle, double rack) const;
    bool holdsLoop(bool front, std::int32_t index) const;
    void inheritFacing(LoopIndex loop);
    int facingSide(std::int32_t rear, double place);
    int cameFrom(PassingBook::Pair pair) const;
    PassingBook::Pair facingPair(const machine::Loop& made, LoopIndex own, LoopIndex other) const;
    std::int32_t openFloat();
    OperationIndex operation() const { return m_emulator.state().nextOperation - 1; }
    OperationIndex rankBeside(int side) const { return side > 0 ? -operation() : operation(); }

    const machine::Emulator& m_emulator;
    const machine::Program& m_program;
    PassingBook m_book;
    std::vector<Yarn> m_yarns;          ///< by carrier
    std::vector<LoopIndex> m_loopAfter; ///< by float
    std::vector<Fate> m_fates;          ///< by loop
    /// Pairs of loops that face each other: side from which the rear one came, -1 left, +1 right. None if
    /// they face each other from the beginning.
    std::unordered_map<std::uint64_t, int> m_cameFrom;
    std::vector<Way> m_ways; ///< of the carriers of the present operation
    std::vector<Met> m_met;
    std::vector<RackMeeting> m_rackMeetings;
    std::vector<PassingBook::Pair> m_pairs;
    std::int32_t m_moment = 0;
    std::optional<double> m_rackFrom; ///< of the racks since something else happened
    double m_rackTo = 0;
    OperationIndex m_rackOperation = 0;
};

} // namespace knittsim::fabric
