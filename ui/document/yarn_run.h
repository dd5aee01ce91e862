#pragma once

#include "core/simulation/yarn_settling.h"

#include <QObject>
#include <QString>
#include <QThreadPool>

#include <atomic>
#include <memory>
#include <vector>

namespace knittsim::document {

class Mailbox;

/// What a run in the yarn model has come to.
struct YarnShape {
    std::shared_ptr<const fabric::Fabric> fabric;
    std::shared_ptr<const geometry::YarnCurves> curves;
    std::vector<float> places; ///< of the bonding points: 3 per entry, mm
    int steps = 0;         ///< of the solver; 0 while the yarns grow
    bool growing = true;   ///< thin yarns make room for each other
    bool finished = false; ///< then `audit` and `measured` hold
    physics::StopRule::Verdict verdict = physics::StopRule::Verdict::GoOn;
    simulation::YarnAudit audit;
    geometry::Measurement measured;
};

/// Settles a fabric in the yarn model in the background and tells its shape about ten times a second. All
/// functions: window thread; none waits.
class YarnRun : public QObject {
    Q_OBJECT

public:
    explicit YarnRun(QObject* parent = nullptr);
    ~YarnRun() override;

    /// `yarns` by carrier. A run that still goes on is dropped.
    void start(std::shared_ptr<const fabric::Fabric> fabric, std::vector<yarn::Yarn> yarns);
    /// Ends the run and keeps the shape that it has reached.
    void stop();
    /// Ends the run and forgets its shape.
    void clear();

    bool running() const { return m_cancelled != nullptr; }
    /// Null before the first shape and after clear().
    std::shared_ptr<const YarnShape> shape() const { return m_shape; }
    /// Why the last run could not begin; empty when all is well.
    QString problem() const { return m_problem; }

signals:
    void changed(); ///< running(), shape() or problem()

private:
    using Flag = std::shared_ptr<std::atomic<bool>>;
    void take(const Flag& run, std::shared_ptr<const YarnShape> shape);
    void fail(const Flag& run, const QString& problem);

    std::shared_ptr<Mailbox> m_mailbox;
    Flag m_cancelled; ///< of the run at hand; null when none is
    std::shared_ptr<const YarnShape> m_shape;
    QString m_problem;
    QThreadPool m_pool; ///< of one thread: opening a file does not wait for it; last: it waits for its run
};

} // namespace knittsim::document
