#pragma once

#include "core/simulation/yarn_settling.h"

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <vector>

namespace knittsim::document {

/// The bridge between a window and the thread that settles its yarn: edits in, the wish to pause or to end.
class YarnJob {
public:
    using Edit = std::function<void(simulation::YarnSettling&)>;

    // Window thread.

    /// `replacesLast`: the last edit, if nobody has taken it yet, is out of date; a step at hand is finished
    /// first, so that a stream of them does not keep the yarn from moving.
    void add(Edit edit, bool replacesLast);
    void pause(bool paused);
    void end();

    // Its thread.

    struct Orders {
        std::vector<Edit> edits;
        int taken = 0; ///< edits asked for so far, replaced ones too
        bool ended = false;
    };
    /// Waits while there is nothing to do: paused, or `atRest`, and no edit.
    Orders next(bool atRest);

    /// True once a step at hand had better stop: the job has ended or there are edits. Outlived by the job.
    const std::function<bool()>& disturbed() const { return m_isDisturbed; }
    const std::function<bool()>& ended() const { return m_isEnded; }

private:
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::vector<Edit> m_edits;
    int m_count = 0;
    bool m_lastMayGo = false;
    bool m_paused = false;
    std::atomic<bool> m_ended = false;
    std::atomic<bool> m_disturbed = false;
    std::function<bool()> m_isDisturbed = [this] { return m_disturbed.load(); };
    std::function<bool()> m_isEnded = [this] { return m_ended.load(); };
};

} // namespace knittsim::document
