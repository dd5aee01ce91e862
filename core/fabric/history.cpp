#include "core/fabric/history.h"

#include <algorithm>
#include <cstddef>

namespace knittsim::fabric {

namespace {

using machine::Emulator;
using Kind = HistoryEvent::Kind;

/// Writes down what the machine does to one loop.
class LoopWatcher : public machine::EmulationListener {
public:
    LoopWatcher(const machine::Timeline& timeline, const Emulator& emulator, LoopIndex loop)
        : m_timeline(timeline), m_emulator(emulator), m_loop(loop) {}

    bool onNeedle() const {
        const auto hanging = m_emulator.state().loopsOn(m_needle);
        return std::ranges::find(hanging, m_loop) != hanging.end();
    }

    std::vector<HistoryEvent> takeEvents() { return std::move(m_events); }

    void hold() { m_events.push_back({.kind = Kind::Held, .needle = m_needle, .rack = rack()}); }

    void loopMade(LoopIndex made) override {
        const machine::LoopTable& loops = m_timeline.loops();
        const auto parents = loops.parentsOf(made);
        const Needle needle = loops.loops[static_cast<std::size_t>(made)].needle;
        if (made == m_loop) {
            m_needle = needle;
            add(Kind::Made, needle).others.assign(parents.begin(), parents.end());
        } else if (std::ranges::find(parents, m_loop) != parents.end()) {
            bind(needle).others.push_back(made);
        }
    }

    void loopsMoved(Needle from, Needle to, std::span<const LoopIndex> loops) override {
        if (std::ranges::find(loops, m_loop) == loops.end()) {
            return;
        }
        HistoryEvent& event = add(Kind::Moved, from);
        event.target = to;
        const auto there = m_emulator.state().loopsOn(to);
        event.others.assign(there.begin(), there.end());
        m_needle = to;
    }

    void loopsDropped(Needle needle, std::span<const LoopIndex> loops) override {
        if (std::ranges::find(loops, m_loop) != loops.end()) {
            add(Kind::Dropped, needle);
        }
    }

private:
    OperationIndex operation() const { return m_emulator.state().nextOperation - 1; }
    double rack() const { return m_emulator.state().rack; }

    /// Several yarns of one operation bind in one event. A split draws its loop through before the old one
    /// moves on, though the machine tells the move first.
    HistoryEvent& bind(Needle needle) {
        const auto sameBond = std::ranges::find_if(m_events, [&](const HistoryEvent& event) {
            return event.kind == Kind::Bound && event.operation == operation();
        });
        if (sameBond != m_events.end()) {
            return *sameBond;
        }
        add(Kind::Bound, needle);
        const auto last = m_events.end() - 1;
        if (const auto move = last - 1; move->operation == last->operation) {
            std::iter_swap(move, last);
            return *move;
        }
        return *last;
    }

    HistoryEvent& add(Kind kind, Needle needle) {
        const OperationIndex op = operation();
        m_events.push_back({.kind = kind,
                            .operation = op,
                            .line = m_timeline.program().operations[static_cast<std::size_t>(op)].line,
                            .needle = needle,
                            .rack = rack()});
        return m_events.back();
    }

    const machine::Timeline& m_timeline;
    const Emulator& m_emulator;
    LoopIndex m_loop;
    Needle m_needle; ///< on which it hangs, or hung last
    std::vector<HistoryEvent> m_events;
};

const BondingPoint& partnerOf(const Fabric& fabric, const BondingPoint& point) {
    const Crossing& crossing = fabric.crossings[static_cast<std::size_t>(point.crossing)];
    return fabric.points[static_cast<std::size_t>(point.front > 0 ? crossing.under : crossing.over)];
}

/// The passing at a crossing, as seen from one of its points.
HistoryEvent crossingEvent(const Fabric& fabric, const machine::Timeline& timeline,
                           const BondingPoint& point) {
    const Crossing& crossing = fabric.crossings[static_cast<std::size_t>(point.crossing)];
    const auto op = static_cast<std::size_t>(crossing.operation);
    return {.kind = Kind::Crossed,
            .operation = crossing.operation,
            .line = timeline.program().operations[op].line,
            .needle = point.needle,
            .rack = timeline.stateAfter(crossing.operation + 1).rack,
            .others = {partnerOf(fabric, point).loop}};
}

/// Feet and heads at one place: a loop pulled to the front lies in front of the heads it came through.
LoopIndex frontOfBond(const Fabric& fabric, EntryIndex entry) {
    LoopIndex foot = -1;
    LoopIndex head = -1;
    for (const PointIndex p : fabric.at(entry)) {
        const BondingPoint& point = fabric.points[static_cast<std::size_t>(p)];
        LoopIndex& found = point.role == Role::Foot ? foot : head;
        found = std::max(found, point.loop);
    }
    if (foot < 0 || head < 0) {
        return -1;
    }
    const bool toTheFront = machine::isFront(fabric.made.loops[static_cast<std::size_t>(foot)].needle.bed);
    return toTheFront ? foot : head;
}

} // namespace

std::vector<HistoryEvent> loopHistory(const machine::Timeline& timeline, LoopIndex loop,
                                      OperationIndex count) {
    const OperationIndex end =
        count < 0 ? timeline.operationCount() : std::min(count, timeline.operationCount());
    const OperationIndex making = timeline.loops().loops[static_cast<std::size_t>(loop)].operation;
    if (end <= making) {
        return {};
    }
    Emulator emulator(timeline.program(), timeline.profile(), timeline.stateAfter(making));
    LoopWatcher watcher(timeline, emulator, loop);
    bool held = true;
    while (held && emulator.state().nextOperation < end) {
        emulator.step(&watcher);
        held = watcher.onNeedle();
    }
    if (held) {
        watcher.hold();
    }
    return watcher.takeEvents();
}

PointHistory pointHistory(const Fabric& fabric, const machine::Timeline& timeline, PointIndex point,
                          OperationIndex count) {
    const BondingPoint& p = fabric.points[static_cast<std::size_t>(point)];
    const auto loop = static_cast<std::size_t>(p.loop);
    PointHistory history{.point = point,
                         .loop = p.loop,
                         .role = p.role,
                         .side = p.side,
                         .piece = p.piece,
                         .carrier = fabric.made.loops[loop].carrier,
                         .course = fabric.loops[loop].course,
                         .inFront = -1,
                         .partnerPiece = Piece::LeftLeg,
                         .events = loopHistory(timeline, p.loop, count)};
    if (p.role != Role::Crossing) {
        history.inFront = frontOfBond(fabric, p.entry);
        return history;
    }
    const HistoryEvent crossed = crossingEvent(fabric, timeline, p);
    history.inFront = p.front > 0 ? p.loop : crossed.others.front();
    history.partnerPiece = partnerOf(fabric, p).piece;
    const auto later = std::ranges::find_if(history.events, [&](const HistoryEvent& event) {
        return event.operation > crossed.operation || event.kind == Kind::Held;
    });
    history.events.insert(later, crossed);
    return history;
}

} // namespace knittsim::fabric
