#include "core/formats/kcode/reader.h"

#include "core/formats/kcode/action.h"
#include "core/formats/kcode/layout.h"
#include "core/formats/kcode/needle_line.h"
#include "core/formats/program_sink.h"
#include "core/formats/text.h"
#include "core/formats/text_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace knittsim::formats::kcode {

using machine::Bed;
using machine::CarrierSet;
using machine::Direction;
using machine::Needle;
using machine::OperationKind;

namespace {

constexpr double kMaxRack = 100;
constexpr int kMaxTextsBefore = 100; ///< lines before the first pass that may be texts

bool startsWith(std::string_view text, std::string_view prefix) {
    return text.substr(0, prefix.size()) == prefix;
}

class Reader {
public:
    Reader(std::string_view text, const std::string& file)
        : m_problems(file, kMaxErrors), m_lines(text, m_problems), m_sink(m_program, m_problems) {
        m_program.file = file;
        m_program.header.machine = "Kniterate";
        m_program.header.position = "Keep";
        m_program.header.width = kNeedles;
        for (int i = 0; i < kCarriers; ++i) {
            m_program.header.carriers.push_back({std::to_string(i + 1), i, false, {}});
        }
    }

    Result<machine::Program> run();

private:
    struct Bar {
        std::string needles;
        std::string sizes;
    };

    void readLine(std::string_view line);
    void readOther(std::string_view line);
    void readComment(std::string_view line);
    bool expect(int place, std::string_view line);
    void readNeedles(std::string_view prefix, std::string_view line, Bar& bar);
    void readSizes(std::string_view line, Bar& bar);
    void readRack(std::string_view text);
    void readAction(std::string_view line);
    void carryOut(const Action& action);
    void comeIn(int carrier);
    void work(const Action& action, const CarrierSet& carriers);
    void workNeedle(const Action& action, const CarrierSet& carriers, bool front, int index);
    void setSize(const Bar& bar, int index);
    void setOthers(const Action& action);
    void finish();
    Spot here(int column = 1) const { return {m_lines.number(), column}; }

    machine::Program m_program;
    Problems m_problems;
    TextLines m_lines;
    ProgramSink m_sink;
    Bar m_front;
    Bar m_rear;
    int m_place = 0;        ///< lines of the pass that were there: FRNT, STIF, REAR, STIR
    bool m_bad = false;     ///< a line of the pass is wrong, so it is not carried out
    bool m_out = false;     ///< the carrier goes out after the pass
    bool m_sawPass = false; ///< or its beginning
    int m_texts = 0;        ///< lines that are none of a pass
    std::array<bool, kCarriers> m_in{};
    double m_speed = 100;
    double m_roller = 100;
};

Result<machine::Program> Reader::run() {
    while (!m_sink.full() && (m_sawPass || m_texts <= kMaxTextsBefore) && m_lines.next()) {
        m_sink.setLine(m_lines.number());
        readLine(m_lines.line());
    }
    finish();
    if (m_problems.errorCount() > 0) {
        return Result<machine::Program>::failure(m_problems.take());
    }
    return {std::move(m_program), m_problems.take()};
}

void Reader::readLine(std::string_view line) {
    if (startsWith(line, kFrontPrefix)) {
        readNeedles(kFrontPrefix, line, m_front);
    } else if (startsWith(line, kFrontSizes)) {
        readSizes(line, m_front);
    } else if (startsWith(line, kRearPrefix)) {
        readNeedles(kRearPrefix, line, m_rear);
    } else if (startsWith(line, kRearSizes)) {
        readSizes(line, m_rear);
    } else if (startsWith(line, kRightwards) || startsWith(line, kLeftwards)) {
        readAction(line);
    } else if (startsWith(line, kComment)) {
        readComment(line);
    } else {
        readOther(line);
    }
}

void Reader::readComment(std::string_view line) {
    const std::string_view text = trim(line);
    m_out = m_out || (text.size() >= kCarrierOut.size() &&
                      text.substr(text.size() - kCarrierOut.size()) == kCarrierOut);
}

/// HOME, RACK and texts to show stand between the passes only.
void Reader::readOther(std::string_view line) {
    const std::string_view text = trim(line);
    if (text.empty()) {
        return;
    }
    if (startsWith(text, kRackPrefix)) {
        readRack(text.substr(kRackPrefix.size()));
    } else if (m_place != 0) {
        m_problems.error("KS0141", here(), {quoted(text), "the next line of the pass"});
        m_place = 0;
        m_bad = false;
    } else if (text != kHome) {
        m_problems.warn("KS0142", here(), {quoted(text)});
        m_sink.pause(std::string(text));
        ++m_texts;
    }
}

/// The lines of a pass have one order.
bool Reader::expect(int place, std::string_view line) {
    if (m_place == place) {
        ++m_place;
        return true;
    }
    constexpr std::array<const char*, 5> kExpected{
        "FRNT: or the next pass", "STIF:", "REAR:", "STIR:", "the action, for example '>> Kn-Kn 5 100 100'"};
    m_problems.error("KS0141", here(),
                     {quoted(line.substr(0, 8)), kExpected[static_cast<std::size_t>(m_place)]});
    m_place = 0;
    m_bad = true;
    return false;
}

void Reader::readNeedles(std::string_view prefix, std::string_view line, Bar& bar) {
    if (!expect(&bar == &m_front ? 0 : 2, line)) {
        return;
    }
    m_bad = m_bad && &bar != &m_front;
    m_sawPass = true;
    NeedleLine needles = readNeedleLine(trim(line).substr(prefix.size()));
    if (needles.badColumn != 0) {
        m_problems.error("KS0143", here(static_cast<int>(prefix.size()) + needles.badColumn));
        m_bad = true;
    }
    bar.needles = std::move(needles.works);
}

void Reader::readSizes(std::string_view line, Bar& bar) {
    if (!expect(&bar == &m_front ? 1 : 3, line)) {
        return;
    }
    const std::string_view sizes = trim(line).substr(kFrontSizes.size());
    const auto bad = std::find_if(sizes.begin(), sizes.end(), [](char sign) { return numberOf(sign) < 0; });
    if (bad != sizes.end()) {
        m_problems.error(
            "KS0144", here(static_cast<int>(kFrontSizes.size()) + 1 + static_cast<int>(bad - sizes.begin())),
            {quoted(std::string_view(&*bad, 1))});
        m_bad = true;
        return;
    }
    if (!m_bad && sizes.size() != bar.needles.size() + 2 * kMargin) {
        m_problems.error("KS0145", here(),
                         {std::to_string(sizes.size()), std::to_string(bar.needles.size() + 2 * kMargin)});
        m_bad = true;
        return;
    }
    bar.sizes = sizes;
}

void Reader::readRack(std::string_view text) {
    const auto rack = parseNumber(trim(text));
    if (!rack) {
        m_problems.error("KS0108", here(static_cast<int>(kRackPrefix.size()) + 1),
                         {quoted(text), "a number"});
    } else if (std::abs(*rack) > kMaxRack) {
        m_problems.error("KS0119", here(static_cast<int>(kRackPrefix.size()) + 1),
                         {"racking", quoted(text), formatNumber(-kMaxRack), formatNumber(kMaxRack)});
    } else {
        m_sink.rack(*rack);
    }
}

void Reader::readAction(std::string_view line) {
    if (!expect(4, line)) {
        return;
    }
    m_place = 0;
    const auto action = parseAction(line, m_lines.number(), m_problems);
    if (!action || std::exchange(m_bad, false)) {
        m_out = false;
        return;
    }
    if (m_front.needles.size() != m_rear.needles.size()) {
        m_problems.error("KS0145", here(),
                         {std::to_string(m_rear.needles.size()), std::to_string(m_front.needles.size())});
        return;
    }
    carryOut(*action);
}

void Reader::comeIn(int carrier) {
    bool& in = m_in[static_cast<std::size_t>(carrier - 1)];
    if (!in) {
        m_sink.carriers(OperationKind::In, {carrier - 1});
        in = true;
    }
}

void Reader::carryOut(const Action& action) {
    CarrierSet carriers;
    if (action.carrier != 0) {
        carriers = {action.carrier - 1};
        comeIn(action.carrier);
    }
    const auto any = [](const Bar& bar) { return bar.needles.find(kWorks) != std::string::npos; };
    if (any(m_front) || any(m_rear)) {
        setOthers(action);
        work(action, carriers);
    }
    if (std::exchange(m_out, false) && action.carrier != 0) {
        m_sink.carriers(OperationKind::Out, carriers);
        m_in[static_cast<std::size_t>(action.carrier - 1)] = false;
    }
}

/// Speed, and take-down of passes that make loops; transfers have none of their own.
void Reader::setOthers(const Action& action) {
    if (action.speed != std::exchange(m_speed, action.speed)) {
        m_sink.extension("x-speed-number " + formatNumber(action.speed));
    }
    const bool stitches = action.front <= BedWork::Tuck;
    if (stitches && action.roller != std::exchange(m_roller, action.roller)) {
        m_sink.extension("x-roller-advance " + formatNumber(action.roller));
    }
}

/// The needles in the order in which the carriage passes them; a rear needle lies `rack` further right.
void Reader::work(const Action& action, const CarrierSet& carriers) {
    const int count = static_cast<int>(m_front.needles.size());
    const double rack = m_sink.rack();
    const int shift = static_cast<int>(std::floor(rack));
    const int first = std::min(0, shift);
    const int end = std::max(count, count + shift);
    const bool rightwards = action.direction == Direction::Right;
    // Facing needles of aligned beds are worked front first either way.
    const bool frontFirst = rightwards || rack == shift;
    for (int i = 0; i < end - first && !m_sink.full(); ++i) {
        const int slot = rightwards ? first + i : end - 1 - i;
        workNeedle(action, carriers, frontFirst, frontFirst ? slot : slot - shift);
        workNeedle(action, carriers, !frontFirst, frontFirst ? slot - shift : slot);
    }
}

void Reader::setSize(const Bar& bar, int index) {
    m_sink.stitchNumber(numberOf(bar.sizes[static_cast<std::size_t>(index + kMargin)]));
}

void Reader::workNeedle(const Action& action, const CarrierSet& carriers, bool front, int index) {
    const Bar& bar = front ? m_front : m_rear;
    const auto works = [](const Bar& b, int i) {
        return i >= 0 && i < static_cast<int>(b.needles.size()) &&
               b.needles[static_cast<std::size_t>(i)] == kWorks;
    };
    const BedWork kind = front ? action.front : action.rear;
    if (!works(bar, index) || takes(kind)) {
        return;
    }
    const Needle needle{front ? Bed::Front : Bed::Rear, index + 1};
    if (kind != BedWork::Give) {
        if (!carriers.empty()) {
            setSize(bar, index);
        }
        m_sink.stitch(kind == BedWork::Knit ? OperationKind::Knit : OperationKind::Tuck, needle,
                      action.direction, carriers);
        return;
    }
    const int shift = static_cast<int>(std::floor(m_sink.rack()));
    const bool received = works(front ? m_rear : m_front, front ? index - shift : index + shift);
    if (!carriers.empty()) {
        setSize(bar, index);
    }
    if (!carriers.empty() && !received) {
        m_sink.stitch(OperationKind::Knit, needle, action.direction, carriers);
        return;
    }
    if (m_sink.rack() != shift) {
        m_problems.error("KS0146", here(), {machine::toString(needle), formatNumber(m_sink.rack())});
        return;
    }
    m_sink.transfer(needle, front ? Bed::Rear : Bed::Front, action.direction, carriers);
}

void Reader::finish() {
    const Spot end{std::max(m_lines.number(), 1), 1};
    if (!m_sawPass && (m_texts > 0 || m_problems.errorCount() == 0)) {
        // Another kind of file: what was said of its lines does not matter.
        m_problems = Problems(m_program.file, kMaxErrors);
        m_problems.error("KS0140", {1, 1});
    }
    if (m_problems.errorCount() > 0) {
        return;
    }
    if (m_place != 0) {
        m_problems.error("KS0141", end, {"the end of the file", "the rest of the pass"});
    }
    for (int carrier = 1; carrier <= kCarriers; ++carrier) {
        if (m_in[static_cast<std::size_t>(carrier - 1)]) {
            m_sink.carriers(OperationKind::Out, {carrier - 1});
        }
    }
}

} // namespace

Result<machine::Program> parse(std::string_view text, const std::string& file) {
    return Reader(text, file).run();
}

} // namespace knittsim::formats::kcode
