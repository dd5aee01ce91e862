#include "core/fabric/passing_book.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace knittsim::fabric {

namespace {

using List = std::vector<std::int32_t>;

/// Number of entries behind `number`, looked for among the last ones only.
std::optional<std::size_t> countAfter(const List& on, std::int32_t number) {
    const std::size_t reach = std::min(on.size(), PassingBook::kReach + 1);
    for (std::size_t after = 0; after < reach; ++after) {
        if (on[on.size() - 1 - after] == number) {
            return after;
        }
    }
    return std::nullopt;
}

std::span<const std::int32_t> lastOf(const List& on, std::size_t count) {
    return std::span(on).last(count);
}

/// Those that are looked through.
std::span<const std::int32_t> latestOf(const List& on) {
    return lastOf(on, std::min(on.size(), PassingBook::kReach + 1));
}

/// +1 when `strand` moved to the right past the other one.
int directionOf(Strand strand, const Passing& passing) {
    return strand == passing.over ? passing.sign : -passing.sign;
}

} // namespace

PassingBook::List& PassingBook::list(Strand strand) {
    const auto i = static_cast<std::size_t>(strand.index);
    return strand.kind == Strand::Kind::Loop ? m_onLoop[i] : m_onFloat[i];
}

void PassingBook::pass(std::span<const Pair> pairs, OperationIndex operation, std::int32_t moment) {
    undoEldestFirst(pairs);
    m_inOrder = m_left;
    std::ranges::sort(m_inOrder);
    const std::size_t first = m_passings.size();
    for (const std::size_t i : m_inOrder) {
        m_passings.push_back({.over = pairs[i].over,
                              .under = pairs[i].under,
                              .operation = operation,
                              .sign = static_cast<std::int8_t>(pairs[i].sign),
                              .place = static_cast<float>(pairs[i].place),
                              .moment = moment});
    }
    while (!m_left.empty()) {
        const auto next = findFirst(pairs);
        const std::size_t i = *next;
        m_left.erase(next);
        const auto among = std::ranges::lower_bound(m_inOrder, i) - m_inOrder.begin();
        const auto number = static_cast<std::int32_t>(first) + static_cast<std::int32_t>(among);
        settle(pairs[i]);
        list(pairs[i].over).push_back(number);
        list(pairs[i].under).push_back(number);
    }
}

/// Of those that are left the first that comes to lie on its strands: by age, the same from either side, but
/// those that have an order along the bed in that order.
std::vector<std::size_t>::iterator PassingBook::findFirst(std::span<const Pair> pairs) {
    const auto first = std::ranges::find_if(m_left, [&](std::size_t i) {
        return std::ranges::none_of(m_left, [&](std::size_t k) { return isMetBefore(pairs[k], pairs[i]); });
    });
    return first == m_left.end() ? m_left.begin() : first;
}

/// Both are passings of one strand, and what it passes in `a` stands nearer on its way.
bool PassingBook::isMetBefore(const Pair& a, const Pair& b) const {
    const auto passes = [](const Pair& pair, Strand strand) {
        return pair.over == strand || pair.under == strand;
    };
    if (passes(b, a.over) == passes(b, a.under)) {
        return false;
    }
    const bool over = passes(b, a.over); // the strand that passes both
    const Strand near = over ? a.under : a.over;
    const Strand far = b.over == (over ? a.over : a.under) ? b.under : b.over;
    const std::int32_t last = findLast(near, far);
    const bool rightward = (a.sign > 0) == over;
    return last >= 0 && (directionOf(far, at(last)) > 0) == rightward;
}

/// The two that pass each other may have had no order until now. They had this one: what passed both at one
/// moment met the left one first on its way to the right.
void PassingBook::settle(const Pair& pair) {
    if (havePassed(pair.over, pair.under)) {
        return;
    }
    const Strand left = pair.sign > 0 ? pair.over : pair.under;
    const Strand right = pair.sign > 0 ? pair.under : pair.over;
    const auto onRight = latestOf(on(right));
    for (const std::int32_t number : latestOf(on(left))) {
        if (number == kBar) {
            continue;
        }
        const Strand strand = at(number).other(left);
        const auto twin = std::ranges::find_if(onRight, [&](std::int32_t n) {
            return n != kBar && at(n).moment == at(number).moment && at(n).other(right) == strand;
        });
        if (twin != onRight.end()) {
            const bool rightward = directionOf(strand, at(number)) > 0;
            putInOrder(strand, rightward ? number : *twin, rightward ? *twin : number);
        }
    }
}

/// Two passings of one moment, if what lies between them lets it.
void PassingBook::putInOrder(Strand strand, std::int32_t first, std::int32_t second) {
    List& passings = list(strand);
    const auto from = std::ranges::find(passings, second);
    const auto to = std::find(from, passings.end(), first);
    if (to == passings.end()) {
        return;
    }
    const auto canPass = [&](std::int32_t n) {
        return std::all_of(from + 1, to, [&](std::int32_t o) { return areUnordered(strand, n, o); });
    };
    if (canPass(second)) {
        std::rotate(from, from + 1, to + 1);
    } else if (canPass(first)) {
        std::rotate(from, to, to + 1);
    }
}

/// One pair may lie in the way of another, so it goes on until nothing changes. The elder ones first: an
/// order that does not depend on the side from which one looks.
void PassingBook::undoEldestFirst(std::span<const Pair> pairs) {
    m_left.resize(pairs.size());
    std::iota(m_left.begin(), m_left.end(), 0U);
    std::ranges::sort(m_left, {}, [&](std::size_t i) { return std::minmax(pairs[i].over, pairs[i].under); });
    std::size_t before = m_left.size() + 1;
    while (m_left.size() < before) {
        before = m_left.size();
        std::erase_if(m_left, [&](std::size_t i) { return undo(pairs[i]); });
    }
}

bool PassingBook::undo(const Pair& pair) {
    const std::int32_t number = findLast(pair.over, pair.under);
    if (number < 0) {
        return false;
    }
    const Passing last = at(number);
    if (!(last.over == pair.over) || last.sign != -pair.sign || !collectGap(last.over, number, m_gapOver) ||
        !collectGap(last.under, number, m_gapUnder) || m_gapOver.size() != m_gapUnder.size()) {
        return false;
    }
    const std::optional<Strand> slider = findSlider(last);
    if ((!slider && !m_gapOver.empty()) || !isGapClear(last)) {
        return false;
    }
    if (slider) {
        slide(last, *slider);
    }
    for (const Strand strand : {last.over, last.under}) {
        List& passings = list(strand);
        passings.erase(passings.end() - 1 - static_cast<std::ptrdiff_t>(*countAfter(passings, number)));
    }
    m_passings[static_cast<std::size_t>(number)].undone = true;
    return true;
}

/// The latest passing of the two strands, or -1.
std::int32_t PassingBook::findLast(Strand a, Strand b) const {
    const bool aIsShorter = on(a).size() <= on(b).size();
    const Strand shorter = aIsShorter ? a : b;
    const Strand longer = aIsShorter ? b : a;
    const auto latest = latestOf(on(shorter));
    const auto found = std::find_if(latest.rbegin(), latest.rend(), [&](std::int32_t number) {
        return number != kBar && at(number).other(shorter) == longer;
    });
    return found == latest.rend() ? -1 : *found;
}

/// The passings on a strand after `number`, but for those right behind it of the same moment. False when they
/// are too many or barred.
bool PassingBook::collectGap(Strand strand, std::int32_t number, List& gap) const {
    const List& passings = on(strand);
    const auto after = countAfter(passings, number);
    if (!after) {
        return false;
    }
    const auto rest = lastOf(passings, *after);
    const auto begin =
        std::ranges::find_if_not(rest, [&](std::int32_t n) { return areUnordered(strand, number, n); });
    gap.assign(begin, rest.end());
    return std::ranges::find(gap, kBar) == gap.end();
}

/// One of the two strands of `passing` that can be slid across all that lies in the gap above it.
std::optional<Strand> PassingBook::findSlider(const Passing& passing) const {
    if (m_gapOver.empty()) {
        return std::nullopt;
    }
    const auto isOnce = [&](const List& gap, Strand own, Strand strand) {
        return std::ranges::count_if(gap, [&](std::int32_t n) { return at(n).other(own) == strand; }) == 1;
    };
    for (const std::int32_t number : m_gapOver) {
        const Strand strand = at(number).other(passing.over);
        if (!isOnce(m_gapOver, passing.over, strand) || !isOnce(m_gapUnder, passing.under, strand) ||
            !runsThrough(passing, strand)) {
            return std::nullopt;
        }
    }
    // The elder one first: a rule that does not depend on the side from which one looks.
    const bool overFirst = passing.over < passing.under;
    for (const bool over : {overFirst, !overFirst}) {
        const Strand slider = over ? passing.over : passing.under;
        if (canSlide(slider, over ? m_gapOver : m_gapUnder)) {
            return slider;
        }
    }
    return std::nullopt;
}

/// `strand` comes into the gap past one of the two and leaves it past the other one.
bool PassingBook::runsThrough(const Passing& passing, Strand strand) const {
    const std::int32_t past = findLast(passing.over, strand);
    const std::int32_t pastUnder = findLast(passing.under, strand);
    if (past < 0 || pastUnder < 0 || directionOf(strand, at(past)) != directionOf(strand, at(pastUnder))) {
        return false;
    }
    if (at(past).over == strand && at(pastUnder).under == strand) {
        return false; // in front of the front one and behind the rear one
    }
    // The one that has gone to the right lies on the right hand side of the gap.
    const auto afterOver = countAfter(on(strand), past);
    const auto afterUnder = countAfter(on(strand), pastUnder);
    const bool underFirst = (directionOf(strand, at(past)) > 0) == (passing.sign > 0);
    return afterOver && afterUnder && (*afterUnder > *afterOver) == underFirst;
}

/// On no strand that runs through the gap lies anything else between its passings of the two.
bool PassingBook::isGapClear(const Passing& passing) {
    return std::ranges::all_of(m_gapOver, [&](std::int32_t number) {
        const Strand strand = at(number).other(passing.over);
        return gather(strand, passing.over, number, findLast(passing.under, strand));
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
            return *n != kBar && at(g).other(over) == at(*n).other(strand);
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

bool PassingBook::canSlide(Strand slider, const List& gap) const {
    const bool inFront = at(gap[0]).over == slider;
    return std::ranges::all_of(gap, [&](std::int32_t n) { return (at(n).over == slider) == inFront; });
}

bool PassingBook::areUnordered(Strand strand, std::int32_t a, std::int32_t b) const {
    return a != kBar && b != kBar && at(a).moment == at(b).moment &&
           findLast(at(a).other(strand), at(b).other(strand)) < 0;
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
/// other strand.
void PassingBook::slide(const Passing& passing, Strand slider) {
    const Strand fixed = passing.other(slider);
    List& onSlider = list(slider);
    auto next = onSlider.end() - static_cast<std::ptrdiff_t>(m_gapOver.size());
    for (const std::int32_t pastFixed : lastOf(on(fixed), m_gapOver.size())) {
        const Strand strand = at(pastFixed).other(fixed);
        const auto found =
            std::find_if(next, onSlider.end(), [&](auto n) { return at(n).other(slider) == strand; });
        std::iter_swap(next, found);
        swapOrder(strand, passing.over, *next, pastFixed);
        ++next;
    }
}

} // namespace knittsim::fabric
