#pragma once

#include "core/formats/problems.h"
#include "core/machine/program.h"

#include <string>

namespace knittsim::formats {

/// Appends operations to a program that is being read from a format of passes; says KS0125 when there are too
/// many. Settings are written only where they change.
class ProgramSink {
public:
    /// Both must outlive the sink.
    ProgramSink(machine::Program& program, Problems& problems) : m_program(program), m_problems(problems) {}

    /// Line of the file that the next operations come from.
    void setLine(int line) { m_line = line; }

    void add(machine::Operation op);
    void carriers(machine::OperationKind kind, const machine::CarrierSet& carriers);
    void rack(double rack);
    void stitchNumber(double number);

    /// Texts become one line without ';'.
    void extension(const std::string& text);
    void pause(const std::string& message);

    /// knit, tuck, miss; without carriers the operation that needs none, and nothing for a miss.
    void stitch(machine::OperationKind kind, machine::Needle needle, machine::Direction direction,
                const machine::CarrierSet& carriers);

    /// split, or xfer without carriers, to the needle of the other bed that faces `from` at the present
    /// racking.
    void transfer(machine::Needle from, machine::Bed to, machine::Direction direction,
                  const machine::CarrierSet& carriers);

    double rack() const { return m_rack; }

    /// There were too many operations; reading should stop.
    bool full() const { return m_full; }

private:
    std::int32_t keep(std::string text);

    machine::Program& m_program;
    Problems& m_problems;
    int m_line = 1;
    double m_rack = 0;
    double m_stitch = -1;
    bool m_full = false;
};

} // namespace knittsim::formats
