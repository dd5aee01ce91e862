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

/// Of two loops.
std::uint64_t code(Strand over, Strand under) {
    return static_cast<std::uint64_t>(over.index) << 32 | static_cast<std::uint32_t>(under.index);
}

} // namespace

PassingBook::List& PassingBook::list(Strand strand) {
    const auto i = static_cast<std::size_t>(strand.index);
    return strand.kind == Strand::Kind::Loop ? m_onLoop[i] : m_onFloat[i];
}

void PassingBook::pass(std::span<const Pair> pairs, OperationIndex operation, std::int32_t moment) {
    undoEldestFirst(pairs);
    enter(pairs, operation, moment);
}

bool PassingBook::passBack(std::span<const Pair> pairs, OperationIndex operation, std::int32_t moment) {
    undoEldestFirst(pairs);
    const auto isLeft = [&](std::size_t i) { return std::ranges::find(m_left, i) != m_left.end(); };
    if (!isLeft(0)) {
        enter(pairs, operation, moment);
        return true;
    }
    std::vector<Pair> again;
    for (std::size_t i = 1; i < pairs.size(); ++i) {
        if (!isLeft(i)) {
            again.push_back(pairs[i]);
            again.back().sign *= -1;
        }
    }
    pass(again, operation, moment);
    return false;
}

/// Those that are left.
void PassingBook::enter(std::span<const Pair> pairs, OperationIndex operation, std::int32_t moment) {
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
        if (sideOf(pairs[i].over, pairs[i].under) == 0) {
            const bool right = pairs[i].sign > 0;
            settle(right ? pairs[i].over : pairs[i].under, right ? pairs[i].under : pairs[i].over);
        }
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
    const bool rightward = (a.sign > 0) == over;
    return sideOf(far, near) == (rightward ? 1 : -1);
}

/// Where `a` stands: 1 on the right of `b`, -1 on its left, 0 when they have no order.
int PassingBook::sideOf(Strand a, Strand b) const {
    if (const std::int32_t last = findLast(a, b); last >= 0) {
        return at(last).directionOf(a) > 0 ? 1 : -1;
    }
    if (a.kind != Strand::Kind::Loop || b.kind != Strand::Kind::Loop) {
        return 0;
    }
    if (const auto found = m_began.find(code(a, b)); found != m_began.end()) {
        return found->second;
    }
    const auto found = m_began.find(code(b, a));
    return found == m_began.end() ? 0 : -found->second;
}

/// The two had no order until now. They had this one: what passed both at one moment met the left one first
/// on its way to the right.
void PassingBook::settle(Strand left, Strand right) {
    const auto onRight = latestOf(on(right));
    for (const std::int32_t number : latestOf(on(left))) {
        if (isBar(number)) {
            continue;
        }
        const Strand strand = at(number).other(left);
        const auto twin = std::ranges::find_if(onRight, [&](std::int32_t n) {
            return !isBar(n) && at(n).moment == at(number).moment && at(n).other(right) == strand;
        });
        if (twin != onRight.end()) {
            const bool rightward = at(number).directionOf(strand) > 0;
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
        !collectGap(last.under, number, m_gapUnder) || !slideAway(last)) {
        return false;
    }
    for (const Strand strand : {last.over, last.under}) {
        List& passings = list(strand);
        passings.erase(passings.end() - 1 - static_cast<std::ptrdiff_t>(*countAfter(passings, number)));
    }
    m_passings[static_cast<std::size_t>(number)].undone = true;
    return true;
}

void PassingBook::part(const Pair& pair) {
    if (sideOf(pair.over, pair.under) != 0) {
        return;
    }
    const bool right = pair.sign > 0;
    settle(right ? pair.under : pair.over, right ? pair.over : pair.under);
    m_began[code(pair.over, pair.under)] = pair.sign;
}

bool PassingBook::isFree(const Pair& pair) const {
    return pair.over.kind == Strand::Kind::Loop && pair.under.kind == Strand::Kind::Loop &&
           m_began.contains(code(pair.over, pair.under)) && !havePassed(pair.over, pair.under);
}

bool PassingBook::meetAgain(std::span<const Pair> pairs) {
    List gap;
    const auto nothingPassed = [&](Strand strand, Strand younger) {
        return collectSince(younger, strand, gap) && gap.empty();
    };
    const bool asBefore = std::ranges::all_of(pairs, [&](const Pair& pair) {
        const Strand younger = std::max(pair.over, pair.under);
        return isFree(pair) && nothingPassed(pair.over, younger) && nothingPassed(pair.under, younger);
    });
    for (const Pair& pair : pairs) {
        if (asBefore) {
            m_began.erase(code(pair.over, pair.under));
        }
    }
    return asBefore;
}

bool PassingBook::turnRound(const Pair& pair) {
    const Strand younger = std::max(pair.over, pair.under);
    const Passing before{
        .over = pair.over, .under = pair.under, .sign = static_cast<std::int8_t>(-pair.sign)};
    if (!collectSince(younger, pair.over, m_gapOver) || !collectSince(younger, pair.under, m_gapUnder) ||
        !slideAway(before)) {
        return false;
    }
    m_began[code(pair.over, pair.under)] = pair.sign;
    return true;
}

/// The latest passing of the two strands, or -1.
std::int32_t PassingBook::findLast(Strand a, Strand b) const {
    const bool aIsShorter = on(a).size() <= on(b).size();
    const Strand shorter = aIsShorter ? a : b;
    const Strand longer = aIsShorter ? b : a;
    const auto latest = latestOf(on(shorter));
    const auto found = std::find_if(latest.rbegin(), latest.rend(), [&](std::int32_t number) {
        return !isBar(number) && at(number).other(shorter) == longer;
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
    return std::ranges::none_of(gap, isBar);
}

/// The passings on a strand since `younger` was made. False when they are too many or barred.
bool PassingBook::collectSince(Strand younger, Strand strand, List& gap) const {
    const List& passings = on(strand);
    const Made& made = m_made[static_cast<std::size_t>(younger.index)];
    const auto isBefore = [&](std::int32_t n) {
        return isBar(n) ? -1 - n <= made.operation : n < made.first;
    };
    const auto begin = std::find_if(passings.rbegin(), passings.rend(), isBefore).base();
    gap.assign(begin, passings.end());
    return gap.size() <= kReach && std::ranges::none_of(gap, isBar);
}

bool PassingBook::areUnordered(Strand strand, std::int32_t a, std::int32_t b) const {
    return !isBar(a) && !isBar(b) && at(a).moment == at(b).moment &&
           sideOf(at(a).other(strand), at(b).other(strand)) == 0;
}

} // namespace knittsim::fabric
