#include "ui/document/history_text.h"

#include "ui/document/operation_text.h"

#include <QCoreApplication>

#include <algorithm>

namespace knittsim::document {

namespace {

using fabric::HistoryEvent;
using fabric::Piece;
using fabric::PointHistory;
using machine::LoopIndex;

QString tr(const char* text) {
    return QCoreApplication::translate("knittsim::document", text);
}

class Words {
    Q_DECLARE_TR_FUNCTIONS(knittsim::document::Words)

public:
    Words(const machine::Timeline& timeline, const PointHistory& history)
        : m_timeline(timeline), m_history(history) {}

    QString event(const HistoryEvent& event) const {
        switch (event.kind) {
        case HistoryEvent::Kind::Made:
            return made(event);
        case HistoryEvent::Kind::Moved:
            return moved(event);
        case HistoryEvent::Kind::Crossed:
            return crossed(event);
        case HistoryEvent::Kind::Bound:
            return tr("Bound: %1, rack %2").arg(operation(event), rackText(event.rack));
        case HistoryEvent::Kind::Dropped:
            return tr("Dropped by %1").arg(needleText(event.needle));
        case HistoryEvent::Kind::Held:
            break;
        }
        return tr("Hangs on %1").arg(needleText(event.needle));
    }

    QString inFront() const {
        return m_history.inFront == m_history.loop ? tr("The yarn of this loop lies in front here")
                                                   : tr("In front here: %1").arg(loop(m_history.inFront));
    }

private:
    QString operation(const HistoryEvent& event) const {
        return operationText(m_timeline.program(), event.operation);
    }

    /// "the loop of line 12 on front needle 5"
    QString loop(LoopIndex index) const {
        const machine::Loop& made = m_timeline.loops().loops[static_cast<std::size_t>(index)];
        const int line = m_timeline.program().operations[static_cast<std::size_t>(made.operation)].line;
        const QString needle = needleText(made.needle);
        return line > 0 ? tr("the loop of line %1 on %2").arg(line).arg(needle)
                        : tr("the loop on %1").arg(needle);
    }

    QString made(const HistoryEvent& event) const {
        const machine::Loop& loop = m_timeline.loops().loops[static_cast<std::size_t>(m_history.loop)];
        const auto through = event.others.size();
        const QString how = through == 1  ? tr(", through one loop")
                            : through > 1 ? tr(", through %1 loops").arg(through)
                            : loop.kind == machine::OperationKind::Tuck ? QString()
                                                                        : tr(", on the empty needle");
        return tr("Made: %1%2, rack %3").arg(operation(event), how, rackText(event.rack));
    }

    QString moved(const HistoryEvent& event) const {
        const auto& op = m_timeline.program().operations[static_cast<std::size_t>(event.operation)];
        const QString pattern = op.kind == machine::OperationKind::Split
                                    ? tr("Moved by the split from %1 to %2%3, rack %4")
                                    : tr("Transferred from %1 to %2%3, rack %4");
        const auto there = event.others.size();
        const QString onto = there == 0   ? QString()
                             : there == 1 ? tr(", onto one loop")
                                          : tr(", onto %1 loops").arg(there);
        return pattern.arg(needleText(event.needle), needleText(event.target), onto, rackText(event.rack));
    }

    QString crossed(const HistoryEvent& event) const {
        const LoopIndex other = event.others.front();
        const QString pattern = m_history.inFront == m_history.loop ? tr("Crossed: %1; in front of %2 of %3")
                                                                    : tr("Crossed: %1; behind %2 of %3");
        return pattern.arg(operation(event), partner(), loop(other));
    }

    QString partner() const {
        switch (m_history.partnerPiece) {
        case Piece::LeftLeg:
            return tr("the left leg");
        case Piece::RightLeg:
            return tr("the right leg");
        case Piece::Float:
            break;
        }
        return tr("the float before");
    }

    const machine::Timeline& m_timeline;
    const PointHistory& m_history;
};

} // namespace

QString pointText(const PointHistory& history) {
    const bool left = history.side == fabric::Side::Left;
    switch (history.role) {
    case fabric::Role::Foot:
        return left ? tr("Left foot") : tr("Right foot");
    case fabric::Role::Head:
        return left ? tr("Left head") : tr("Right head");
    case fabric::Role::Crossing:
        break;
    }
    return history.piece == Piece::LeftLeg    ? tr("Crossing on the left leg")
           : history.piece == Piece::RightLeg ? tr("Crossing on the right leg")
                                              : tr("Crossing on the float");
}

std::vector<HistoryLine> historyLines(const machine::Timeline& timeline, const PointHistory& history) {
    const Words words(timeline, history);
    std::vector<HistoryLine> lines;
    for (const HistoryEvent& event : history.events) {
        lines.push_back({event.line, words.event(event)});
    }
    if (history.inFront >= 0) {
        lines.push_back({-1, words.inFront()});
    }
    return lines;
}

} // namespace knittsim::document
