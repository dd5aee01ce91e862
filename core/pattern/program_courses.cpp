#include "core/pattern/program_courses.h"

#include "core/pattern/backed_cells.h"
#include "core/pattern/course_works.h"
#include "core/pattern/held_loops.h"
#include "core/pattern/program_course.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace knittsim::pattern {

using machine::Bed;
using machine::Direction;
using machine::Needle;
using machine::Operation;
using machine::OperationKind;

namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

/// Neighbouring operations of one carrier set that go one way.
struct Pass {
    std::size_t first = 0;
    std::size_t end = 0;
    double rack = 0;
    bool join = false; ///< the last operation may be a tuck on the next zone
};

bool isTuckPass(const std::vector<Operation>& operations, const Pass& pass) {
    return std::all_of(operations.begin() + static_cast<std::ptrdiff_t>(pass.first),
                       operations.begin() + static_cast<std::ptrdiff_t>(pass.end),
                       [](const Operation& op) { return op.kind == OperationKind::Tuck; });
}

std::vector<Pass> passesOf(const std::vector<Operation>& operations) {
    std::vector<Pass> passes;
    double rack = 0;
    double last = 0;
    for (std::size_t i = 0; i < operations.size(); ++i) {
        const Operation& op = operations[i];
        rack = op.kind == OperationKind::Rack ? op.value : rack;
        if (!machine::carriesYarn(op.kind)) {
            continue;
        }
        const double position = positionPitches(op.needle, rack);
        const Operation* before = passes.empty() ? nullptr : &operations[passes.back().end - 1];
        if (before && passes.back().end == i && before->carriers == op.carriers &&
            before->direction == op.direction && sign(op.direction) * (position - last) >= 0) {
            ++passes.back().end;
        } else {
            passes.push_back({i, i + 1, rack, false});
        }
        last = position;
    }
    for (Pass& pass : passes) {
        const Operation& end = operations[pass.end - 1];
        const auto sameWale = [&](const Operation& op) { return op.needle.index == end.needle.index; };
        const auto first = operations.begin() + static_cast<std::ptrdiff_t>(pass.first);
        const auto last = operations.begin() + static_cast<std::ptrdiff_t>(pass.end) - 1;
        pass.join = end.kind == OperationKind::Tuck && first != last &&
                    (last - 1)->needle.index + sign(end.direction) == end.needle.index &&
                    std::none_of(first, last, sameWale);
    }
    return passes;
}

/// Gathers passes into courses and says what each makes.
class Segmenter {
public:
    Segmenter(const LiftInput& input, const CourseRules& rules)
        : m_input(input), m_operations(input.operations), m_rules(rules), m_passes(passesOf(m_operations)),
          m_held(input.wales), m_worked(at(input.wales)), m_seen(at(input.wales)),
          m_dropped(at(input.wales), -1) {
        m_scratch = Chart(input.wales, 0);
        m_scratch.beds = BedUse::Double;
        m_scratch.yarns = input.yarns;
    }

    std::vector<ProgramSegment> run() {
        std::size_t pass = m_rules.castOn ? skipCastOn() : 0;
        std::size_t endOfBacked = 0; // pass after the present course, if that has a back
        for (bool begin = true; pass < m_passes.size(); ++pass, begin = false) {
            bool begins = begin;
            if (begin) {
                m_segments.emplace_back();
            } else if (pass < endOfBacked
                           ? false
                           : pass == endOfBacked || beginsCourse(m_passes[pass], m_passes[pass - 1])) {
                const std::size_t border = borderBefore(m_passes[pass], m_passes[pass - 1]);
                close(border);
                m_segments.emplace_back().first = border;
                begins = true;
            }
            if (begins && m_rules.backing) {
                endOfBacked = pass + backedPasses(pass);
                m_backed = endOfBacked > pass;
            }
            take(m_passes[pass]);
        }
        if (!m_passes.empty()) {
            close(afterYarns(m_passes.back().end, m_operations.size()));
        }
        return std::move(m_segments);
    }

private:
    /// What the present course does on one needle.
    struct Work {
        int course = -1; ///< that this belongs to
        OperationKind kind = OperationKind::Miss;
        int yarn = 0;
        bool sure = false; ///< not a join
    };
    using Works = std::array<Work, 2>; ///< by bed

    struct CarrierUse {
        int course = -1;
        Direction direction = Direction::Right;
        double position = 0;
    };

    int course() const { return static_cast<int>(m_segments.size()) - 1; }
    Works& works(int wale) { return m_worked[at(wale)]; }
    static std::size_t side(Needle needle) { return machine::isFront(needle.bed) ? 0 : 1; }

    /// Passes that only lay yarn into empty needles.
    std::size_t skipCastOn() {
        std::size_t count = 0;
        HeldLoops held(m_input.wales);
        for (; count + 1 < m_passes.size(); ++count) {
            const Pass& pass = m_passes[count];
            const auto isHeld = [&](std::size_t i) {
                const Needle needle = m_operations[i].needle;
                return ((held.bedsOf(needle.index) >> static_cast<unsigned>(needle.bed)) & 1U) != 0;
            };
            bool fits = isTuckPass(m_operations, pass) &&
                        m_operations[pass.first].carriers == m_operations[m_passes[0].first].carriers;
            for (std::size_t i = pass.first; fits && i < pass.end; ++i) {
                fits = !isHeld(i);
            }
            if (!fits) {
                break;
            }
            for (std::size_t i = pass.first; i < pass.end; ++i) {
                held.apply(m_operations[i]);
            }
        }
        return count;
    }

    /// How many passes from this one on are one course with a back; 0: none.
    std::size_t backedPasses(std::size_t first) {
        std::size_t end = first;
        while (end < m_passes.size() && (end == first || mayFollow(m_passes[end], m_passes[end - 1])) &&
               m_operations[m_passes[end].first].carriers.size() == 1) {
            ++end;
        }
        const std::size_t most = end;
        while (end > first && !((end == most || meets(first, end)) && areBacked(first, end))) {
            --end;
        }
        return end - first;
    }

    /// Pass `end` works a wale that those from `first` on have worked; else it could be in their course.
    bool meets(std::size_t first, std::size_t end) const {
        std::vector<bool> worked(at(m_input.wales));
        for (std::size_t i = m_passes[first].first; i < m_passes[end - 1].end; ++i) {
            if (machine::carriesYarn(m_operations[i].kind)) {
                worked[at(m_operations[i].needle.index)] = true;
            }
        }
        const auto from = m_operations.begin();
        return std::any_of(from + static_cast<std::ptrdiff_t>(m_passes[end].first),
                           from + static_cast<std::ptrdiff_t>(m_passes[end].end),
                           [&](const Operation& op) { return worked[at(op.needle.index)]; });
    }

    /// In a course with a back the yarns come in their order and nothing is moved between them.
    bool mayFollow(const Pass& pass, const Pass& before) const {
        const auto prepares = [](const Operation& op) {
            return op.kind == OperationKind::StitchNumber || op.kind == OperationKind::StitchSize ||
                   op.kind == OperationKind::Xfer || op.kind == OperationKind::Rack ||
                   op.kind == OperationKind::Drop;
        };
        const auto from = m_operations.begin();
        return m_operations[pass.first].carriers[0] > m_operations[before.first].carriers[0] &&
               std::none_of(from + static_cast<std::ptrdiff_t>(before.end),
                            from + static_cast<std::ptrdiff_t>(pass.first), prepares);
    }

    bool areBacked(std::size_t first, std::size_t end) {
        std::vector<std::span<const Operation>> passes;
        for (std::size_t i = first; i < end; ++i) {
            passes.emplace_back(m_operations.data() + m_passes[i].first,
                                m_operations.data() + m_passes[i].end);
        }
        const auto height = static_cast<std::size_t>(course()) + 1;
        m_scratch.courses.resize(height);
        m_scratch.cells.resize(height * at(m_input.wales));
        return areBackedCourse(m_scratch, course(), m_passes[first].rack, passes);
    }

    /// No join. In front of a back there is none.
    bool isSure(const Pass& pass, std::size_t i) const {
        return !m_rules.zones || !pass.join || i + 1 < pass.end || m_backed;
    }

    bool overlaps(const Pass& pass) {
        for (std::size_t i = pass.first; i < pass.end; ++i) {
            const Operation& op = m_operations[i];
            if (!isSure(pass, i) || (op.kind == OperationKind::Miss && !m_rules.missesWork)) {
                continue;
            }
            const Works& there = works(op.needle.index);
            for (std::size_t bed = 0; bed < there.size(); ++bed) {
                if (there[bed].course == course() && there[bed].sure &&
                    (there[bed].kind != OperationKind::Miss || m_rules.missesWork)) {
                    return true;
                }
            }
        }
        return false;
    }

    bool beginsCourse(const Pass& pass, const Pass& before) {
        const Operation& first = m_operations[pass.first];
        const Operation& earlier = m_operations[before.first];
        if (!m_rules.zones && !first.carriers.empty() && !earlier.carriers.empty() &&
            first.carriers[0] < earlier.carriers[0]) {
            return true;
        }
        bool moved = false;
        for (std::size_t i = before.end; i < pass.first; ++i) {
            const OperationKind kind = m_operations[i].kind;
            if (kind == OperationKind::StitchNumber || kind == OperationKind::StitchSize) {
                return true;
            }
            moved = moved || kind == OperationKind::Xfer || kind == OperationKind::Rack;
        }
        for (const int yarn : first.carriers) {
            const CarrierUse& use = m_use[at(yarn)];
            const bool used = use.course == course();
            const double way =
                sign(first.direction) * (positionPitches(first.needle, pass.rack) - use.position);
            if (used ? (use.direction != first.direction || way <= 0) : moved) {
                return true;
            }
        }
        return overlaps(pass);
    }

    /// Yarns are released and leave at the end of a course; all else prepares the next.
    std::size_t afterYarns(std::size_t first, std::size_t end) const {
        const auto ends = [](OperationKind kind) {
            return kind == OperationKind::ReleaseHook || kind == OperationKind::Out ||
                   kind == OperationKind::OutHook || kind == OperationKind::YarnOut;
        };
        while (first < end && ends(m_operations[first].kind)) {
            ++first;
        }
        return first;
    }

    std::size_t borderBefore(const Pass& pass, const Pass& before) const {
        return afterYarns(before.end, pass.first);
    }

    void take(const Pass& pass) {
        ProgramSegment& segment = m_segments.back();
        segment.rack = pass.rack;
        for (std::size_t i = pass.first; i < pass.end; ++i) {
            const Operation& op = m_operations[i];
            Work& work = works(op.needle.index)[side(op.needle)];
            const bool sure = isSure(pass, i);
            segment.joins = segment.joins || !sure;
            const OperationKind kind = op.kind == OperationKind::Split ? OperationKind::Knit : op.kind;
            const auto rank = [](OperationKind k, bool isSure) {
                return k == OperationKind::Knit ? 3 : k == OperationKind::Tuck ? (isSure ? 2 : 0) : 1;
            };
            const int yarn = op.carriers.empty() ? 0 : op.carriers[0];
            if (work.course != course() || rank(kind, sure) > rank(work.kind, work.sure)) {
                work = {course(), kind, yarn, sure};
            }
        }
        const Operation& last = m_operations[pass.end - 1];
        for (const int yarn : last.carriers) {
            m_use[at(yarn)] = {course(), last.direction, positionPitches(last.needle, pass.rack)};
        }
    }

    void close(std::size_t end) {
        ProgramSegment& segment = m_segments.back();
        segment.end = end;
        followLoops(segment);
        segment.cells.resize(at(m_input.wales));
        for (int wale = 0; wale < m_input.wales; ++wale) {
            segment.cells[at(wale)] = cellOf(wale);
        }
    }

    /// A wale that has its loops now on one bed, now on the other.
    static Cell onOneBed(Cell cell, const WaleWork& work) {
        switch (cell.stitch) {
        case Stitch::TuckKnit:
            return {Stitch::Purl, static_cast<std::uint8_t>(work[1]->yarn)};
        case Stitch::TuckBoth:
        case Stitch::RearTuck:
            return {Stitch::Tuck, cell.yarn};
        case Stitch::RearMiss:
            return {Stitch::Miss, cell.yarn};
        default:
            return cell;
        }
    }

    Cell cellOf(int wale) {
        Works here = works(wale);
        for (Work& work : here) {
            work.course = work.course == course() ? course() : -1;
        }
        // A join counts only where nothing else is done on the wale.
        for (std::size_t bed = 0; bed < 2; ++bed) {
            if (here[bed].course >= 0 && !here[bed].sure && here[1 - bed].course >= 0) {
                here[bed].course = -1;
            }
        }
        WaleWork work;
        for (std::size_t bed = 0; bed < 2; ++bed) {
            if (here[bed].course >= 0) {
                work[bed] = NeedleWork{here[bed].kind, here[bed].yarn};
            }
        }
        if (const auto cell = cellOnTwoBeds(work, m_rules.backing)) {
            return m_rules.doubleBeds ? *cell : onOneBed(*cell, work);
        }
        if (m_dropped[at(wale)] == course()) {
            return {Stitch::Drop, 0};
        }
        return {m_held.any(wale) ? Stitch::Rest : Stitch::Empty, 0};
    }

    /// Which old loops went where, and what is held after the course.
    void followLoops(ProgramSegment& segment) {
        std::vector<LoopMove> arrived;
        std::vector<int> left; // origins, by the transfers that did not move them aside
        for (std::size_t i = segment.first; i < segment.end; ++i) {
            const Operation& op = m_operations[i];
            if (op.kind == OperationKind::StitchNumber && !segment.stitchNumber) {
                segment.stitchNumber = op.value;
            }
            if (op.kind == OperationKind::Xfer) {
                Seen& from = seenAt(op.needle);
                Seen& to = seenAt(op.target);
                if (from.origin >= 0) {
                    if (op.needle.index == op.target.index) {
                        left.push_back(from.origin);
                    } else {
                        std::erase_if(arrived, [&](const LoopMove& m) { return m.from == from.origin; });
                        arrived.push_back({from.origin, op.target.index});
                    }
                    to.origin = from.origin;
                    from.origin = -1;
                }
            } else if (machine::makesLoop(op.kind) || op.kind == OperationKind::Drop) {
                seenAt(op.needle).origin = -1;
            }
            if (op.kind == OperationKind::Drop) {
                m_dropped[at(op.needle.index)] = course();
            }
            m_held.apply(op);
        }
        std::erase_if(arrived, [](const LoopMove& move) { return move.from == move.to; });
        segment.moves = ordersOf(arrived, left);
    }

    /// A list of moves is carried out in two parts: first all loops leave for the rear bed, then they arrive
    /// racking by racking. Loops that were there already do not leave.
    static std::vector<std::vector<LoopMove>> ordersOf(const std::vector<LoopMove>& arrived,
                                                       const std::vector<int>& left) {
        std::vector<LoopMove> leaving;
        for (const int origin : left) {
            const auto found = std::ranges::find(arrived, origin, &LoopMove::from);
            if (found != arrived.end() && std::ranges::find(leaving, *found) == leaving.end()) {
                leaving.push_back(*found);
            }
        }
        const auto add = [](std::vector<LoopMove>& list, const LoopMove& move) {
            if (std::ranges::find(list, move) == list.end()) {
                list.push_back(move);
            }
        };
        std::vector<LoopMove> merged;
        for (const LoopMove& move : arrived) {
            const auto leaves = std::ranges::find(leaving, move);
            if (leaves != leaving.end()) {
                std::for_each(leaving.begin(), leaves + 1, [&](const LoopMove& m) { add(merged, m); });
            } else {
                add(merged, move);
            }
        }
        std::vector<LoopMove> leaversFirst = leaving;
        std::ranges::for_each(arrived, [&](const LoopMove& m) { add(leaversFirst, m); });
        std::vector<std::vector<LoopMove>> orders{merged};
        for (const auto& other : {leaversFirst, arrived}) {
            if (std::ranges::find(orders, other) == orders.end()) {
                orders.push_back(other);
            }
        }
        return orders;
    }

    struct Seen {
        int course = -1;
        int origin = -1; ///< wale of the old loop that hangs here; -1: none
    };

    Seen& seenAt(Needle needle) {
        Seen& seen = m_seen[at(needle.index)][static_cast<std::size_t>(needle.bed)];
        if (seen.course != course()) {
            const bool held = ((m_held.bedsOf(needle.index) >> static_cast<unsigned>(needle.bed)) & 1U) != 0;
            seen = {course(), held ? needle.index : -1};
        }
        return seen;
    }

    const LiftInput& m_input;
    const std::vector<Operation>& m_operations;
    const CourseRules& m_rules;
    std::vector<Pass> m_passes;
    HeldLoops m_held; ///< before the present course
    std::vector<Works> m_worked;
    std::vector<std::array<Seen, machine::kBedCount>> m_seen; ///< by wale and bed
    std::vector<int> m_dropped;                               ///< by wale: the last course that did
    std::array<CarrierUse, 256> m_use{};                      ///< by yarn
    bool m_backed = false;                                    ///< the present course has a back
    Chart m_scratch;                                          ///< to try courses with a back
    std::vector<ProgramSegment> m_segments;
};

} // namespace

std::vector<ProgramSegment> coursesOf(const LiftInput& input, const CourseRules& rules) {
    return Segmenter(input, rules).run();
}

} // namespace knittsim::pattern
