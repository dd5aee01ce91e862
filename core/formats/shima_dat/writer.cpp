#include "core/formats/shima_dat/writer.h"

#include "core/formats/passes/planner.h"
#include "core/formats/shima_dat/layout.h"
#include "core/formats/shima_dat/raster.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace knittsim::formats::shima_dat {

using machine::Direction;
using passes::Gripper;
using passes::Hook;
using passes::Pass;
using passes::PassKind;
using passes::Presser;

namespace {

constexpr const char* kRefusal = "KS0139";
constexpr int kDefaultWidth = 540;

constexpr passes::PassRules kRules{
    .refusal = kRefusal,
    .hook = true,
    .sliders = true,
    .tucksWithKnits = true,
    .splitsWithKnits = false,
    .presser = true,
    .missesAreSoft = false,
    .oneStitchNumber = true,
    .outwards = Direction::Right,
    .interleavedFraction = 0.25,
    .maxRack = 8,
    .maxStitchNumber = 255,
    .stitch = 5,
    .transferStitch = 0,
    .speed = 0,
    .maxSpeed = 15,
    .roller = 0,
    .maxCarriersInSet = 2,
};

/// Numbers 1 to 10 of the carriers, 0 where the name is none of them.
std::vector<int> carrierNumbers(const machine::Header& header) {
    std::vector<int> numbers;
    for (const machine::Carrier& carrier : header.carriers) {
        int number = kCarriers;
        while (number > 0 && carrier.name != std::to_string(number)) {
            --number;
        }
        numbers.push_back(number);
    }
    return numbers;
}

/// The value of R3: two digits for two carriers. Nothing where the number would mean another set.
std::optional<int> carrierValue(const Pass& pass, const std::vector<int>& numbers) {
    if (pass.carriers.empty()) {
        return pass.kind == PassKind::Stitch ? kNoCarrier : 0;
    }
    const int first = numbers[pass.carriers[0]];
    if (first == 0 || pass.carriers.size() == 1) {
        return first == 0 ? std::nullopt : std::optional(first);
    }
    const int second = numbers[pass.carriers[1]];
    if (second == 0 || first == kCarriers || (first == 1 && second == kCarriers)) {
        return std::nullopt;
    }
    return first * 10 + second % kCarriers;
}

/// Turns passes into option lines; knows where the carriage stands and what the hook does.
class OptionWriter {
public:
    Options options(const Pass& pass, int carriers);

    Direction carriage() const { return m_carriage; }

private:
    void writeRacking(Options& options, double rack) const;
    void writeHook(Options& options, const Pass& pass);
    void writeDirection(Options& options, const Pass& pass);

    Direction m_carriage = Direction::Right; ///< where it stands; there the passes before the program end
    bool m_hookActive = false;
};

Options OptionWriter::options(const Pass& pass, int carriers) {
    Options options;
    options.right[right::kNoLinks] = 1;
    options.right[right::kCarrier] = static_cast<std::uint8_t>(carriers);
    options.right[right::kStitch] = static_cast<std::uint8_t>(pass.stitch);
    const auto speed = static_cast<std::uint8_t>(pass.speed == 0 ? 0 : pass.speed + 10);
    options.left[left::kKnitSpeed] = options.left[left::kTransferSpeed] = speed;
    options.left[left::kPause] = pass.pause ? 20 : 0;
    if (pass.kind == PassKind::ToSliders || pass.kind == PassKind::FromSliders) {
        options.left[left::kSliders] = pass.kind == PassKind::ToSliders ? 1 : 3;
    }
    if (pass.kind == PassKind::Split || pass.kind == PassKind::Amiss) {
        options.left[left::kSplitOrMiss] = pass.kind == PassKind::Split ? 10 : 20;
    }
    if (pass.gripper != Gripper::None) {
        const int out = pass.gripper == Gripper::Out ? 100 : 0;
        options.right[right::kGripper] = static_cast<std::uint8_t>(out + carriers);
    }
    const bool transfers = pass.kind == PassKind::Transfer || pass.kind == PassKind::ToSliders ||
                           pass.kind == PassKind::FromSliders;
    if (transfers) {
        options.right[right::kCancel] = 1;
        options.right[right::kTransferStitch] = pass.stitch != 0 ? 100 : 0;
    }
    writeHook(options, pass);
    writeRacking(options, pass.rack);
    writeDirection(options, pass);
    return options;
}

void OptionWriter::writeHook(Options& options, const Pass& pass) {
    const bool free = !m_hookActive && pass.hook == Hook::None && !(worksFront(pass) && worksRear(pass));
    if (pass.presser == Presser::On || (pass.presser == Presser::Auto && free)) {
        options.right[right::kPresser] = 101;
    }
    if (pass.hook == Hook::In) {
        options.right[right::kHook] = 10;
        m_hookActive = true;
    } else if (pass.hook == Hook::Out) {
        options.right[right::kHook] = 20;
    } else if (pass.hook == Hook::Release) {
        options.right[right::kHook] = 90;
        m_hookActive = false;
    }
}

void OptionWriter::writeRacking(Options& options, double rack) const {
    const int whole = static_cast<int>(std::floor(rack));
    options.left[left::kRackingSide] = whole >= 1 ? 11 : 10;
    options.left[left::kRacking] = static_cast<std::uint8_t>(whole >= 1 ? whole - 1 : -whole);
    options.left[left::kInterleaved] = rack == whole ? 0 : 1;
}

void OptionWriter::writeDirection(Options& options, const Pass& pass) {
    options.direction = pass.direction;
    if (!pass.direction && (pass.kind == PassKind::Stitch || pass.kind == PassKind::Amiss)) {
        options.direction = opposite(m_carriage);
    }
    if (options.direction == m_carriage) {
        options.right[right::kCancel] = 2;
    }
    m_carriage = options.direction.value_or(m_carriage);
}

class Picture {
public:
    Picture(int firstSlot, int lastSlot, std::size_t passCount)
        : m_first(firstSlot), m_last(lastSlot),
          m_raster(2 * kMargin + lastSlot - firstSlot + 1,
                   kRowsBelow + 2 * kFrameRows + static_cast<int>(passCount) + kRowsAbove),
          m_y(kRowsBelow) {}

    void writePosition(int position);
    void writePass(const Pass& pass, const Options& options);
    void writeFrame(std::uint8_t colour, Options options);
    const Raster& raster() const { return m_raster; }

private:
    std::uint8_t& at(int y, int slot) {
        return m_raster.row(y)[static_cast<std::size_t>(kMargin + slot - m_first)];
    }
    void writeOptions(const Options& options);

    int m_first;
    int m_last;
    Raster m_raster;
    int m_y;
};

void Picture::writePosition(int position) {
    const int y = m_raster.height - kRowsAbove + 1;
    const int column = m_first - kGap - 2;
    at(y, column) = static_cast<std::uint8_t>(position % 100);
    at(y + 1, column) = static_cast<std::uint8_t>(position / 100);
    for (int slot = m_first - kGap; slot <= m_last + kGap; ++slot) {
        at(y, slot) = 1;
    }
}

void Picture::writeOptions(const Options& options) {
    const std::uint8_t direction = !options.direction                       ? 1
                                   : *options.direction == Direction::Right ? kGoesRight
                                                                            : kGoesLeft;
    for (int line = 1; line <= kOptionLines; ++line) {
        const auto index = static_cast<std::size_t>(line);
        const std::uint8_t mark = line == 1 ? direction : static_cast<std::uint8_t>(line);
        at(m_y, m_first - kGap - 2 * line + 1) = mark;
        at(m_y, m_first - kGap - 2 * line) = options.left[index];
        at(m_y, m_last + kGap + 2 * line - 1) = mark;
        at(m_y, m_last + kGap + 2 * line) = options.right[index];
    }
    ++m_y;
}

void Picture::writePass(const Pass& pass, const Options& options) {
    for (const auto& [slot, cell] : pass.cells) {
        passes::Cell shown = cell;
        // A miss beside a stitch of the other bed says nothing.
        if (shown.front != passes::Work::None && shown.rear != passes::Work::None) {
            shown.front = shown.front == passes::Work::Miss ? passes::Work::None : shown.front;
            shown.rear = shown.rear == passes::Work::Miss ? passes::Work::None : shown.rear;
        }
        const auto* colour =
            std::find_if(kColours.begin(), kColours.end(), [&](const Colour& c) { return c.cell == shown; });
        at(m_y, slot) = colour != kColours.end() ? colour->number : kSoftMiss;
        if (pass.kind == PassKind::SliderSplit) {
            const bool front = cell.front == passes::Work::Split;
            const int right = static_cast<int>(*pass.returnRack - pass.rack);
            const auto* split =
                std::find_if(kSliderSplits.begin(), kSliderSplits.end(), [&](const SliderSplit& s) {
                    return s.front == front && s.way == (front ? right : -right);
                });
            at(m_y, slot) = split->number;
        }
    }
    at(m_y, pass.firstSlot() - 1) = kStopMark;
    at(m_y, pass.lastSlot() + 1) = kStopMark;
    writeOptions(options);
}

void Picture::writeFrame(std::uint8_t colour, Options options) {
    for (int slot = m_first; slot <= m_last; ++slot) {
        at(m_y, slot) = colour;
    }
    at(m_y, m_first - 1) = at(m_y, m_last + 1) = kStopMark;
    options.left[left::kRackingSide] = 10;
    options.right[right::kCarrier] = kNoCarrier;
    options.right[right::kNoLinks] = 1;
    writeOptions(options);
}

Options going(Direction direction) {
    Options options;
    options.direction = direction;
    return options;
}

void writeStart(Picture& picture) {
    picture.writeFrame(216, going(Direction::Right));
    picture.writeFrame(51, going(Direction::Left));
    picture.writeFrame(52, going(Direction::Right));
}

void writeEnd(Picture& picture, Direction carriage) {
    Options first = going(Direction::Left);
    first.right[right::kCancel] = carriage == Direction::Left ? 2 : 0;
    picture.writeFrame(51, first);
    picture.writeFrame(52, going(Direction::Right));
    Options last = going(Direction::Left);
    last.left[left::kInterleaved] = 1;
    last.right[right::kDropSinker] = 11;
    picture.writeFrame(3, last);
}

/// Number of the needle where the piece begins; 0 lets the machine put it to the right end.
std::optional<int> positionOf(const machine::Header& header, int firstSlot, int lastSlot) {
    const int bed = header.width.value_or(kDefaultWidth);
    const int width = lastSlot - firstSlot + 1;
    if (width > bed || (header.position == "Keep" && (firstSlot < 1 || lastSlot > bed))) {
        return std::nullopt;
    }
    if (header.position == "Keep") {
        return firstSlot;
    }
    if (header.position == "Left" || header.position == "Right") {
        return header.position == "Left" ? 1 : 0;
    }
    return (bed - width + 1) / 2;
}

Diagnostic refusal(const machine::Program& program, std::string what, std::string why) {
    return {kRefusal, Severity::Error, Place{.file = program.file}, {std::move(what), std::move(why)}};
}

} // namespace

Result<std::string> write(const machine::Program& program) {
    const auto planned = passes::planPasses(program, kRules);
    if (!planned) {
        return Result<std::string>::failure(planned.diagnostics());
    }
    const std::vector<Pass>& list = planned.value();
    if (list.empty()) {
        return refusal(program, "the program", "it makes no stitch");
    }
    int first = list.front().firstSlot();
    int last = first;
    for (const Pass& pass : list) {
        first = std::min(first, pass.firstSlot());
        last = std::max(last, pass.lastSlot());
    }
    const auto position = positionOf(program.header, first, last);
    if (!position) {
        return refusal(program, "needle " + std::to_string(first) + " to " + std::to_string(last),
                       "the bed has needles 1 to " +
                           std::to_string(program.header.width.value_or(kDefaultWidth)));
    }
    if (list.size() > kMaxSide - kRowsBelow - kRowsAbove - 2 * kFrameRows) {
        return refusal(program, std::to_string(list.size()) + " passes", "a picture has at most 65534 rows");
    }
    const std::vector<int> numbers = carrierNumbers(program.header);
    Picture picture(first, last, list.size());
    picture.writePosition(*position);
    writeStart(picture);
    OptionWriter options;
    for (const Pass& pass : list) {
        const auto carriers = carrierValue(pass, numbers);
        if (!carriers) {
            return refusal(program,
                           "carrier set beginning with " + program.header.carriers[pass.carriers[0]].name,
                           "carriers are 1 to 10, and 10 stands in a pair only behind 2 to 9");
        }
        picture.writePass(pass, options.options(pass, *carriers));
    }
    writeEnd(picture, options.carriage());
    return encode(picture.raster());
}

} // namespace knittsim::formats::shima_dat
