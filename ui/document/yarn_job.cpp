#include "ui/document/yarn_job.h"

#include <utility>

namespace knittsim::document {

void YarnJob::add(Edit edit, bool replacesLast) {
    {
        const std::lock_guard lock(m_mutex);
        if (replacesLast && m_lastMayGo && !m_edits.empty()) {
            m_edits.pop_back();
        }
        m_edits.push_back(std::move(edit));
        m_lastMayGo = replacesLast;
        m_paused = false;
        ++m_count;
        if (!replacesLast) {
            m_disturbed = true;
        }
    }
    m_changed.notify_one();
}

void YarnJob::pause(bool paused) {
    {
        const std::lock_guard lock(m_mutex);
        m_paused = paused;
        m_disturbed = true;
    }
    m_changed.notify_one();
}

void YarnJob::end() {
    {
        const std::lock_guard lock(m_mutex);
        m_ended = true;
        m_disturbed = true;
    }
    m_changed.notify_one();
}

YarnJob::Orders YarnJob::next(bool atRest) {
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [&] { return m_ended || !m_edits.empty() || !(m_paused || atRest); });
    if (!m_ended) {
        m_disturbed = false;
    }
    return {std::exchange(m_edits, {}), m_count, m_ended};
}

} // namespace knittsim::document
