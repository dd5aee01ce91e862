#include "core/formats/knitout/writer.h"

#include "core/formats/knitout/forms.h"
#include "core/formats/text.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace knittsim::formats::knitout {

using machine::Carrier;
using machine::Header;
using machine::Operation;
using machine::OperationKind;
using machine::Program;

namespace {

/// Characters that would end the line or begin a comment become blanks.
std::string oneLine(std::string_view text, std::string_view forbidden) {
    std::string line(text);
    for (char& c : line) {
        if (forbidden.find(c) != std::string_view::npos || c == '\0') {
            c = ' ';
        }
    }
    return line;
}

void writeHeader(std::string& out, std::string_view name, std::string_view value) {
    out += ";;";
    out += oneLine(name, "\n");
    out += ':';
    if (!value.empty()) {
        out += ' ';
        out += oneLine(value, "\n");
    }
    out += '\n';
}

/// Rails front to back: "1 2 L1,L2;R1".
std::string railsText(std::vector<Carrier> carriers) {
    std::stable_sort(carriers.begin(), carriers.end(), [](const Carrier& a, const Carrier& b) {
        return std::tie(a.rail, a.parksRight) < std::tie(b.rail, b.parksRight);
    });
    std::string text;
    const Carrier* last = nullptr;
    for (const Carrier& carrier : carriers) {
        const bool newRail = last == nullptr || last->rail != carrier.rail;
        if (newRail) {
            text += last != nullptr ? " " : "";
            text += carrier.parksRight ? ";" : "";
        } else {
            text += last->parksRight != carrier.parksRight ? ";" : ",";
        }
        text += carrier.name;
        last = &carrier;
    }
    return text;
}

void writeHeaders(std::string& out, const Header& header) {
    out += ";!knitout-" + std::to_string(header.version) + '\n';
    if (!header.carriers.empty()) {
        writeHeader(out, "Carriers", railsText(header.carriers));
    }
    if (!header.machine.empty()) {
        writeHeader(out, "Machine", header.machine);
    }
    if (header.gauge) {
        writeHeader(out, "Gauge", formatNumber(*header.gauge));
    }
    if (!header.position.empty()) {
        writeHeader(out, "Position", header.position);
    }
    if (header.width) {
        writeHeader(out, "Width", std::to_string(*header.width));
    }
    for (const Carrier& carrier : header.carriers) {
        if (!carrier.yarn.empty()) {
            writeHeader(out, "Yarn-" + carrier.name, carrier.yarn);
        }
    }
    for (const auto& [name, value] : header.others) {
        writeHeader(out, name, value);
    }
}

class OperationWriter {
public:
    OperationWriter(const Program& program, std::string& out) : m_program(program), m_out(out) {}

    void write(const Operation& op) {
        if (op.kind == OperationKind::Extension) {
            m_out += text(op);
        } else {
            const Form& form = *findForm(op.kind);
            m_out += form.name;
            for (const Argument argument : form.arguments) {
                writeArgument(argument, op);
            }
        }
        m_out += '\n';
    }

private:
    std::string text(const Operation& op) const {
        return op.text < 0 ? std::string()
                           : oneLine(m_program.texts[static_cast<std::size_t>(op.text)], "\n;");
    }

    void writeArgument(Argument argument, const Operation& op) {
        switch (argument) {
        case Argument::Direction:
            m_out += op.direction == machine::Direction::Right ? " +" : " -";
            break;
        case Argument::Needle:
            word(machine::toString(op.needle));
            break;
        case Argument::Target:
            word(machine::toString(op.target));
            break;
        case Argument::Carriers:
            for (const machine::CarrierIndex carrier : op.carriers) {
                word(m_program.header.carriers[carrier].name);
            }
            break;
        case Argument::Racking:
        case Argument::TableIndex:
        case Argument::Leading:
            word(formatNumber(op.value));
            break;
        case Argument::Tension:
            word(formatNumber(op.value2));
            break;
        case Argument::ColourCode:
        case Argument::Message:
            word(text(op));
            break;
        case Argument::None:
            break;
        }
    }

    void word(std::string_view text) {
        if (!text.empty()) {
            m_out += ' ';
            m_out += text;
        }
    }

    const Program& m_program;
    std::string& m_out;
};

} // namespace

std::string write(const Program& program) {
    std::string out;
    out.reserve(256 + program.operations.size() * 16);
    writeHeaders(out, program.header);
    OperationWriter writer(program, out);
    auto comment = program.sourceComments.begin();
    const auto writeComments = [&](std::size_t upTo) {
        for (; comment != program.sourceComments.end() && static_cast<std::size_t>(comment->first) <= upTo;
             ++comment) {
            out += oneLine(comment->second, "\n") + '\n';
        }
    };
    for (std::size_t i = 0; i < program.operations.size(); ++i) {
        writeComments(i);
        writer.write(program.operations[i]);
    }
    writeComments(program.operations.size());
    return out;
}

} // namespace knittsim::formats::knitout
