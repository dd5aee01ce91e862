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
    Feed& feed = at(yarn);
    if (!feed.in) {
        feed.in = true;
        feed.onHook = m_hook;
        builder.carrier(m_hook ? OperationKind::InHook : OperationKind::In, feed.carrier);
    }
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

void Feeds::takeOut(int course, ProgramBuilder& builder) {
    for (Feed& feed : m_feeds) {
        if (feed.in && feed.lastCourse == course) {
            feed.in = false;
            builder.carrier(m_hook ? OperationKind::OutHook : OperationKind::Out, feed.carrier);
        }
    }
}

} // namespace knittsim::pattern
