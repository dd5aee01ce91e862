#pragma once

#include "core/fabric/fabric.h"
#include "core/machine/emulator.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace knittsim::fabric {

/// A strand that can pass others on the machine: the two legs of a held loop together, or the yarn between a
/// carrier's last loop and its next one (a float, open until that loop is made).
struct Strand {
    enum class Kind : std::uint8_t { Loop, Float } kind = Kind::Loop;
    std::int32_t index = 0; ///< LoopIndex, or number of the float

    bool operator==(const Strand&) const = default;
};

/// Two strands passed each other. `over` lies nearer to the front bed.
struct Passing {
    Strand over;
    Strand under;
    OperationIndex operation = 0;
    std::int8_t sign = 1; ///< +1: over went from left to right of under
    bool undone = false;
    float place = 0;            ///< along the bed, pitches
    std::int32_t previous = -1; ///< the passing of the same two strands before this one
    std::int32_t overStay = 0;  ///< see StrandTracker::m_stay
    std::int32_t underStay = 0;
};

/// Listens to the machine and keeps the books of who passes whom and who is in front.
///
/// The held loops and open floats are the strands of a braid that grows with time. Their order along the bed
/// is known at every moment: front needle i stands at i, rear needle j at j + rack, a carrier just beside its
/// needle. A strand on the front bed lies in front of a float, a float in front of a strand on the rear bed,
/// floats among each other in the order of the carriers' rails. Two strands that change their order make a
/// passing. Loops that face each other (same place, both beds) have not passed yet; whether they do shows
/// when they part.
///
/// A passing back cancels the one before when neither strand has changed beds in between: then both passings
/// lie between the same two layers, no third strand can lie between them, and the second Reidemeister move
/// applies. Formal background: Lin et al., "Semantics and Scheduling for Machine Knitting Compilers"
/// (SIGGRAPH 2023).
class StrandTracker : public machine::EmulationListener {
public:
    /// `emulator` is the one that will be stepped; it must outlive the tracker.
    StrandTracker(const machine::Emulator& emulator, const machine::Program& program);

    const std::vector<Passing>& passings() const { return m_passings; }

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
    /// yarns on one side of a needle the one that came last is nearest to the needle.
    struct Key {
        double x = 0;
        int side = 0;
        std::int64_t rank = 0;
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
        int rail;
    };
    /// A loop that went to the other bed, so that coming back unchanged can be recognised.
    struct Move {
        bool fromFront;
        std::int32_t stayBefore;
        std::int32_t openPassings;
    };

    void collectLoops(machine::Bed bed, const Key& low, const Key& high, double rack);
    void collectYarns(const Key& low, const Key& high, const machine::CarrierSet& except);
    void sortMet(int direction);
    void pass(Strand over, Strand under, int sign, double place);
    static double placeOf(const Met& met);
    void passFloat(CarrierIndex moving, const Met& met, int direction);
    void rackNeedle(std::int32_t rear, double from, double to);
    void passRear(const Met& met, std::int32_t rear, int direction);
    bool isCrowded(Needle needle, double rack) const;
    bool holdsLoop(bool front, std::int32_t index) const;
    void forgetFacing(Needle emptied);
    std::int32_t& stay(Strand strand);
    void countOpen(const Passing& passing, int change);
    std::int32_t openFloat();
    OperationIndex operation() const { return m_emulator.state().nextOperation - 1; }

    const machine::Emulator& m_emulator;
    const machine::Program& m_program;
    std::vector<Yarn> m_yarns; ///< by carrier
    std::vector<Passing> m_passings;
    std::unordered_map<std::uint64_t, std::int32_t> m_last; ///< latest valid passing of two strands
    std::vector<LoopIndex> m_loopAfter;                     ///< by float
    std::vector<Fate> m_fates;                              ///< by loop
    std::vector<std::int32_t> m_stay;                       ///< by loop: number of its present stay on a bed
    std::vector<std::int32_t> m_openPassings;               ///< by loop
    std::unordered_map<LoopIndex, std::vector<Move>> m_movesOf;
    std::unordered_map<std::int32_t, int> m_facingFrom; ///< rear needle -> side from which it came to face
    std::vector<Met> m_met;
    std::int64_t m_rank = 0;
    std::int32_t m_stayCount = 0;
    std::int32_t m_floatStay = 0;
};

} // namespace knittsim::fabric
