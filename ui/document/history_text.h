#pragma once

#include "core/fabric/history.h"

#include <QString>

#include <vector>

namespace knittsim::document {

/// "Right foot", "Crossing on the left leg".
QString pointText(const fabric::PointHistory& history);

/// One event in words, with the line of the source that caused it, -1 where there is none.
struct HistoryLine {
    int line = -1;
    QString text;

    bool operator==(const HistoryLine&) const = default;
};

/// The events of a bonding point in the order of time, and last which yarn lies in front there.
std::vector<HistoryLine> historyLines(const machine::Timeline& timeline, const fabric::PointHistory& history);

} // namespace knittsim::document
