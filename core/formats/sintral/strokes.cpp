#include "core/formats/sintral/strokes.h"

#include "core/formats/sintral/reader.h"

#include <algorithm>
#include <utility>

namespace knittsim::formats::sintral {

using machine::Bed;
using machine::CarrierSet;
using machine::Direction;
using machine::Needle;
using machine::OperationKind;

namespace {

CarrierSet setOf(int carrier) {
    return carrier == 0 ? CarrierSet() : CarrierSet{carrier};
}

const char* nameOf(Direction direction) {
    return direction == Direction::Left ? "to the left" : "to the right";
}

} // namespace

void StrokeWriter::setSystems(const SystemList& systems) {
    m_rowStep += systems.rowStep;
    if (!systems.entries.empty()) {
        m_systems = systems.entries;
        m_nextSystem = 0;
    }
}

void StrokeWriter::setCarriers(std::vector<int> numbers) {
    m_carriers = std::move(numbers);
    m_nextCarrier = 0;
}

void StrokeWriter::setHomes(const Command& homes) {
    m_knowsHomes = true;
    m_homes.insert(homes.numbers.begin(), homes.numbers.end());
    m_rightHomes.insert(homes.numbers.begin() + homes.value, homes.numbers.end());
}

bool StrokeWriter::startJacquard(int which, int line, Spot spot) {
    const int row = m_jacquard.findRow(line);
    if (row < 0) {
        m_problems.error("KS0155", spot, {"jacquard row", std::to_string(line)});
        return false;
    }
    m_starts[which] = row;
    if (which == m_which) {
        m_row = -1;
    }
    return true;
}

bool StrokeWriter::useJacquard(int which, Spot spot) {
    if (m_starts.count(which) == 0) {
        m_problems.error("KS0155", spot, {"jacquard", "JA" + std::to_string(which)});
        return false;
    }
    if (which != m_which) {
        m_row = -1;
    }
    m_which = which;
    return true;
}

/// The carriage goes to and fro; a direction that is written is checked.
bool StrokeWriter::turn(const Stroke& stroke, Spot spot) {
    if (stroke.direction && *stroke.direction != m_next) {
        m_problems.error("KS0152", spot, {nameOf(m_next), nameOf(*stroke.direction)});
        return false;
    }
    return true;
}

bool StrokeWriter::goToRow(Spot spot) {
    const int step = std::exchange(m_rowStep, 0);
    if (step == 0) {
        return true;
    }
    const int start = m_starts.count(m_which) != 0 ? m_starts[m_which] : 0;
    const int row = (m_row < 0 ? start - 1 : m_row) + step;
    if (row < 0 || row >= m_jacquard.rowCount()) {
        m_problems.error("KS0157", spot, {"row " + std::to_string(row + 1)});
        return false;
    }
    m_row = row;
    return true;
}

/// Finds the row and the needles that an entry needs.
bool StrokeWriter::prepare(const SystemEntry& entry, Spot spot) {
    const bool symbols = entry.front.usesSymbols() || entry.rear.usesSymbols();
    if (symbols && m_row < 0) {
        m_row = m_starts.count(m_which) != 0 ? m_starts[m_which] : 0;
    }
    if (symbols && m_row >= m_jacquard.rowCount()) {
        m_problems.error("KS0157", spot, {"row"});
        return false;
    }
    if (m_range) {
        m_area = *m_range;
        return true;
    }
    if (!symbols) {
        m_problems.error("KS0154", spot);
        return false;
    }
    const int columns =
        m_field ? m_field->last - m_field->first + 1 : static_cast<int>(m_jacquard.row(m_row).size());
    m_area.first = m_fieldNeedle.value_or(1);
    m_area.last = m_area.first + columns - 1;
    return true;
}

char StrokeWriter::symbolAt(int needle) const {
    const std::string& row = m_jacquard.row(m_row);
    const int column = needle - m_fieldNeedle.value_or(m_area.first);
    const int first = m_field ? m_field->first - 1 : 0;
    const int end =
        std::min(static_cast<int>(row.size()), m_field ? m_field->last : static_cast<int>(row.size()));
    const bool inside = column >= 0 && first + column < end;
    return inside ? row[static_cast<std::size_t>(first + column)] : '\0';
}

Need StrokeWriter::need(const Selection& selection, int needle) const {
    return selection.at(needle, selection.usesSymbols() ? symbolAt(needle) : '\0');
}

bool StrokeWriter::comeIn(int carrier, Spot spot) {
    if (carrier == 0 || m_in.count(carrier) != 0) {
        return true;
    }
    if (m_knowsHomes && m_homes.count(carrier) == 0) {
        m_problems.error("KS0158", spot, {std::to_string(carrier)});
        return false;
    }
    m_in.insert(carrier);
    m_used.insert(carrier);
    m_sink.carriers(OperationKind::In, setOf(carrier));
    return true;
}

bool StrokeWriter::carryOut(const Stroke& stroke, Spot spot) {
    if (!turn(stroke, spot) || !goToRow(spot)) {
        return false;
    }
    const int count = stroke.empty ? 0 : stroke.named ? stroke.systems : static_cast<int>(m_systems.size());
    if (count > 0 && m_systems.empty()) {
        m_problems.error("KS0159", spot, {"the stroke", "S: with needles"});
        return false;
    }
    for (int i = 0; i < count && !m_sink.full(); ++i) {
        const SystemEntry& entry = m_systems[m_nextSystem];
        m_nextSystem = (m_nextSystem + 1) % m_systems.size();
        int carrier = 0;
        if (!m_carriers.empty()) {
            carrier = m_carriers[m_nextCarrier];
            m_nextCarrier = (m_nextCarrier + 1) % m_carriers.size();
        }
        if (!workSystem(entry, carrier, stroke, spot)) {
            return false;
        }
    }
    m_next = opposite(m_next);
    return true;
}

bool StrokeWriter::workSystem(const SystemEntry& entry, int carrier, const Stroke& stroke, Spot spot) {
    if (!prepare(entry, spot)) {
        return false;
    }
    m_passed += 1 + m_area.last - m_area.first;
    if (m_passed > kMaxNeedlesPassed) {
        m_problems.error("KS0156", spot, {std::to_string(kMaxNeedlesPassed) + " needles"});
        return false;
    }
    if (entry.kind != SystemEntry::Kind::Stitch) {
        return transfers(entry, stroke, spot);
    }
    if (!comeIn(carrier, spot)) {
        return false;
    }
    stitches(entry, carrier, stroke);
    return true;
}

void StrokeWriter::setStitch(const Selection& selection) {
    const auto value = m_stitchValues.find(selection.stitch);
    if (value != m_stitchValues.end()) {
        m_sink.stitchNumber(value->second);
    }
}

void StrokeWriter::workNeedle(const Selection& selection, bool front, int index, int carrier,
                              Direction direction) {
    if (index < m_area.first || index > m_area.last) {
        return;
    }
    const Need what = need(selection, index);
    if (what == Need::None) {
        return;
    }
    setStitch(selection);
    m_sink.stitch(what == Need::Knit ? OperationKind::Knit : OperationKind::Tuck,
                  Needle{front ? Bed::Front : Bed::Rear, index}, direction, setOf(carrier));
}

/// Needle by needle in the direction of the stroke; rear needle n lies right of front needle n + rack.
void StrokeWriter::stitches(const SystemEntry& entry, int carrier, const Stroke& stroke) {
    m_sink.rack(stroke.rack + stroke.fraction);
    const bool rightwards = m_next == Direction::Right;
    const int begin = std::min(m_area.first, m_area.first + stroke.rack);
    const int end = std::max(m_area.last, m_area.last + stroke.rack);
    const bool rear = entry.rear.kind != Selection::Kind::None;
    for (int i = 0; i <= end - begin && !m_sink.full(); ++i) {
        const int slot = rightwards ? begin + i : end - i;
        if (rear && !rightwards) {
            workNeedle(entry.rear, false, slot - stroke.rack, carrier, m_next);
        }
        workNeedle(entry.front, true, slot, carrier, m_next);
        if (rear && rightwards) {
            workNeedle(entry.rear, false, slot - stroke.rack, carrier, m_next);
        }
    }
}

bool StrokeWriter::transfers(const SystemEntry& entry, const Stroke& stroke, Spot spot) {
    m_sink.rack(stroke.rack);
    const auto chosen = [&](const Selection& selection, int needle) {
        return needle >= m_area.first && needle <= m_area.last && need(selection, needle) != Need::None;
    };
    for (int needle = m_area.first; needle <= m_area.last; ++needle) {
        const bool toRear = chosen(entry.front, needle);
        if (toRear && chosen(entry.rear, needle - stroke.rack)) {
            m_problems.error(
                "KS0108", spot,
                {"front and rear needle at " + std::to_string(needle), "one of them to give its loop"});
            return false;
        }
        if (toRear) {
            m_sink.transfer({Bed::Front, needle}, Bed::Rear, Direction::Right, {});
        }
        if (chosen(entry.rear, needle)) {
            m_sink.transfer({Bed::Rear, needle}, Bed::Front, Direction::Right, {});
        }
    }
    return true;
}

void StrokeWriter::finish() {
    for (const int carrier : std::exchange(m_in, {})) {
        m_sink.carriers(OperationKind::Out, setOf(carrier));
    }
}

} // namespace knittsim::formats::sintral
