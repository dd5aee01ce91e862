#include "core/formats/kcode/writer.h"

#include "core/formats/kcode/carriage.h"
#include "core/formats/passes/planner.h"
#include "core/formats/text.h"

#include <algorithm>
#include <cmath>

namespace knittsim::formats::kcode {

using machine::Direction;
using machine::OperationKind;
using passes::Pass;

namespace {

constexpr const char* kRefusal = "KS0149";

constexpr passes::PassRules kRules{
    .refusal = kRefusal,
    .hook = false,
    .sliders = false,
    .tucksWithKnits = false,
    .splitsWithKnits = true,
    .presser = false,
    .missesAreSoft = true,
    .oneStitchNumber = false,
    .outwards = Direction::Left,
    .interleavedFraction = 0.5,
    .maxRack = 8,
    .maxStitchNumber = 35,
    .stitch = 5,
    .transferStitch = 3,
    .speed = 100,
    .maxSpeed = 600,
    .roller = 100,
    .maxCarriersInSet = 1,
};

Diagnostic refusal(const machine::Program& program, std::string what, std::string why) {
    return {kRefusal, Severity::Error, Place{.file = program.file}, {std::move(what), std::move(why)}};
}

/// The last values of x-carrier-spacing and x-carrier-stopping-distance, or nothing when one is unusable.
std::optional<Spacing> spacingOf(const machine::Program& program) {
    Spacing spacing;
    for (const machine::Operation& op : program.operations) {
        if (op.kind != OperationKind::Extension) {
            continue;
        }
        Tokens tokens(program.texts[static_cast<std::size_t>(op.text)]);
        const std::string_view name = tokens.next().text;
        if (name != "x-carrier-spacing" && name != "x-carrier-stopping-distance") {
            continue;
        }
        const auto value = parseNumber(tokens.next().text);
        if (!value || *value < 1 || *value > 10) {
            return std::nullopt;
        }
        if (name == "x-carrier-stopping-distance") {
            spacing.distance = std::floor(*value) + 0.5;
        } else if (*value == std::floor(*value)) {
            spacing.carriers = *value;
        } else {
            return std::nullopt;
        }
    }
    return spacing;
}

/// What makes needles, counted from 0, of slots.
int offsetOf(const std::string& position, int first, int last) {
    if (position == "Keep") {
        return -1;
    }
    if (position == "Left") {
        return -first;
    }
    if (position == "Right") {
        return kNeedles - 1 - last;
    }
    return static_cast<int>(std::floor(0.5 * kNeedles - 0.5 * (first + last)));
}

/// Every needle that works, and every slot that a carrier passes, lies on its bed.
bool onBed(const Pass& pass, int offset) {
    const int rack = static_cast<int>(std::floor(pass.rack));
    const auto good = [](int needle) { return needle >= 0 && needle < kNeedles; };
    return std::all_of(pass.cells.begin(), pass.cells.end(), [&](const auto& entry) {
        const bool rear =
            entry.second.rear != passes::Work::None || entry.second.front >= passes::Work::Transfer;
        return good(entry.first + offset) && (!rear || good(entry.first - rack + offset));
    });
}

bool stopsFit(const Stroke& stroke) {
    return stroke.carriageLeft >= -kMargin && stroke.carriageRight <= kNeedles - 1 + kMargin;
}

/// The needles of one bed between margins, with the stops put in between.
std::string needleLine(const Stroke& stroke, const std::string& needles) {
    std::string line(kMargin, kMarginSign);
    line += needles;
    line.append(kMargin, kMarginSign);
    const auto put = [&](double stop, char sign) {
        line.insert(static_cast<std::size_t>(stop + kMargin + 0.5), 1, sign);
    };
    // From right to left, so that the places further left stay valid.
    put(stroke.carriageRight, kRightStop);
    if (stroke.carrier != 0) {
        put(stroke.carrierRight, signOf(stroke.carrier));
        put(stroke.carrierLeft, signOf(stroke.carrier));
    }
    put(stroke.carriageLeft, kLeftStop);
    return line;
}

class Text {
public:
    explicit Text(std::string name) {
        std::replace_if(
            name.begin(), name.end(), [](char c) { return c >= '\0' && c < ' '; }, ' ');
        line(kHome);
        line(std::string(kRackPrefix) + '0');
        line("// " + name);
    }

    void add(const Stroke& stroke) {
        if (!stroke.message.empty()) {
            line(stroke.message);
        }
        for (int i = 0; i < 4; ++i) {
            line(kComment);
        }
        if (!stroke.comment.empty()) {
            line("// " + stroke.comment);
        }
        if (stroke.rack != m_rack) {
            m_rack = stroke.rack;
            line(std::string(kRackPrefix) + formatNumber(m_rack));
        }
        line(std::string(kFrontPrefix) + needleLine(stroke, stroke.front));
        line(std::string(kFrontSizes) + stroke.frontSizes);
        line(std::string(kRearPrefix) + needleLine(stroke, stroke.rear));
        line(std::string(kRearSizes) + stroke.rearSizes);
        line(std::string(stroke.direction == Direction::Right ? kRightwards : kLeftwards) + ' ' +
             stroke.type + ' ' + std::to_string(stroke.carrier) + ' ' + formatNumber(stroke.speed) + ' ' +
             formatNumber(stroke.roller));
    }

    std::string take() && { return std::move(m_text); }

private:
    void line(std::string_view text) {
        m_text += text;
        m_text += '\n';
    }

    std::string m_text;
    double m_rack = 0;
};

/// A text that cannot be taken for anything else.
bool isMessage(std::string_view text) {
    const auto begins = [&](std::string_view word) { return text.substr(0, word.size()) == word; };
    const auto words = {kHome,        kComment,    kRightwards, kLeftwards, kRackPrefix,
                        kFrontPrefix, kFrontSizes, kRearPrefix, kRearSizes};
    return trim(text).size() == text.size() && !text.empty() && text.find('\n') == std::string_view::npos &&
           std::none_of(words.begin(), words.end(), begins);
}

/// Number of the carrier of a pass: 0 for none, -1 for a name that is none of 1 to 6.
int carrierOf(const machine::Header& header, const Pass& pass) {
    if (pass.carriers.empty()) {
        return 0;
    }
    const std::string& name = header.carriers[pass.carriers[0]].name;
    const bool known = name.size() == 1 && name[0] >= '1' && name[0] <= '0' + kCarriers;
    return known ? name[0] - '0' : -1;
}

} // namespace

Result<std::string> write(const machine::Program& program, std::string_view name) {
    const auto planned = passes::planPasses(program, kRules);
    if (!planned) {
        return Result<std::string>::failure(planned.diagnostics());
    }
    const std::vector<Pass>& list = planned.value();
    if (list.empty()) {
        return refusal(program, "the program", "it makes no stitch");
    }
    const auto spacing = spacingOf(program);
    if (!spacing) {
        return refusal(program, "x-carrier-spacing, x-carrier-stopping-distance",
                       "they are 1 to 10 needles, the spacing whole ones");
    }
    int first = list.front().firstSlot();
    int last = first;
    for (const Pass& pass : list) {
        first = std::min(first, pass.firstSlot());
        last = std::max(last, pass.lastSlot());
    }
    const int offset = offsetOf(program.header.position, first, last);
    Carriage carriage(offset, *spacing);
    for (const Pass& pass : list) {
        const int carrier = carrierOf(program.header, pass);
        if (carrier < 0) {
            return refusal(program, "carrier " + program.header.carriers[pass.carriers[0]].name,
                           "carriers are 1 to 6");
        }
        if (!onBed(pass, offset)) {
            return refusal(program, "needle " + std::to_string(first) + " to " + std::to_string(last),
                           "the beds have needles 1 to 252");
        }
        if (pass.pause && !isMessage(pass.message)) {
            return refusal(program, "pause", "a stop needs a text to show");
        }
        carriage.add(pass, carrier);
    }
    Text text{std::string(name)};
    for (const Stroke& stroke : carriage.strokes()) {
        if (!stopsFit(stroke)) {
            return refusal(program, "a carrier stop", "it lies beyond the bed");
        }
        text.add(stroke);
    }
    return std::move(text).take();
}

} // namespace knittsim::formats::kcode
