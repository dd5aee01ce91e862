#include "core/pattern/program_course.h"

#include <algorithm>
#include <set>

namespace knittsim::pattern {

using machine::Operation;
using machine::OperationKind;

bool namesNeedle(OperationKind kind) {
    return machine::carriesYarn(kind) || kind == OperationKind::Drop || kind == OperationKind::Amiss ||
           kind == OperationKind::Xfer || kind == OperationKind::YarnIn || kind == OperationKind::YarnOut;
}

bool namesTarget(OperationKind kind) {
    return kind == OperationKind::Xfer || kind == OperationKind::Split;
}

bool keepsProgram(const Course& course) {
    return course.program && std::ranges::all_of(course.program->moves, [&](const LoopMove& move) {
               return std::ranges::find(course.moves, move) != course.moves.end();
           });
}

bool isAsInProgram(const Chart& chart, int wale, int course) {
    const Course& own = chart.course(course);
    return keepsProgram(own) && own.program->cells[static_cast<std::size_t>(wale)] == chart.at(wale, course);
}

std::vector<LoopMove> addedMoves(const Course& course) {
    std::vector<LoopMove> added = course.moves;
    if (keepsProgram(course)) {
        std::erase_if(added, [&](const LoopMove& move) {
            const auto& own = course.program->moves;
            return std::ranges::find(own, move) != own.end();
        });
    }
    return added;
}

std::vector<int> yarnsOf(const ProgramCourse& course) {
    std::set<int> yarns;
    for (const Operation& op : course.operations) {
        yarns.insert(op.carriers.begin(), op.carriers.end());
    }
    return {yarns.begin(), yarns.end()};
}

namespace {

/// `shift` gets every wale that the course names.
template<class Shift> void shiftWales(ProgramCourse& course, const Shift& shift) {
    for (Operation& op : course.operations) {
        if (namesNeedle(op.kind)) {
            shift(op.needle.index);
        }
        if (namesTarget(op.kind)) {
            shift(op.target.index);
        }
    }
    for (LoopMove& move : course.moves) {
        shift(move.from);
        shift(move.to);
    }
}

} // namespace

std::shared_ptr<const ProgramCourse> withWales(const ProgramCourse& course, int wale, int count) {
    auto changed = std::make_shared<ProgramCourse>(course);
    shiftWales(*changed, [&](auto& index) { index += index >= wale ? count : 0; });
    const auto some = static_cast<std::size_t>(count);
    changed->cells.insert(changed->cells.begin() + wale, some, Cell{Stitch::Empty, 0});
    changed->loops.insert(changed->loops.begin() + wale, some, std::uint8_t{0});
    return changed;
}

std::shared_ptr<const ProgramCourse> withoutWales(const ProgramCourse& course, int wale, int count) {
    auto changed = std::make_shared<ProgramCourse>(course);
    const auto gone = [&](int index) { return index >= wale && index < wale + count; };
    std::erase_if(changed->operations, [&](const Operation& op) {
        return (namesNeedle(op.kind) && gone(op.needle.index)) ||
               (namesTarget(op.kind) && gone(op.target.index));
    });
    std::erase_if(changed->moves, [&](const LoopMove& move) { return gone(move.from) || gone(move.to); });
    shiftWales(*changed, [&](auto& index) { index -= index >= wale ? count : 0; });
    changed->cells.erase(changed->cells.begin() + wale, changed->cells.begin() + wale + count);
    changed->loops.erase(changed->loops.begin() + wale, changed->loops.begin() + wale + count);
    return changed;
}

} // namespace knittsim::pattern
