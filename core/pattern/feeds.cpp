#include "core/pattern/feeds.h"

#include <fmt/format.h>

#include <algorithm>

namespace knittsim::pattern {

using machine::CarrierIndex;
using machine::Direction;
using machine::OperationKind;

Feeds::Feeds(const Chart& chart, const machine::MachineProfile& machine, Diagnostics& problems)
    : m_hook(machine.insertingHook) {
    const std::vector<std::string>& names = machine.carriers;
    for (const ChartYarn& yarn : chart.yarns) {
        Feed feed;
        const auto found = std::ranges::find(names, yarn.carrier);
        if (found == names.end()) {
            problems.push_back({"KS0008",
                                Severity::Error,
                                {},
                                {"carrier", yarn.carrier, fmt::format("{}", fmt::join(names, ", "))}});
        } else {
            feed.carrier = static_cast<CarrierIndex>(found - names.begin());
            if (std::ranges::count(m_feeds, feed.carrier, &Feed::carrier) > 0) {
                problems.push_back({"KS0505", Severity::Error, {}, {yarn.carrier}});
            }
        }
        m_feeds.push_back(feed);
    }
    for (int course = 0; course < chart.height(); ++course) {
        for (const int yarn : yarnsOf(chart, course)) {
            at(yarn).lastCourse = course;
        }
    }
}

void Feeds::pass(int yarn, std::vector<Work> works, ProgramBuilder& builder) {
    if (works.empty()) {
        return;
    }
    bring(yarn, true, builder);
    Feed& feed = at(yarn);
    if (feed.next == Direction::Left) {
        std::ranges::reverse(works);
    }
    for (const Work& work : works) {
        builder.work(work.kind, feed.next, work.needle, feed.carrier);
    }
    feed.next = opposite(feed.next);
}

void Feeds::release(int yarn, ProgramBuilder& builder) {
    Feed& feed = at(yarn);
    if (feed.onHook) {
        builder.carrier(OperationKind::ReleaseHook, feed.carrier);
        feed.onHook = false;
    }
}

void Feeds::takeOut(int course, ProgramBuilder& builder, const std::vector<int>& kept) {
    for (int yarn = 0; yarn < count(); ++yarn) {
        if (at(yarn).lastCourse == course && std::ranges::find(kept, yarn) == kept.end()) {
            bring(yarn, false, builder);
        }
    }
}

void Feeds::bring(int yarn, bool in, ProgramBuilder& builder) {
    Feed& feed = at(yarn);
    if (feed.in == in) {
        return;
    }
    feed.in = in;
    feed.onHook = in && m_hook;
    const auto kind = in ? (m_hook ? OperationKind::InHook : OperationKind::In)
                         : (m_hook ? OperationKind::OutHook : OperationKind::Out);
    builder.carrier(kind, feed.carrier);
}

void Feeds::follow(const machine::Operation& operation) {
    const OperationKind kind = operation.kind;
    for (const CarrierIndex yarn : operation.carriers) {
        Feed& feed = at(yarn);
        if (kind == OperationKind::In || kind == OperationKind::InHook || kind == OperationKind::YarnIn) {
            feed.in = true;
            feed.onHook = kind == OperationKind::InHook;
        } else if (kind == OperationKind::Out || kind == OperationKind::OutHook ||
                   kind == OperationKind::YarnOut) {
            feed.in = false;
            feed.onHook = false;
        } else if (kind == OperationKind::ReleaseHook) {
            feed.onHook = false;
        } else if (machine::carriesYarn(kind)) {
            feed.next = opposite(operation.direction);
        }
    }
}

machine::CarrierSet Feeds::carriersOf(const machine::CarrierSet& yarns) const {
    machine::CarrierSet carriers;
    for (const CarrierIndex yarn : yarns) {
        carriers.push(at(yarn).carrier);
    }
    return carriers;
}

} // namespace knittsim::pattern
