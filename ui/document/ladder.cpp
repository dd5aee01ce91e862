#include "ui/document/ladder.h"

#include "ui/document/mailbox.h"

#include <QThreadPool>

#include <algorithm>
#include <utility>

namespace knittsim::document {

namespace {

constexpr int kStepMs = 250;     ///< between two steps of a short ladder
constexpr int kLongestMs = 4000; ///< of a whole run
constexpr int kTickMs = 40;

} // namespace

std::shared_ptr<const fabric::Fabric> fabricOf(const std::shared_ptr<const fabric::ReducedFabric>& reduced) {
    return {reduced, &reduced->fabric};
}

LadderRunner::LadderRunner(QObject* parent) : QObject(parent), m_mailbox(std::make_shared<Mailbox>(this)) {
    m_tick.setInterval(kTickMs);
    connect(&m_tick, &QTimer::timeout, this, &LadderRunner::makeNext);
}

LadderRunner::~LadderRunner() {
    m_mailbox->close();
}

void LadderRunner::start(std::shared_ptr<Ladder> ladder) {
    cancel();
    m_ladder = std::move(ladder);
    m_since.start();
    m_tick.start();
    makeNext();
}

void LadderRunner::finish() {
    m_atOnce = true;
    makeNext();
}

void LadderRunner::cancel() {
    ++m_generation;
    m_ladder.reset();
    m_told.reset();
    m_stepsTold = 0;
    m_loopsRun = 0;
    m_atOnce = false;
    m_tick.stop();
}

/// The step that time asks for; the first comes at once.
int LadderRunner::stepWanted() const {
    const int all = static_cast<int>(m_ladder->runs.steps.size());
    const int whole = std::min(kLongestMs, kStepMs * all);
    const auto due = 1 + m_since.elapsed() * all / std::max(1, whole);
    return m_atOnce ? all : static_cast<int>(std::min<qint64>(due, all));
}

void LadderRunner::makeNext() {
    if (!m_ladder || m_busy || stepWanted() <= m_stepsTold) {
        return;
    }
    m_busy = true;
    QThreadPool::globalInstance()->start([this, before = m_ladder->before, runs = m_ladder->runs,
                                          steps = stepWanted(), told = m_told, generation = m_generation,
                                          mailbox = m_mailbox] {
        auto reduced = std::make_shared<fabric::ReducedFabric>(fabric::removeRuns(*before, runs, steps));
        auto pairs = told ? fabric::pairEntries(*reduced, *told) : reduced->entryBefore;
        mailbox->post([this, reduced, pairs = std::move(pairs), steps, generation] {
            m_busy = false;
            if (generation == m_generation) {
                take(reduced, pairs, steps);
            }
            makeNext();
        });
    });
}

void LadderRunner::take(const std::shared_ptr<const fabric::ReducedFabric>& reduced,
                        const std::vector<fabric::EntryIndex>& pairs, int steps) {
    const auto& all = m_ladder->runs.steps;
    for (auto s = static_cast<std::size_t>(m_stepsTold); s < static_cast<std::size_t>(steps); ++s) {
        m_loopsRun += all[s].size();
    }
    m_stepsTold = steps;
    m_told = reduced;
    if (static_cast<std::size_t>(steps) == all.size()) {
        m_ladder->after = reduced;
        cancel();
    }
    emit stepped(reduced, pairs);
}

} // namespace knittsim::document
