#include "core/pattern/program_builder.h"

#include "core/yarn/colour_text.h"

namespace knittsim::pattern {

using machine::CarrierIndex;
using machine::Direction;
using machine::Needle;
using machine::Operation;
using machine::OperationKind;

Operation& ProgramBuilder::add(OperationKind kind) {
    Operation& operation = m_program.operations.emplace_back();
    operation.kind = kind;
    return operation;
}

void ProgramBuilder::carrier(OperationKind kind, CarrierIndex carrier) {
    add(kind).carriers.push(carrier);
}

void ProgramBuilder::colour(CarrierIndex carrier, yarn::Colour colour) {
    Operation& operation = add(OperationKind::Colour);
    operation.carriers.push(carrier);
    operation.text = static_cast<std::int32_t>(m_program.texts.size());
    m_program.texts.push_back(yarn::colourText(colour));
}

void ProgramBuilder::stitchNumber(double number) {
    if (number != m_stitchNumber) {
        add(OperationKind::StitchNumber).value = number;
        m_stitchNumber = number;
    }
}

void ProgramBuilder::rack(double pitches) {
    if (pitches != m_rack) {
        add(OperationKind::Rack).value = pitches;
        m_rack = pitches;
    }
}

void ProgramBuilder::work(OperationKind kind, Direction direction, Needle needle, CarrierIndex carrier) {
    Operation& operation = add(kind);
    operation.direction = direction;
    operation.needle = placed(needle);
    operation.carriers.push(carrier);
}

void ProgramBuilder::transfer(Needle from, Needle to) {
    Operation& operation = add(OperationKind::Xfer);
    operation.needle = placed(from);
    operation.target = placed(to);
}

void ProgramBuilder::append(Operation operation, const machine::CarrierSet& carriers,
                            const std::string& text) {
    if (operation.kind == OperationKind::Rack) {
        rack(operation.value);
        return;
    }
    if (operation.kind == OperationKind::StitchNumber) {
        stitchNumber(operation.value);
        return;
    }
    operation.needle = placed(operation.needle);
    operation.target = placed(operation.target);
    operation.carriers = carriers;
    if (operation.text >= 0) {
        operation.text = static_cast<std::int32_t>(m_program.texts.size());
        m_program.texts.push_back(text);
    }
    if (operation.kind == OperationKind::StitchSize) {
        m_stitchNumber = -1;
    }
    m_program.operations.push_back(operation);
}

void ProgramBuilder::drop(Needle needle) {
    add(OperationKind::Drop).needle = placed(needle);
}

} // namespace knittsim::pattern
