#pragma once

#include "core/machine/program.h"
#include "core/yarn/yarn.h"

#include <string>

namespace knittsim::pattern {

/// Appends operations to a program. Rackings and stitch numbers are written only where they change.
class ProgramBuilder {
public:
    explicit ProgramBuilder(machine::Program& program) : m_program(program) {}

    void bringIn(machine::CarrierIndex carrier, machine::OperationKind kind);
    void takeOut(machine::CarrierIndex carrier, machine::OperationKind kind);
    void releaseHook(machine::CarrierIndex carrier);
    void colour(machine::CarrierIndex carrier, yarn::Colour colour);
    void stitchNumber(double number);
    void rack(double pitches);
    /// Knit, Tuck or Miss.
    void work(machine::OperationKind kind, machine::Direction direction, machine::Needle needle,
              machine::CarrierIndex carrier);
    void transfer(machine::Needle from, machine::Needle to);
    void drop(machine::Needle needle);

private:
    machine::Operation& add(machine::OperationKind kind);

    machine::Program& m_program;
    double m_rack = 0;
    double m_stitchNumber = -1;
};

} // namespace knittsim::pattern
