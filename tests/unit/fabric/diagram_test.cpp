// The books of passings are at every moment a diagram that can be drawn in the plane.

#include "core/fabric/strand_tracker.h"
#include "tests/support/for_random_programs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>

namespace knittsim::fabric {
namespace {

using machine::Program;

/// The passings that were made while a strand was there.
struct Life {
    std::int32_t first = 0;
    std::int32_t end = std::numeric_limits<std::int32_t>::max();
    bool contains(std::int32_t number) const { return first <= number && number < end; }
};
using Lives = std::map<Strand, Life>;

std::string nameOf(Strand strand) {
    return (strand.kind == Strand::Kind::Loop ? "loop " : "float ") + std::to_string(strand.index);
}

class Diagram {
public:
    Diagram(const PassingBook& book, const Lives& lives) : m_book(book), m_lives(lives) {
        for (const auto& [strand, life] : lives) {
            for (const std::int32_t number : book.on(strand)) {
                if (!PassingBook::isBar(number)) {
                    m_on[strand].push_back(number);
                }
            }
        }
    }

    /// What is wrong with it, or nothing.
    std::string fault() const {
        if (!everyPassingLiesOnItsTwoStrands()) {
            return "a passing is lost or lies on a strand to which it does not belong";
        }
        for (const auto& [strand, numbers] : m_on) {
            for (const std::int32_t number : numbers) {
                const Strand other = at(number).other(strand);
                if (strand < other && !fitsOthers(strand, other, number)) {
                    return "passing " + std::to_string(number) + " of " + nameOf(strand) + " and " +
                           nameOf(other) + " goes through a third strand";
                }
            }
        }
        return {};
    }

private:
    const Passing& at(std::int32_t number) const {
        return m_book.passings()[static_cast<std::size_t>(number)];
    }

    bool everyPassingLiesOnItsTwoStrands() const {
        std::vector<int> places(m_book.passings().size(), 0);
        for (const auto& [strand, numbers] : m_on) {
            for (const std::int32_t number : numbers) {
                if (!(at(number).over == strand || at(number).under == strand)) {
                    return false;
                }
                ++places[static_cast<std::size_t>(number)];
            }
        }
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (places[i] != (m_book.passings()[i].undone ? 0 : 2)) {
                return false;
            }
        }
        return true;
    }

    /// Where two strands pass each other they are at one place: what both pass stands on one side of both.
    bool fitsOthers(Strand a, Strand b, std::int32_t number) const {
        std::set<Strand> others;
        for (const std::int32_t n : m_on.at(a)) {
            others.insert(at(n).other(a));
        }
        return std::ranges::all_of(others, [&](Strand other) {
            const bool floats = (a.kind == Strand::Kind::Float) + (b.kind == Strand::Kind::Float) +
                                    (other.kind == Strand::Kind::Float) >
                                1;
            // Yarns of one operation run side by side in any order.
            if (other == b || floats || !m_lives.at(other).contains(number)) {
                return true;
            }
            const std::optional<int> sideOfA = sideAt(number, a, other);
            const std::optional<int> sideOfB = sideAt(number, b, other);
            return !sideOfA || !sideOfB || *sideOfA == *sideOfB;
        });
    }

    /// On which side of `strand` the other one stands at a passing of the strand. Nothing where it has none.
    std::optional<int> sideAt(std::int32_t number, Strand strand, Strand other) const {
        std::optional<int> side;
        bool isBehind = false;
        for (const std::int32_t n : m_on.at(strand)) {
            isBehind = isBehind || n == number;
            if (!(at(n).other(strand) == other)) {
                continue;
            }
            if (m_book.areUnordered(strand, number, n)) {
                return std::nullopt;
            }
            if (isBehind) {
                return side ? side : at(n).directionOf(strand);
            }
            side = -at(n).directionOf(strand);
        }
        return side;
    }

    const PassingBook& m_book;
    const Lives& m_lives;
    std::map<Strand, std::vector<std::int32_t>> m_on;
};

/// Runs a program and looks at the books after every operation.
class Observer {
public:
    explicit Observer(const Program& program)
        : m_profile(machine::genericProfile()), m_emulator(program, m_profile),
          m_tracker(m_emulator, program) {}

    std::string firstFault() {
        std::string fault;
        while (!m_emulator.atEnd() && fault.empty()) {
            m_emulator.step(&m_tracker);
            keepLives();
            fault = Diagram(m_tracker.book(), m_lives).fault();
        }
        m_tracker.finish();
        return fault.empty() ? Diagram(m_tracker.book(), m_lives).fault() : fault;
    }

private:
    void keepLives() {
        const auto now = static_cast<std::int32_t>(m_tracker.book().passings().size());
        for (; m_loops < static_cast<LoopIndex>(m_emulator.loops().loops.size()); ++m_loops) {
            m_lives[{Strand::Kind::Loop, m_loops}].first = now;
        }
        for (; m_floats < m_tracker.floatCount(); ++m_floats) {
            m_lives[{Strand::Kind::Float, m_floats}].first = now;
        }
        for (auto& [strand, life] : m_lives) {
            if (!isThere(strand)) {
                life.end = std::min(life.end, now);
            }
        }
    }

    bool isThere(Strand strand) const {
        if (strand.kind == Strand::Kind::Float) {
            return m_tracker.loopAfterFloat(strand.index) < 0;
        }
        return std::ranges::any_of(m_emulator.state().beds, [&](const machine::NeedleRow& row) {
            for (std::int32_t needle = row.first(); needle < row.end(); ++needle) {
                if (std::ranges::count(row.at(needle), strand.index) > 0) {
                    return true;
                }
            }
            return false;
        });
    }

    machine::MachineProfile m_profile;
    machine::Emulator m_emulator;
    StrandTracker m_tracker;
    Lives m_lives;
    LoopIndex m_loops = 0;
    std::int32_t m_floats = 0;
};

TEST(Diagram, NoPassingIsLostAndNoneGoesThroughAThirdStrand) {
    constexpr test::KnownSeed kKnown[] = {
        {2, "loops that faced each other from the beginning went past each other when a yarn lay between"},
        {55, "the same"},
    };
    test::forRandomPrograms(
        40, {.operations = 150}, [](const Program& program) { return Observer(program).firstFault(); },
        kKnown);
}

} // namespace
} // namespace knittsim::fabric
