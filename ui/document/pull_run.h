#pragma once

#include "core/simulation/fabric_cell.h"

#include <QObject>
#include <QString>
#include <QThreadPool>

#include <atomic>
#include <memory>
#include <vector>

namespace knittsim::document {

class Mailbox;

struct PullSettings {
    physics::CellLoadTerm::Side side = physics::CellLoadTerm::Width;
    double strain = 0.6;
    int steps = 20;
};

/// Draws one repeat of a fabric longer and back in the yarn model, on a thread of its own, and tells every
/// point. All functions: window thread; none waits.
class PullRun : public QObject {
    Q_OBJECT

public:
    enum class State { Idle, Settling, Pulling, Done, Stopped, NoRepeat, NotAtRest };

    explicit PullRun(QObject* parent = nullptr);
    ~PullRun() override;

    /// `yarns` by carrier. A run that still goes on is dropped.
    void start(std::shared_ptr<const fabric::Fabric> fabric, std::vector<yarn::Yarn> yarns,
               const PullSettings& settings);
    void stop(); ///< keeps the points

    State state() const { return m_state; }
    bool running() const { return m_state == State::Settling || m_state == State::Pulling; }
    const PullSettings& settings() const { return m_settings; } ///< of the last start
    const std::vector<physics::PullPoint>& points() const { return m_points; }
    const physics::YarnUnits& units() const { return m_units; } ///< of the points
    int wales() const { return m_wales; }                       ///< of the repeat
    int courses() const { return m_courses; }
    QByteArray csv() const;

signals:
    void changed();

private:
    using Flag = std::shared_ptr<std::atomic<bool>>;
    void end(State state);

    std::shared_ptr<Mailbox> m_mailbox;
    Flag m_cancelled; ///< of the run at hand; null when none is
    State m_state = State::Idle;
    PullSettings m_settings;
    std::vector<physics::PullPoint> m_points;
    physics::YarnUnits m_units;
    int m_wales = 0;
    int m_courses = 0;
    QThreadPool m_pool; ///< of one thread; last: it waits for its run
};

} // namespace knittsim::document
