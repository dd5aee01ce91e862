#pragma once

#include "core/fabric/reduction.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <cstddef>
#include <memory>
#include <vector>

namespace knittsim::document {

class Mailbox;

/// One removal of all loops that nothing holds: what was before, and what is after once it has run.
struct Ladder {
    std::shared_ptr<const fabric::Fabric> before;
    std::vector<float> placesBefore; ///< 3 per entry of `before`, mm; empty: as the machine left it
    fabric::Runs runs;
    std::shared_ptr<const fabric::ReducedFabric> after; ///< null until it has run to its end
};

/// The fabric of a reduction; lives as long as the reduction.
std::shared_ptr<const fabric::Fabric> fabricOf(const std::shared_ptr<const fabric::ReducedFabric>& reduced);

/// Lets a ladder run course by course: a few steps of its Runs a second, more in a long one, so that it takes
/// about four seconds at most. Fabrics are made in the background.
class LadderRunner : public QObject {
    Q_OBJECT

public:
    explicit LadderRunner(QObject* parent = nullptr);
    ~LadderRunner() override;

    void start(std::shared_ptr<Ladder> ladder);
    void finish(); ///< goes to the end as soon as it can
    void cancel(); ///< nothing more is told
    bool running() const { return m_ladder != nullptr; }

    std::size_t loopsRun() const { return m_loopsRun; } ///< of the ladder that runs

signals:
    /// `pairs`: by entry of `reduced` the entry of the fabric told before, at first Ladder::before. When
    /// running() is over, it was the last one and Ladder::after is set.
    void stepped(std::shared_ptr<const knittsim::fabric::ReducedFabric> reduced,
                 const std::vector<knittsim::fabric::EntryIndex>& pairs);

private:
    int stepWanted() const;
    void makeNext();
    void take(const std::shared_ptr<const fabric::ReducedFabric>& reduced,
              const std::vector<fabric::EntryIndex>& pairs, int steps);

    std::shared_ptr<Mailbox> m_mailbox;
    std::shared_ptr<Ladder> m_ladder;                    ///< null while none runs
    std::shared_ptr<const fabric::ReducedFabric> m_told; ///< the last one
    int m_stepsTold = 0;
    std::size_t m_loopsRun = 0;
    bool m_atOnce = false;
    bool m_busy = false;
    std::uint64_t m_generation = 0;
    QElapsedTimer m_since;
    QTimer m_tick;
};

} // namespace knittsim::document
