#include "core/fabric/course_numbers.h"

#include "core/machine/emulator.h"

#include <algorithm>
#include <array>

namespace knittsim::fabric {

namespace {

/// By loop: the loop below it on the needle when the next loop came through both, -1 for none. A tuck lies on
/// it.
std::vector<machine::LoopIndex> loopsBelow(const machine::LoopTable& table) {
    std::vector<machine::LoopIndex> below(table.loops.size(), -1);
    for (std::size_t i = 0; i < table.loops.size(); ++i) {
        machine::LoopIndex last = -1;
        for (const machine::LoopIndex parent : table.parentsOf(static_cast<machine::LoopIndex>(i))) {
            below[static_cast<std::size_t>(parent)] = last < parent ? last : -1;
            last = parent;
        }
    }
    return below;
}

/// The last course of each needle.
class NeedleCourses {
public:
    std::int32_t courseOn(machine::Needle needle) const {
        const auto& row = m_rows[static_cast<std::size_t>(needle.bed)];
        const std::size_t i = place(needle);
        return i < row.size() ? row[i] : -1;
    }
    void add(machine::Needle needle, std::int32_t course) {
        auto& row = m_rows[static_cast<std::size_t>(needle.bed)];
        row.resize(std::max(row.size(), place(needle) + 1), -1);
        row[place(needle)] = course;
    }

private:
    static std::size_t place(machine::Needle needle) {
        return static_cast<std::size_t>(needle.index + machine::kMaxNeedleIndex);
    }
    std::array<std::vector<std::int32_t>, 4> m_rows;
};

/// Looks at the loops of one pass; loops of earlier passes have their course already.
class PassCourse {
public:
    void knit(std::int32_t below) { m_knit = below < 0 ? m_knit : std::max(m_knit, below + 1); }
    void tuck(std::int32_t below) { m_tuck = below < 0 ? m_tuck : std::max(m_tuck, below + 1); }
    void continues(std::int32_t course) { m_before = std::max(m_before, course); }

    /// A pass of tucks lies in the course above the loops that it lies on, or that its needles knitted before
    /// they were emptied; on needles that never knitted in the course of its yarn's last pass, or of their
    /// neighbours if that is higher.
    std::int32_t course() const {
        return m_knit >= 0 ? m_knit : m_tuck >= 0 ? m_tuck : std::max(m_before, 0);
    }

private:
    std::int32_t m_knit = -1;
    std::int32_t m_tuck = -1;
    std::int32_t m_before = -1;
};

/// Course of the loops that a loop is drawn through, -1 for none. Tucks count only among themselves: a tuck
/// over the join of two colours lies in the course above its needle's loop and must not lift the next course.
/// Loops from `first` on belong to the same pass and have no course yet.
std::int32_t courseBelow(const CourseNumbers& numbers, const machine::LoopTable& table,
                         machine::LoopIndex loop, std::size_t first) {
    std::int32_t knitted = -1;
    std::int32_t tucked = -1;
    for (const machine::LoopIndex parent : table.parentsOf(loop)) {
        const auto p = static_cast<std::size_t>(parent);
        if (p < first) {
            std::int32_t& course = table.loops[p].kind == machine::OperationKind::Tuck ? tucked : knitted;
            course = std::max(course, numbers.courseOf(table.loops[p].operation));
        }
    }
    return knitted >= 0 ? knitted : tucked;
}

} // namespace

CourseNumbers numberCourses(const machine::Timeline& timeline) {
    CourseNumbers numbers;
    numbers.passes = machine::findPasses(timeline.program());
    numbers.passOfOperation.assign(static_cast<std::size_t>(timeline.operationCount()), -1);
    numbers.courseOfPass.assign(numbers.passes.size(), 0);
    for (std::size_t p = 0; p < numbers.passes.size(); ++p) {
        const machine::Pass& pass = numbers.passes[p];
        std::fill_n(numbers.passOfOperation.begin() + pass.first, pass.count, static_cast<std::int32_t>(p));
    }

    const machine::LoopTable& table = timeline.loops();
    std::vector<std::int32_t> lastCourseOfYarn(static_cast<std::size_t>(timeline.finalState().yarnCount), -1);
    const std::vector<machine::LoopIndex> below = loopsBelow(table);
    NeedleCourses knitted;
    NeedleCourses any;
    std::size_t i = 0;
    while (i < table.loops.size()) {
        const std::int32_t passIndex =
            numbers.passOfOperation[static_cast<std::size_t>(table.loops[i].operation)];
        PassCourse pass;
        const std::size_t first = i;
        for (; i < table.loops.size(); ++i) {
            const machine::Loop& loop = table.loops[i];
            if (numbers.passOfOperation[static_cast<std::size_t>(loop.operation)] != passIndex) {
                break;
            }
            pass.continues(lastCourseOfYarn[static_cast<std::size_t>(loop.yarn)]);
            pass.knit(courseBelow(numbers, table, static_cast<machine::LoopIndex>(i), first));
            if (const auto lower = below[i]; lower >= 0 && static_cast<std::size_t>(lower) < first &&
                                             loop.kind == machine::OperationKind::Tuck) {
                pass.tuck(numbers.courseOf(table.loops[static_cast<std::size_t>(lower)].operation));
            } else if (lower < 0 && loop.parentCount == 0) {
                pass.tuck(knitted.courseOn(loop.needle));
                pass.continues(any.courseOn({loop.needle.bed, loop.needle.index - 1}));
                pass.continues(any.courseOn({loop.needle.bed, loop.needle.index + 1}));
            }
        }
        numbers.courseOfPass[static_cast<std::size_t>(passIndex)] = pass.course();
        for (std::size_t made = first; made < i; ++made) {
            lastCourseOfYarn[static_cast<std::size_t>(table.loops[made].yarn)] = pass.course();
            any.add(table.loops[made].needle, pass.course());
            if (table.loops[made].parentCount > 0) {
                knitted.add(table.loops[made].needle, pass.course());
            }
        }
    }
    return numbers;
}

} // namespace knittsim::fabric
