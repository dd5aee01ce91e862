#include "core/formats/shima_dat/reader.h"

#include "core/formats/program_sink.h"
#include "core/formats/shima_dat/layout_finder.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace knittsim::formats::shima_dat {

using machine::Bed;
using machine::CarrierIndex;
using machine::CarrierSet;
using machine::Direction;
using machine::Needle;
using machine::OperationKind;
using passes::Cell;
using passes::Work;

namespace {

/// Rows and columns as a person counts them.
Spot spot(int row, int column = 0) {
    return {row + 1, column + 1};
}

/// One or two carriers written as digits; 10 is 0 behind another digit. Nothing for other numbers.
std::optional<CarrierSet> carriersOf(int number) {
    if (number >= 1 && number <= kCarriers) {
        return CarrierSet{number - 1};
    }
    if (number == 110) {
        return CarrierSet{0, kCarriers - 1};
    }
    const int first = number / 10;
    const int second = number % 10 == 0 ? kCarriers : number % 10;
    if (number > kCarriers && number < 100 && first != second) {
        return CarrierSet{first - 1, second - 1};
    }
    return std::nullopt;
}

OperationKind kindOf(Work work) {
    return work == Work::Knit   ? OperationKind::Knit
           : work == Work::Tuck ? OperationKind::Tuck
                                : OperationKind::Miss;
}

class Reader {
public:
    Reader(const Raster& raster, const Frame& frame, machine::Program& program, Problems& problems)
        : m_raster(raster), m_frame(frame), m_problems(problems), m_sink(program, problems) {}

    void run();

private:
    bool isFrameRow(int row, std::uint8_t colour) const;
    void readPass(int row);
    bool readOptions(int row);
    bool readCarriers(int row);
    void checkOthers(int row);
    void readSettings();
    void readPresser(int row);
    bool comeIn(int row);
    void goOut();
    void readCells(int row);
    void readCell(int row, int slot);
    void work(Work front, Work rear, int slot);
    void giveBack(int row);
    bool wrong(int row, const char* line, int value, const char* expected);
    std::uint8_t pixel(int row, int slot) const;

    const Raster& m_raster;
    const Frame& m_frame;
    Problems& m_problems;
    ProgramSink m_sink;

    Options m_options; ///< of the pass being read
    CarrierSet m_carriers;
    std::vector<std::pair<Needle, double>> m_onSliders; ///< hooks they came from, and racking to give back at
    CarrierSet m_hook;
    double m_speed = 0;
    bool m_presser = false;
    std::set<std::pair<char, int>> m_saidOptions;
};

void Reader::run() {
    int first = m_frame.firstRow;
    int end = m_frame.endRow;
    if (end - first >= 2 * kFrameRows && isFrameRow(first, 216) && isFrameRow(first + 1, 51) &&
        isFrameRow(first + 2, 52) && isFrameRow(end - 3, 51) && isFrameRow(end - 2, 52) &&
        isFrameRow(end - 1, 3)) {
        first += kFrameRows;
        end -= kFrameRows;
    } else {
        m_problems.warn("KS0137", spot(first));
    }
    for (int row = first; row < end && !m_problems.full() && !m_sink.full(); ++row) {
        m_sink.setLine(row + 1);
        readPass(row);
    }
}

std::uint8_t Reader::pixel(int row, int slot) const {
    return m_raster.row(row)[static_cast<std::size_t>(m_frame.firstColumn() + slot - m_frame.firstNeedle)];
}

/// A pass without yarn and stitch number over the whole width.
bool Reader::isFrameRow(int row, std::uint8_t colour) const {
    const Options options = optionsOf(m_raster, m_frame, row);
    const auto pixels =
        m_raster.row(row).subspan(static_cast<std::size_t>(m_frame.firstColumn()),
                                  static_cast<std::size_t>(m_frame.endColumn() - m_frame.firstColumn()));
    return options.right[right::kCarrier] == kNoCarrier && options.right[right::kStitch] == 0 &&
           std::all_of(pixels.begin(), pixels.end(), [&](std::uint8_t c) { return c == colour; });
}

bool Reader::wrong(int row, const char* line, int value, const char* expected) {
    m_problems.error("KS0136", spot(row), {line, std::to_string(value), expected});
    return false;
}

void Reader::readPass(int row) {
    m_options = optionsOf(m_raster, m_frame, row);
    if (!readOptions(row) || !readCarriers(row)) {
        return;
    }
    checkOthers(row);
    readSettings();
    readPresser(row);
    if (!comeIn(row)) {
        return;
    }
    readCells(row);
    giveBack(row);
    goOut();
}

bool Reader::readOptions(int row) {
    const int interleaved = m_options.left[left::kInterleaved];
    const int side = m_options.left[left::kRackingSide];
    if (interleaved > 1) {
        return wrong(row, "L3", interleaved, "0 or 1");
    }
    if (side != 10 && side != 11) {
        return wrong(row, "L4", side, "10 or 11");
    }
    const int amount = m_options.left[left::kRacking];
    if (amount > 100) {
        return wrong(row, "L2", amount, "at most 100");
    }
    const int split = m_options.left[left::kSplitOrMiss];
    if (split != 0 && split != 10 && split != 20) {
        return wrong(row, "L12", split, "0, 10 or 20");
    }
    const int sliders = m_options.left[left::kSliders];
    if (sliders != 0 && sliders != 1 && sliders != 3) {
        return wrong(row, "L13", sliders, "0, 1 or 3");
    }
    const int hook = m_options.right[right::kHook];
    if (hook != 0 && hook != 10 && hook != 20 && hook != 90) {
        return wrong(row, "R15", hook, "0, 10, 20 or 90");
    }
    return true;
}

bool Reader::readCarriers(int row) {
    m_carriers = {};
    const int number = m_options.right[right::kCarrier];
    if (number == 0 || number == kNoCarrier) {
        return true;
    }
    const auto carriers = carriersOf(number);
    if (!carriers) {
        return wrong(row, "R3", number, "one or two carriers");
    }
    m_carriers = *carriers;
    return true;
}

/// Option lines that the emulator does not know. Each is named once.
void Reader::checkOthers(int row) {
    constexpr std::uint32_t kLeft =
        1U << 2 | 1U << 3 | 1U << 4 | 1U << 5 | 1U << 6 | 1U << 7 | 1U << 12 | 1U << 13;
    constexpr std::uint32_t kRight =
        1U << 3 | 1U << 5 | 1U << 6 | 1U << 9 | 1U << 10 | 1U << 11 | 1U << 13 | 1U << 15;
    for (int line = 1; line <= kOptionLines; ++line) {
        const auto index = static_cast<std::size_t>(line);
        const auto say = [&](char side, std::uint8_t value, std::uint32_t known) {
            if (value != 0 && (known >> line & 1U) == 0 && m_saidOptions.emplace(side, line).second) {
                m_problems.warn("KS0135", spot(row), {side + std::to_string(line), std::to_string(value)});
            }
        };
        say('L', m_options.left[index], kLeft);
        say('R', m_options.right[index], kRight);
    }
}

void Reader::readSettings() {
    if (m_options.left[left::kPause] != 0) {
        m_sink.pause({});
    }
    const int amount = m_options.left[left::kRacking];
    const double whole = m_options.left[left::kRackingSide] == 11 ? amount + 1 : -amount;
    m_sink.rack(whole + (m_options.left[left::kInterleaved] != 0 ? 0.25 : 0));
    const int raw = m_options.left[left::kKnitSpeed];
    const double speed = raw > 10 ? raw - 10 : 0;
    if (speed != std::exchange(m_speed, speed)) {
        m_sink.extension("x-speed-number " + std::to_string(static_cast<int>(speed)));
    }
    // Passes of transfers have a stitch number of their own.
    if (m_options.right[right::kCancel] != 1) {
        m_sink.stitchNumber(m_options.right[right::kStitch]);
    }
}

/// A pass says only whether the presser works. It is taken to follow the beds by itself, which holds for a
/// pass of one bed with the hook empty.
void Reader::readPresser(int row) {
    bool front = false;
    bool rear = false;
    for (int slot = m_frame.firstNeedle;
         slot < m_frame.firstNeedle + m_frame.endColumn() - m_frame.firstColumn(); ++slot) {
        if (const Colour* colour = findColour(pixel(row, slot))) {
            front = front || colour->cell.front == Work::Knit || colour->cell.front == Work::Tuck;
            rear = rear || colour->cell.rear == Work::Knit || colour->cell.rear == Work::Tuck;
        }
    }
    const bool tells = front != rear && m_hook.empty() && m_options.right[right::kHook] == 0;
    const bool works = m_options.right[right::kPresser] == 101;
    if (works != m_presser && (works || tells)) {
        m_presser = works;
        m_sink.extension(works ? "x-presser-mode auto" : "x-presser-mode off");
    }
}

bool Reader::comeIn(int row) {
    const int hook = m_options.right[right::kHook];
    if (hook == 90) {
        m_sink.carriers(OperationKind::ReleaseHook, std::exchange(m_hook, {}));
    }
    const int gripper = m_options.right[right::kGripper];
    if (gripper == 0 || gripper >= 100) {
        return true;
    }
    const auto carriers = carriersOf(gripper);
    if (!carriers) {
        return wrong(row, "R10", gripper, "one or two carriers");
    }
    if (hook == 10) {
        m_hook = *carriers;
    }
    m_sink.carriers(hook == 10 ? OperationKind::InHook : OperationKind::In, *carriers);
    return true;
}

void Reader::goOut() {
    const int gripper = m_options.right[right::kGripper];
    const auto carriers = gripper > 100 ? carriersOf(gripper - 100) : std::nullopt;
    if (carriers) {
        const bool hook = m_options.right[right::kHook] == 20;
        m_sink.carriers(hook ? OperationKind::OutHook : OperationKind::Out, *carriers);
    }
}

void Reader::readCells(int row) {
    const int count = m_frame.endColumn() - m_frame.firstColumn();
    const bool leftwards = m_options.direction == Direction::Left;
    for (int i = 0; i < count && !m_problems.full() && !m_sink.full(); ++i) {
        readCell(row, m_frame.firstNeedle + (leftwards ? count - 1 - i : i));
    }
}

void Reader::readCell(int row, int slot) {
    const std::uint8_t number = pixel(row, slot);
    if (number == 0 || number == kStopMark) {
        return;
    }
    if (const Colour* colour = findColour(number)) {
        work(colour->cell.front, colour->cell.rear, slot);
        return;
    }
    for (const SliderSplit& split : kSliderSplits) {
        if (split.number == number) {
            const double back = m_sink.rack() + (split.front ? split.way : -split.way);
            const int rack = static_cast<int>(std::floor(m_sink.rack()));
            const Needle hook = split.front ? Needle{Bed::Front, slot} : Needle{Bed::Rear, slot - rack};
            m_onSliders.emplace_back(hook, back);
            m_sink.transfer(hook, split.front ? Bed::RearSlider : Bed::FrontSlider,
                            m_options.direction.value_or(Direction::Right), m_carriers);
            return;
        }
    }
    m_problems.error("KS0134", spot(row, m_frame.firstColumn() + slot - m_frame.firstNeedle),
                     {std::to_string(number), std::to_string(slot)});
}

void Reader::work(Work front, Work rear, int slot) {
    const Direction direction = m_options.direction.value_or(Direction::Right);
    const int rack = static_cast<int>(std::floor(m_sink.rack()));
    const int sliders = m_options.left[left::kSliders];
    const auto one = [&](Work work, bool isFront) {
        if (work == Work::None) {
            return;
        }
        Needle needle = isFront ? Needle{Bed::Front, slot} : Needle{Bed::Rear, slot - rack};
        if (work != Work::Transfer && work != Work::Split) {
            m_sink.stitch(kindOf(work), needle, direction, m_carriers);
            return;
        }
        if (sliders == 3) {
            needle.bed = isFront ? Bed::FrontSlider : Bed::RearSlider;
        }
        const Bed target = isFront ? (sliders == 1 ? Bed::RearSlider : Bed::Rear)
                                   : (sliders == 1 ? Bed::FrontSlider : Bed::Front);
        m_sink.transfer(needle, target, direction, work == Work::Split ? m_carriers : CarrierSet());
    };
    // Of two needles at one slot the front one lies left.
    if (m_options.direction == Direction::Left) {
        one(rear, false);
        one(front, true);
    } else {
        one(front, true);
        one(rear, false);
    }
}

/// Loops split to sliders come back onto the bed they came from.
void Reader::giveBack(int row) {
    if (m_onSliders.empty()) {
        return;
    }
    const double before = m_sink.rack();
    const int rack = static_cast<int>(std::floor(before));
    const double back = m_onSliders.front().second;
    const bool one = std::all_of(m_onSliders.begin(), m_onSliders.end(),
                                 [&](const auto& entry) { return entry.second == back; });
    if (!one) {
        m_problems.error("KS0138", spot(row));
    } else {
        m_sink.rack(back);
        for (const auto& [hook, unused] : m_onSliders) {
            const bool front = isFront(hook.bed);
            const Needle slider = front ? Needle{Bed::RearSlider, hook.index - rack}
                                        : Needle{Bed::FrontSlider, hook.index + rack};
            m_sink.transfer(slider, hook.bed, Direction::Right, {});
        }
        m_sink.rack(before);
    }
    m_onSliders.clear();
}

} // namespace

Result<machine::Program> parse(std::string_view bytes, const std::string& file) {
    Problems problems(file, kMaxErrors);
    machine::Program program;
    program.file = file;
    program.header.machine = "SWG";
    program.header.position = "Keep";
    for (int i = 0; i < kCarriers; ++i) {
        program.header.carriers.push_back({std::to_string(i + 1), i, false, {}});
    }
    const Raster raster = decode(bytes, problems);
    if (problems.errorCount() == 0) {
        if (const auto frame = findFrame(raster)) {
            Reader(raster, *frame, program, problems).run();
        } else {
            problems.error("KS0133", {1, 1});
        }
    }
    if (problems.errorCount() > 0) {
        return Result<machine::Program>::failure(problems.take());
    }
    return {std::move(program), problems.take()};
}

} // namespace knittsim::formats::shima_dat
