#pragma once

#include "core/fabric/strand.h"

#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace knittsim::fabric {

/// The passings of all strands, and for every strand those that lie on it, from its feet upwards (a float:
/// along its way).
///
/// A passing is undone by the opposite passing of the same two strands with the same one in front when
///  - nothing lies on either strand in between: the second Reidemeister move; or
///  - just the same strands lie in between on both, each running through the gap between the two, and one of
///    the two passes in front of all of them or behind all of them. It is slid across them (third move) to
///    the other strand, and then the second move applies. On a strand that runs through, nothing may lie
///    between its passings of the two but what can be put aside or runs through, too.
/// Both moves change the diagram of crossings and not the fabric, whatever the machine did in between.
/// Strands that stood at one place have no order until they pass each other; from then on it is known how
/// they stood.
///
/// What is not recognised: a strand that could slide past a place where a loop is drawn through another one
/// (whether it can depends on where all the yarns there go), gaps with more than kReach strands in them, and
/// chains of third moves that only together make room for a second one. Then the crossings stay: they are
/// right, but there are more of them than need be, and which of them stay may depend on what else the machine
/// did (of random programs with stacks and racks one in some thousands). Telling in general whether two
/// diagrams show the same fabric is a problem of knot theory that no local rule decides.
class PassingBook {
public:
    static constexpr std::size_t kReach = 256;

    void addLoop(OperationIndex operation = 0) {
        m_onLoop.emplace_back();
        m_made.push_back({operation, static_cast<std::int32_t>(m_passings.size())});
    }
    void addFloat() { m_onFloat.emplace_back(); }

    /// Nothing slides past here: a loop was drawn through this one, which goes on to another needle.
    void bar(LoopIndex loop, OperationIndex operation) {
        m_onLoop[static_cast<std::size_t>(loop)].push_back(-1 - operation);
    }
    static constexpr bool isBar(std::int32_t entry) { return entry < 0; }

    /// Two strands that pass each other; `sign` as in Passing.
    struct Pair {
        Strand over;
        Strand under;
        int sign = 1;
        double place = 0; ///< as in Passing
    };

    /// These pairs pass each other at one moment: those that passed before the other way undo that, the
    /// others make new passings, which lie on a strand in the order in which those that it passes are known
    /// to stand along the bed, otherwise by age. `moment` as in Passing.
    void pass(std::span<const Pair> pairs, OperationIndex operation, std::int32_t moment);

    /// The same if the first of them thereby undoes an earlier passing; else nothing, and false.
    bool passBack(std::span<const Pair> pairs, OperationIndex operation, std::int32_t moment);

    /// Two loops that have stood at one place since the younger one was made come to stand side by side, as
    /// if they passed each other. So they stood from the beginning.
    void part(const Pair& pair);

    /// Loops that have parted and never passed each other do so. True when this can be slid down to where the
    /// younger one was made: then they stood the other way round from the beginning, and nothing is entered.
    bool turnRound(const Pair& pair);

    /// Nothing has passed either of two loops since the younger one was made.
    bool nothingPassed(Strand a, Strand b) const;

    /// The two that have parted are as if they had not.
    void meetAgain(Strand a, Strand b);

    /// The two have passed each other lately, and that is not undone.
    bool havePassed(Strand a, Strand b) const { return findLast(a, b) >= 0; }

    const std::vector<Passing>& passings() const { return m_passings; }

    /// Indices of the passings on a strand that are not undone, and bars.
    const std::vector<std::int32_t>& on(Strand strand) const {
        const auto i = static_cast<std::size_t>(strand.index);
        return strand.kind == Strand::Kind::Loop ? m_onLoop[i] : m_onFloat[i];
    }

    /// Two passings on a strand that follow each other but might as well stand the other way round: of one
    /// moment, with strands that have not passed each other.
    bool areUnordered(Strand strand, std::int32_t a, std::int32_t b) const;

private:
    using List = std::vector<std::int32_t>;

    List& list(Strand strand);
    void enter(std::span<const Pair> pairs, OperationIndex operation, std::int32_t moment);
    bool undo(const Pair& pair);
    std::vector<std::size_t>::iterator findFirst(std::span<const Pair> pairs);
    bool isMetBefore(const Pair& a, const Pair& b) const;
    void settle(Strand left, Strand right);
    int sideOf(Strand a, Strand b) const;
    void putInOrder(Strand strand, std::int32_t first, std::int32_t second);
    void undoEldestFirst(std::span<const Pair> pairs);
    std::int32_t findLast(Strand a, Strand b) const;
    bool collectGap(Strand strand, std::int32_t number, List& gap) const;
    bool collectSince(Strand younger, Strand strand, List& gap) const;
    bool slideAway(const Passing& passing);
    /// A strand that lies in a gap on both sides.
    struct Through {
        Strand strand;
        std::int32_t over; ///< its passings of the two
        std::int32_t under;
    };
    bool pairGap(const Passing& passing);
    std::optional<Strand> findSlider(const Passing& passing) const;
    bool runsThrough(const Passing& passing, const Through& through) const;
    bool isGapClear(const Passing& passing);
    bool gather(Strand strand, Strand over, std::int32_t a, std::int32_t b);
    bool canSlide(std::int32_t Through::*onSlider) const;
    std::size_t placeOn(Strand strand, std::int32_t number) const;
    void slide(const Passing& passing, Strand slider);
    void swapOrder(Strand strand, Strand over, std::int32_t moved, std::int32_t fixed);

    const Passing& at(std::int32_t number) const { return m_passings[static_cast<std::size_t>(number)]; }

    std::vector<Passing> m_passings;
    /// When a loop was made.
    struct Made {
        OperationIndex operation;
        std::int32_t first; ///< passing from then on
    };
    std::vector<Made> m_made;
    /// Pairs of loops that have parted: 1 when the elder one began on the right of the younger one, else -1.
    std::unordered_map<std::uint64_t, int> m_began;
    std::vector<List> m_onLoop;
    std::vector<List> m_onFloat;
    std::vector<std::size_t> m_left;    ///< pairs that were not undone, the eldest first
    std::vector<std::size_t> m_inOrder; ///< the same as they were given
    List m_gapOver;                     ///< passings on either strand in the gap that is to be closed
    List m_gapUnder;
    std::vector<Through> m_through; ///< in the order of m_gapOver
    List m_unpaired;
    List m_onSlider;
    /// Passings on a strand about two of them: aside before these, between them, aside behind them.
    struct Gathered {
        std::size_t begin = 0; ///< on its strand
        List before;
        List between;
        List after;
    };
    Gathered m_gathered;
};

} // namespace knittsim::fabric
