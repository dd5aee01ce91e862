#include "ui/document/step_marks.h"

#include <algorithm>

namespace knittsim::document {

void StepMarks::clear() {
    m_bookmarks.clear();
    m_from = m_to = kNone;
    m_rules.carrier.reset();
    emit changed();
}

void StepMarks::endAt(Step end) {
    const auto behind = m_bookmarks.upper_bound(end);
    if (behind == m_bookmarks.end() && m_from <= end && m_to <= end) {
        return;
    }
    m_bookmarks.erase(behind, m_bookmarks.end());
    m_to = std::min(m_to, end);
    if (m_from > end || m_from == m_to) {
        m_from = m_to = kNone;
    }
    emit changed();
}

void StepMarks::toggleBookmark(Step step) {
    if (m_bookmarks.erase(step) == 0) {
        m_bookmarks.insert(step);
    }
    emit changed();
}

void StepMarks::setBookmarks(std::set<Step> steps) {
    m_bookmarks = std::move(steps);
    emit changed();
}

StepMarks::Step StepMarks::bookmarkFrom(Step step, int direction) const {
    if (direction > 0) {
        const auto found = m_bookmarks.upper_bound(step);
        return found == m_bookmarks.end() ? kNone : *found;
    }
    const auto found = m_bookmarks.lower_bound(step);
    return found == m_bookmarks.begin() ? kNone : *std::prev(found);
}

void StepMarks::setLoopFrom(Step step) {
    m_from = step;
    m_to = m_to > step ? m_to : kNone;
    emit changed();
}

void StepMarks::setLoopTo(Step step) {
    m_to = step;
    m_from = m_from < step ? m_from : kNone;
    emit changed();
}

void StepMarks::endLoop() {
    m_from = m_to = kNone;
    emit changed();
}

void StepMarks::setRules(const StopRules& rules) {
    m_rules = rules;
    emit changed();
}

StepMarks::Move StepMarks::play(const StopFinder& finder, Step from, int due, Step end) const {
    const bool inLoop = loops() && from < m_to;
    const Step last = inLoop ? m_to : end;
    const Step target = std::min(from + due, last);
    if (const auto stop = finder.first(m_rules, from, target); stop >= 0) {
        return {stop + 1, true};
    }
    // The end of the range is seen before it begins again.
    if (loops() && from >= m_to && due > 0) {
        return {m_from, false};
    }
    return {target, target == end && !loops()};
}

} // namespace knittsim::document
