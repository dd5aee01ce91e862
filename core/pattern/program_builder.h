#pragma once

#include "core/machine/program.h"
#include "core/yarn/yarn.h"

namespace knittsim::pattern {

/// Appends operations to a program. Needles are given as wales and moved to `firstNeedle`; rackings and
/// stitch numbers are written only where they change.
class ProgramBuilder {
public:
    ProgramBuilder(machine::Program& program, int firstNeedle)
        : m_program(program), m_firstNeedle(firstNeedle) {}

    /// In, InHook, ReleaseHook, Out or OutHook.
    void carrier(machine::OperationKind kind, machine::CarrierIndex carrier);
    void colour(machine::CarrierIndex carrier, yarn::Colour colour);
    void stitchNumber(double number);
    void rack(double pitches);
    /// Knit, Tuck or Miss.
    void work(machine::OperationKind kind, machine::Direction direction, machine::Needle needle,
              machine::CarrierIndex carrier);
    void transfer(machine::Needle from, machine::Needle to);
    void drop(machine::Needle needle);
    /// Any operation, with its text; `carriers` are those of the machine.
    void append(machine::Operation operation, const machine::CarrierSet& carriers, const std::string& text);

    /// What a rewound program goes on from.
    struct Setting {
        double rack = 0;
        double stitchNumber = -1;
    };
    Setting setting() const { return {m_rack, m_stitchNumber}; }
    void rewind(const Setting& setting) {
        m_rack = setting.rack;
        m_stitchNumber = setting.stitchNumber;
    }

private:
    machine::Operation& add(machine::OperationKind kind);
    machine::Needle placed(machine::Needle needle) const {
        return {needle.bed, needle.index + m_firstNeedle};
    }

    machine::Program& m_program;
    int m_firstNeedle;
    double m_rack = 0;
    double m_stitchNumber = -1;
};

} // namespace knittsim::pattern
