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
/// The lists are at every moment a diagram that can be drawn in the plane. Begin with the strands side by
/// side in the order in which they were made along the bed and follow the lists upwards: at every passing the
/// two stand next to each other, so that what passes both stands on one side of both, and at the end all
/// stand as on the machine. Every passing that is not undone lies on its two strands once. Some strands have
/// no order: the loops of one needle, which never part, yarns that one operation moved together, and loops
/// that face each other from the beginning until they part. What passes such strands at one moment may lie on
/// its list in any order (areUnordered). As loops that faced each other part, so they are said to have stood
/// from the beginning; if they then pass each other, with the front one in front, they may as well have begun
/// the other way round, and that is taken if the passing can be slid down to where the younger one was made
/// (turnRound).
///
/// A passing is undone by the opposite passing of the same two strands with the same one in front when
///  - nothing lies on either strand in between: the second Reidemeister move; or
///  - just the same strands lie in between on both, each running through the gap between the two, and one of
///    the two can be moved across all of the gap: across every place where two of the strands there pass each
///    other by a third move, which exists unless the first of the three lies in front of the second, the
///    second in front of the third and the third in front of the first. Then the second move applies. On a
///    strand that runs through, nothing may lie between its passings of the two but what can be put aside or
///    runs through.
/// All these moves change the diagram and not the fabric, whatever the machine did in between.
///
/// What is not recognised: a strand that could slide past a place where a loop is drawn through another one
/// (whether it can depends on where all the yarns there go), gaps with more than kReach passings in them, and
/// chains of third moves that only together make room for a second one. Then the crossings stay: they are
/// right, but there are more of them than need be, and which of them stay may depend on what else the machine
/// did. Of 6,000 random programs with stacks and racks none showed it when something that does nothing was
/// put in at 8 places of each; of 300 three did at 200 places of each: a chain of third moves (test
/// PassingBook.AThirdMoveThatOnlyMakesRoomIsNotLookedFor), a stack of which one loop turned round and another
/// one passed, and one that was not traced. Telling in general whether two diagrams show the same fabric is a
/// problem of knot theory that no local rule decides.
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

    /// Two loops that have stood at one place since the younger one was made, `over` nearer to the front bed,
    /// come to stand side by side, as if they passed each other. So they stood from the beginning.
    void part(const Pair& pair);

    /// Such a pair that has never passed each other.
    bool isFree(const Pair& pair) const;

    /// A free pair passes each other. True when this can be slid down to where the younger one was made: then
    /// they stood the other way round from the beginning, and nothing is entered.
    bool turnRound(const Pair& pair);

    /// Free pairs come to stand at one place again. True when nothing has passed them since the younger one
    /// was made: then it is as if they had not parted.
    bool meetAgain(std::span<const Pair> pairs);

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
    /// Pairs of loops that have parted: 1 when `over` began on the right, -1 on the left.
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
