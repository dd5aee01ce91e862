#pragma once

#include "core/formats/knitout/forms.h"
#include "core/formats/problems.h"
#include "core/formats/text.h"
#include "core/machine/program.h"

#include <string>
#include <string_view>
#include <unordered_set>

namespace knittsim::formats::knitout {

/// Turns the text of one operation into an Operation of the program. Reports KS0103, KS0107 to KS0111, KS0117
/// to KS0119. A fault in an extension ('x-...') is only a warning, and the operation is kept as it is
/// written.
class OperationReader {
public:
    /// Both must outlive the reader.
    OperationReader(machine::Program& program, Problems& problems)
        : m_program(program), m_problems(problems) {}

    /// What the reader may say about a carrier that it does not know.
    enum class Carriers { Named, Missing, Faulty };

    void setCarriers(Carriers carriers) { m_carriers = carriers; }

    /// `text` has no comment, begins at column 1 of its line and holds at least one word.
    void read(std::string_view text, int line);

private:
    bool readArgument(Argument argument, machine::Operation& op, Tokens& tokens);
    bool readDirection(machine::Operation& op, const Token& token);
    bool readNeedle(machine::Needle& needle, const Token& token);
    bool readNumber(double& value, const Token& token, const char* what, double least, double most);
    bool readStitchNumber(machine::Operation& op, const Token& token);
    bool readColour(machine::Operation& op, const Token& token);
    bool readCarriers(machine::Operation& op, Tokens& tokens);
    bool addCarrier(machine::CarrierSet& set, const Token& token);
    bool unknownCarrier(const Token& token);
    bool readMessage(machine::Operation& op, Tokens& tokens);
    void readUnknown(const Token& name, std::string_view text);
    void keepExtension(std::string_view text);
    void push(machine::Operation op);
    std::int32_t keepText(std::string_view text);

    bool wrong(const Token& token, const char* expected);
    bool fail(const char* id, int column, std::vector<std::string> arguments);

    machine::Program& m_program;
    Problems& m_problems;
    Carriers m_carriers = Carriers::Named;
    std::unordered_set<std::string> m_extensions; ///< names already warned of
    int m_line = 1;
    Severity m_severity = Severity::Error; ///< of faults in the operation being read
};

} // namespace knittsim::formats::knitout
