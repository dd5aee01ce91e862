#include "core/formats/program_sink.h"

#include "core/formats/text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace knittsim::formats {

using machine::Operation;
using machine::OperationKind;

void ProgramSink::add(Operation op) {
    if (m_program.operations.size() >= kMaxOperations) {
        if (!m_full) {
            m_problems.error("KS0125", {m_line, 1}, {std::to_string(kMaxOperations)});
            m_full = true;
        }
        return;
    }
    op.line = m_line;
    m_program.operations.push_back(op);
}

void ProgramSink::carriers(OperationKind kind, const machine::CarrierSet& carriers) {
    Operation op;
    op.kind = kind;
    op.carriers = carriers;
    add(op);
}

void ProgramSink::rack(double rack) {
    if (rack == m_rack) {
        return;
    }
    m_rack = rack;
    Operation op;
    op.kind = OperationKind::Rack;
    op.value = rack;
    add(op);
}

void ProgramSink::stitchNumber(double number) {
    if (number == m_stitch) {
        return;
    }
    m_stitch = number;
    Operation op;
    op.kind = OperationKind::StitchNumber;
    op.value = number;
    add(op);
}

std::int32_t ProgramSink::keep(std::string text) {
    // A text has to fit into a line of knitout, where ';' begins a comment.
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == ';' || (c >= '\0' && c < ' '); }, ' ');
    text = std::string(trim(text));
    if (text.empty()) {
        return -1;
    }
    m_program.texts.push_back(std::move(text));
    return static_cast<std::int32_t>(m_program.texts.size()) - 1;
}

void ProgramSink::extension(const std::string& text) {
    Operation op;
    op.kind = OperationKind::Extension;
    op.text = keep(text);
    add(op);
}

void ProgramSink::pause(const std::string& message) {
    Operation op;
    op.kind = OperationKind::Pause;
    op.text = keep(message);
    add(op);
}

void ProgramSink::stitch(OperationKind kind, machine::Needle needle, machine::Direction direction,
                         const machine::CarrierSet& carriers) {
    Operation op;
    op.kind = kind;
    op.needle = needle;
    op.carriers = carriers;
    op.direction = direction;
    if (carriers.empty()) {
        if (kind == OperationKind::Miss) {
            return;
        }
        op.kind = kind == OperationKind::Knit ? OperationKind::Drop : OperationKind::Amiss;
        op.direction = machine::Direction::Right;
    }
    add(op);
}

void ProgramSink::transfer(machine::Needle from, machine::Bed to, machine::Direction direction,
                           const machine::CarrierSet& carriers) {
    const int rack = static_cast<int>(std::floor(m_rack));
    Operation op;
    op.kind = carriers.empty() ? OperationKind::Xfer : OperationKind::Split;
    op.needle = from;
    op.target = {to, isFront(from.bed) ? from.index - rack : from.index + rack};
    op.carriers = carriers;
    op.direction = carriers.empty() ? machine::Direction::Right : direction;
    add(op);
}

} // namespace knittsim::formats
