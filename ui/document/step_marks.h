#pragma once

#ifndef Q_MOC_RUN // moc 6.4 does not read all headers of C++20
#include "ui/document/stop_rules.h"

#include <set>
#endif

#include <QByteArray>
#include <QObject>

namespace knittsim::document {

/// What a person marked along the steps of a program: bookmarks, a range to play again and again, and rules
/// where playing stops.
class StepMarks : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    using Step = machine::OperationIndex;
    static constexpr Step kNone = -1;

    /// Forgets what belongs to one program. Rules stay, but for the carrier.
    void clear();
    /// The program has `end` operations now: forgets bookmarks behind them and shortens the range.
    void endAt(Step end);

    const std::set<Step>& bookmarks() const { return m_bookmarks; }
    void toggleBookmark(Step step);
    void setBookmarks(std::set<Step> steps);
    /// The neighbour of `step` in a direction, or kNone.
    Step bookmarkFrom(Step step, int direction) const;

    /// Where the range begins and ends; kNone where it is not set. It loops when both are set.
    Step loopFrom() const { return m_from; }
    Step loopTo() const { return m_to; }
    bool loops() const { return m_from >= 0 && m_to > m_from; }
    /// Setting one end behind the other one removes the other one.
    void setLoopFrom(Step step);
    void setLoopTo(Step step);
    void endLoop();

    const StopRules& rules() const { return m_rules; }
    void setRules(const StopRules& rules);

    /// All of it as text (JSON), for keeping between runs.
    QByteArray save() const;
    /// Takes what save() wrote, and what of it can be used from other text; true unless nothing can be.
    bool restore(const QByteArray& text);

    /// Where playing goes from `from` when `due` more steps are due, and whether it stops there.
    struct Move {
        Step step = 0;
        bool stops = false;
    };
    Move play(const StopFinder& finder, Step from, int due, Step end) const;

signals:
    void changed();

private:
    std::set<Step> m_bookmarks;
    Step m_from = kNone;
    Step m_to = kNone;
    StopRules m_rules;
};

} // namespace knittsim::document
