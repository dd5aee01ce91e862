#include "core/formats/knitout/operation_reader.h"

#include <algorithm>
#include <cctype>

namespace knittsim::formats::knitout {

using machine::Bed;
using machine::Direction;
using machine::Operation;
using machine::OperationKind;

namespace {

constexpr std::int64_t kMaxNeedleIndex = 1'000'000;
constexpr double kMaxRacking = 1000;
constexpr double kMaxStitchNumber = 1000;
constexpr double kMaxStitchSize = 1'000'000;

bool isHexDigit(char c) {
    return std::isxdigit(static_cast<unsigned char>(c)) != 0;
}

/// Without carriers knit, tuck and split are another kind of operation, which has no direction.
void resolveWithoutYarn(Operation& op) {
    if (!op.carriers.empty()) {
        return;
    }
    if (op.kind == OperationKind::Knit) {
        op.kind = OperationKind::Drop;
    } else if (op.kind == OperationKind::Tuck) {
        op.kind = OperationKind::Amiss;
    } else if (op.kind == OperationKind::Split) {
        op.kind = OperationKind::Xfer;
    } else {
        return;
    }
    op.direction = Direction::Right;
}

bool usesCarriers(const Form& form) {
    return std::find(form.arguments.begin(), form.arguments.end(), Argument::Carriers) !=
           form.arguments.end();
}

} // namespace

void OperationReader::read(std::string_view text, int line) {
    m_line = line;
    Tokens tokens(text);
    const Token name = tokens.next();
    const Form* form = findForm(name.text);
    if (form == nullptr) {
        readUnknown(name, text);
        return;
    }
    m_severity = form->isExtension() ? Severity::Warning : Severity::Error;
    const std::size_t textCount = m_program.texts.size();
    Operation op;
    op.kind = form->kind;
    bool good = true;
    for (const Argument argument : form->arguments) {
        good = good && (argument == Argument::None || readArgument(argument, op, tokens));
    }
    if (good && !tokens.peek().text.empty()) {
        good = wrong(tokens.peek(), "the end of the operation");
    }
    if (!good) {
        m_program.texts.resize(textCount);
        if (form->isExtension()) {
            keepExtension(text);
        }
        return;
    }
    if (op.carriers.empty() && usesCarriers(*form) && !machine::makesLoop(op.kind)) {
        m_problems.warn("KS0108", {m_line, tokens.peek().column}, {"nothing", "a carrier"});
    }
    resolveWithoutYarn(op);
    push(op);
}

bool OperationReader::readArgument(Argument argument, Operation& op, Tokens& tokens) {
    switch (argument) {
    case Argument::Direction:
        return readDirection(op, tokens.next());
    case Argument::Needle:
        return readNeedle(op.needle, tokens.next());
    case Argument::Target:
        return readNeedle(op.target, tokens.next());
    case Argument::Carriers:
        return readCarriers(op, tokens);
    case Argument::Racking:
        return readNumber(op.value, tokens.next(), "racking", -kMaxRacking, kMaxRacking);
    case Argument::TableIndex:
        return readStitchNumber(op, tokens.next());
    case Argument::Leading:
        return readNumber(op.value, tokens.next(), "leading", -kMaxStitchSize, kMaxStitchSize);
    case Argument::Tension:
        return readNumber(op.value2, tokens.next(), "tension", -kMaxStitchSize, kMaxStitchSize);
    case Argument::ColourCode:
        return readColour(op, tokens.next());
    case Argument::Message:
        return readMessage(op, tokens);
    case Argument::None:
        break;
    }
    return true;
}

bool OperationReader::readDirection(Operation& op, const Token& token) {
    if (token.text != "+" && token.text != "-") {
        return wrong(token, "a direction, + or -");
    }
    op.direction = token.text == "+" ? Direction::Right : Direction::Left;
    return true;
}

bool OperationReader::readNeedle(machine::Needle& needle, const Token& token) {
    constexpr const char* kExpected = "a needle such as f5, b-3 or fs2";
    std::string_view text = token.text;
    if (text.empty() || (text[0] != 'f' && text[0] != 'b')) {
        return wrong(token, kExpected);
    }
    const bool front = text[0] == 'f';
    text.remove_prefix(1);
    const bool slider = !text.empty() && text[0] == 's';
    text.remove_prefix(slider ? 1 : 0);
    const std::optional<std::int64_t> index = parseInteger(text);
    if (!index) {
        return wrong(token, kExpected);
    }
    if (*index < -kMaxNeedleIndex || *index > kMaxNeedleIndex) {
        return fail("KS0119", token.column,
                    {"needle", quoted(token.text), std::to_string(-kMaxNeedleIndex),
                     std::to_string(kMaxNeedleIndex)});
    }
    needle.bed = slider ? (front ? Bed::FrontSlider : Bed::RearSlider) : (front ? Bed::Front : Bed::Rear);
    needle.index = static_cast<std::int32_t>(*index);
    return true;
}

bool OperationReader::readNumber(double& value, const Token& token, const char* what, double least,
                                 double most) {
    const std::optional<double> number = parseNumber(token.text);
    if (!number) {
        return wrong(token, "a number");
    }
    if (*number < least || *number > most) {
        return fail("KS0119", token.column,
                    {what, quoted(token.text), formatNumber(least), formatNumber(most)});
    }
    value = *number;
    return true;
}

bool OperationReader::readStitchNumber(Operation& op, const Token& token) {
    if (token.text.size() == 1 && token.text[0] >= 'A' && token.text[0] <= 'Z') {
        op.value = 10 + (token.text[0] - 'A');
        return true;
    }
    return readNumber(op.value, token, "stitch number", 0, kMaxStitchNumber);
}

bool OperationReader::readColour(Operation& op, const Token& token) {
    std::string_view digits = token.text;
    if (!digits.empty() && digits[0] == '#') {
        digits.remove_prefix(1);
    }
    if ((digits.size() != 3 && digits.size() != 6) ||
        !std::all_of(digits.begin(), digits.end(), isHexDigit)) {
        return wrong(token, "a colour such as #26c6f6");
    }
    std::string colour = "#";
    for (const char digit : digits) {
        const char lower = static_cast<char>(std::tolower(static_cast<unsigned char>(digit)));
        colour.append(digits.size() == 3 ? 2 : 1, lower);
    }
    op.text = keepText(colour);
    return true;
}

bool OperationReader::readCarriers(Operation& op, Tokens& tokens) {
    for (Token token = tokens.next(); !token.text.empty(); token = tokens.next()) {
        if (!addCarrier(op.carriers, token)) {
            return false;
        }
    }
    return true;
}

bool OperationReader::addCarrier(machine::CarrierSet& set, const Token& token) {
    const auto& carriers = m_program.header.carriers;
    const auto found = std::find_if(carriers.begin(), carriers.end(),
                                    [&](const machine::Carrier& c) { return c.name == token.text; });
    if (found == carriers.end()) {
        return unknownCarrier(token);
    }
    const auto index = static_cast<machine::CarrierIndex>(found - carriers.begin());
    if (set.contains(index)) {
        return fail("KS0110", token.column, {shown(token.text)});
    }
    if (!set.push(index)) {
        return fail("KS0117", token.column,
                    {"more than " + std::to_string(machine::kMaxCarriersInSet) + " in one set",
                     std::to_string(machine::kMaxCarriersInSet)});
    }
    return true;
}

bool OperationReader::unknownCarrier(const Token& token) {
    switch (m_carriers) {
    case Carriers::Named:
        return fail("KS0109", token.column, {shown(token.text)});
    case Carriers::Missing:
        // Said once, at the first operation that needs the header.
        m_problems.error("KS0103", {m_line, token.column});
        m_carriers = Carriers::Faulty;
        return false;
    case Carriers::Faulty:
        break;
    }
    return false;
}

bool OperationReader::readMessage(Operation& op, Tokens& tokens) {
    const Token first = tokens.peek();
    if (first.text.empty()) {
        return true;
    }
    const std::string_view message = tokens.rest();
    m_problems.warn("KS0108", {m_line, first.column}, {quoted(message), "the end of the operation"});
    op.text = keepText(message);
    tokens.skipAll();
    return true;
}

void OperationReader::readUnknown(const Token& name, std::string_view text) {
    if (name.text.substr(0, 2) != "x-") {
        m_severity = Severity::Error;
        if (const auto dash = findTypographicMinus(name.text)) {
            fail("KS0118", name.column + static_cast<int>(*dash), {});
        } else {
            fail("KS0107", name.column, {shown(name.text)});
        }
        return;
    }
    if (!m_problems.warningsFull() && m_extensions.emplace(name.text).second) {
        m_problems.warn("KS0111", {m_line, name.column}, {shown(name.text)},
                        static_cast<int>(m_program.operations.size()));
    }
    keepExtension(text);
}

void OperationReader::keepExtension(std::string_view text) {
    Operation op;
    op.kind = OperationKind::Extension;
    op.text = keepText(trim(text));
    push(op);
}

void OperationReader::push(Operation op) {
    op.line = m_line;
    m_program.operations.push_back(op);
}

std::int32_t OperationReader::keepText(std::string_view text) {
    m_program.texts.emplace_back(text);
    return static_cast<std::int32_t>(m_program.texts.size()) - 1;
}

bool OperationReader::wrong(const Token& token, const char* expected) {
    if (const auto dash = findTypographicMinus(token.text)) {
        return fail("KS0118", token.column + static_cast<int>(*dash), {});
    }
    return fail("KS0108", token.column, {quoted(token.text), expected});
}

bool OperationReader::fail(const char* id, int column, std::vector<std::string> arguments) {
    m_problems.add(m_severity, id, {m_line, column}, std::move(arguments));
    return false;
}

} // namespace knittsim::formats::knitout
