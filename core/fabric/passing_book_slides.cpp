// How a crossing is slid away from beneath what runs through the gap above it: third Reidemeister moves.

#include "core/fabric/passing_book.h"

#include <algorithm>

namespace knittsim::fabric {

/// Slides `passing` across all that lies in the gap above it.
bool PassingBook::slideAway(const Passing& passing) {
    if (m_gapOver.size() != m_gapUnder.size() || !isGapClear(passing)) {
        return false;
    }
    const std::optional<Strand> slider = findSlider(passing);
    if (slider) {
        slide(passing, *slider);
    }
    return slider.has_value();
}

/// Finds for everything in the gap on the one strand of `passing` what it is on the other one: what runs
/// through for the first time passes either of them for the first time, and so on.
bool PassingBook::pairGap(const Passing& passing) {
    m_through.clear();
    m_unpaired = m_gapUnder;
    for (const std::int32_t number : m_gapOver) {
        const Strand strand = at(number).other(passing.over);
        const auto twin = std::ranges::find_if(
            m_unpaired, [&](std::int32_t n) { return at(n).other(passing.under) == strand; });
        if (twin == m_unpaired.end()) {
            return false;
        }
        m_through.push_back({strand, number, *twin});
        m_unpaired.erase(twin);
    }
    return m_unpaired.empty();
}

/// One of the two strands of `passing` that can be slid across all that lies in the gap above it.
std::optional<Strand> PassingBook::findSlider(const Passing& passing) const {
    // The elder one first: a rule that does not depend on the side from which one looks.
    const bool overFirst = passing.over < passing.under;
    for (const bool over : {overFirst, !overFirst}) {
        if (canSlide(over ? &Through::over : &Through::under)) {
            return over ? passing.over : passing.under;
        }
    }
    return std::nullopt;
}

/// Across every place in the gap where two strands pass each other that run through it.
bool PassingBook::canSlide(std::int32_t Through::*onSlider) const {
    for (const Through& a : m_through) {
        const auto [low, high] = std::minmax(placeOn(a.strand, a.over), placeOn(a.strand, a.under));
        for (std::size_t place = low + 1; place < high; ++place) {
            const Passing& inside = at(on(a.strand)[place]);
            const auto b = std::ranges::find(m_through, inside.other(a.strand), &Through::strand);
            if (b == m_through.end() || !(a.strand == inside.over)) {
                continue;
            }
            // Not in front of the front one and behind the rear one.
            if (at(a.*onSlider).under == a.strand && at((*b).*onSlider).over == b->strand) {
                return false;
            }
        }
    }
    return true;
}

std::size_t PassingBook::placeOn(Strand strand, std::int32_t number) const {
    const List& passings = on(strand);
    return static_cast<std::size_t>(passings.rend() - std::find(passings.rbegin(), passings.rend(), number)) -
           1;
}

/// A strand comes into the gap past one of the two and leaves it past the other one.
bool PassingBook::runsThrough(const Passing& passing, const Through& through) const {
    const Passing& over = at(through.over);
    const Passing& under = at(through.under);
    const int direction = over.directionOf(through.strand);
    if (direction != under.directionOf(through.strand)) {
        return false;
    }
    if (over.over == through.strand && under.under == through.strand) {
        return false; // in front of the front one and behind the rear one
    }
    // The one that has gone to the right lies on the right hand side of the gap.
    const bool underFirst = (direction > 0) == (passing.sign > 0);
    return (placeOn(through.strand, through.under) < placeOn(through.strand, through.over)) == underFirst;
}

/// All in the gap runs through it, and on no strand that does lies anything else between its passings of the
/// two.
bool PassingBook::isGapClear(const Passing& passing) {
    return pairGap(passing) && std::ranges::all_of(m_through, [&](const Through& through) {
               return runsThrough(passing, through) &&
                      gather(through.strand, passing.over, through.over, through.under);
           });
}

/// Finds the passings of `strand` from `a` to `b` and an order of them in which nothing lies between the two
/// but passings of strands that run through the gap, too. False when there is none.
bool PassingBook::gather(Strand strand, Strand over, std::int32_t a, std::int32_t b) {
    const List& passings = on(strand);
    const auto isOneOfTheTwo = [&](std::int32_t n) { return n == a || n == b; };
    const auto near = passings.end() - static_cast<std::ptrdiff_t>(std::min(passings.size(), kReach + 1));
    const auto first = std::find_if(near, passings.end(), isOneOfTheTwo);
    const auto second =
        first == passings.end() ? first : std::find_if(first + 1, passings.end(), isOneOfTheTwo);
    if (second == passings.end()) {
        return false;
    }
    m_gathered.begin = static_cast<std::size_t>(first - passings.begin());
    m_gathered.before.clear();
    m_gathered.between.clear();
    m_gathered.after.clear();
    const auto canPassAll = [&](std::int32_t n, const List& others) {
        return std::ranges::all_of(others, [&](std::int32_t o) { return areUnordered(strand, n, o); });
    };
    for (auto n = first + 1; n != second; ++n) {
        const auto runsThere = [&](std::int32_t g) {
            return !isBar(*n) && at(g).other(over) == at(*n).other(strand);
        };
        if (areUnordered(strand, *first, *n) && canPassAll(*n, m_gathered.between) &&
            canPassAll(*n, m_gathered.after)) {
            m_gathered.before.push_back(*n);
        } else if (areUnordered(strand, *second, *n)) {
            m_gathered.after.push_back(*n);
        } else if (std::ranges::any_of(m_gapOver, runsThere) && canPassAll(*n, m_gathered.after)) {
            m_gathered.between.push_back(*n);
        } else {
            return false;
        }
    }
    return true;
}

/// Puts `moved` right behind `fixed` if it came before, right before it if it came behind.
void PassingBook::swapOrder(Strand strand, Strand over, std::int32_t moved, std::int32_t fixed) {
    if (!gather(strand, over, moved, fixed)) {
        return;
    }
    List& passings = list(strand);
    const auto begin = passings.begin() + static_cast<std::ptrdiff_t>(m_gathered.begin);
    const bool movedFirst = *begin == moved;
    auto next = std::ranges::copy(m_gathered.before, begin).out;
    const auto put = [&](std::int32_t number) { *next++ = number; };
    if (!movedFirst) {
        put(moved);
        put(fixed);
    }
    next = std::ranges::copy(m_gathered.between, next).out;
    if (movedFirst) {
        put(fixed);
        put(moved);
    }
    std::ranges::copy(m_gathered.after, next);
}

/// The last passings of `slider` are those in the gap above `passing`. Moves them to the other side of the
/// other strand, in the order in which they lie there.
void PassingBook::slide(const Passing& passing, Strand slider) {
    const bool over = slider == passing.over;
    m_onSlider.clear();
    for (const std::int32_t fixed : over ? m_gapUnder : m_gapOver) {
        const auto through = std::ranges::find(m_through, fixed, over ? &Through::under : &Through::over);
        const std::int32_t moved = over ? through->over : through->under;
        swapOrder(through->strand, passing.over, moved, fixed);
        m_onSlider.push_back(moved);
    }
    std::ranges::copy_backward(m_onSlider, list(slider).end());
}

} // namespace knittsim::fabric
