#pragma once

#include "core/simulation/yarn_settling.h"

#include <QObject>
#include <QString>
#include <QThreadPool>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace knittsim::document {

class Mailbox;
class YarnJob;

/// What a run in the yarn model has come to.
struct YarnShape {
    std::uint64_t generation = 0; ///< of the run: YarnRun::generation()
    int edits = 0;                ///< of YarnRun::edits(), how many it knows of
    std::shared_ptr<const fabric::Fabric> fabric;
    std::shared_ptr<const simulation::YarnPicture> picture;
    int steps = 0;         ///< of the solver; 0 while the yarns grow
    bool growing = true;   ///< thin yarns make room for each other
    bool finished = false; ///< then `audit` and `measured` hold
    physics::StopRule::Verdict verdict = physics::StopRule::Verdict::GoOn;
    simulation::YarnAudit audit;
    geometry::Measurement measured;
};

/// Settles a fabric in the yarn model in the background and tells its shape about ten times a second. What
/// is changed meanwhile, or later, goes on from the shape. All functions: window thread; none waits.
class YarnRun : public QObject {
    Q_OBJECT

public:
    explicit YarnRun(QObject* parent = nullptr);
    ~YarnRun() override;

    /// From where the machine leaves the fabric; `yarns` by carrier. A run that still goes on is dropped.
    void start(std::shared_ptr<const fabric::Fabric> fabric, std::vector<yarn::Yarn> yarns);
    /// Stays at the shape that it has reached until resume() or an edit.
    void pause();
    void resume();
    /// Ends the run and forgets its shape.
    void clear();

    // Edits; without a run they do nothing, but surroundings count for the next one.
    void setYarn(machine::CarrierIndex carrier, const yarn::Yarn& yarn);
    void setSurroundings(simulation::Surroundings surroundings);
    void drag(fabric::PointIndex point, const Vec3& place); ///< mm; until release()
    void release();
    void setPinned(fabric::PointIndex point, bool pinned);

    bool exists() const { return m_job != nullptr; } ///< running, paused or at rest
    bool running() const { return m_running; }
    std::uint64_t generation() const { return m_generation; } ///< rises with each start
    int edits() const { return m_edits; }                     ///< since the start
    simulation::Surroundings surroundings() const { return m_surroundings; }
    /// Null before the first shape and after clear().
    std::shared_ptr<const YarnShape> shape() const { return m_shape; }
    /// Why the last run could not begin; empty when all is well.
    QString problem() const { return m_problem; }

signals:
    void changed(); ///< running(), shape(), surroundings() or problem()

private:
    using Edit = std::function<void(simulation::YarnSettling&)>;
    void edit(Edit change, bool replacesLast = false);
    void end();
    void take(std::shared_ptr<const YarnShape> shape);
    void fail(std::uint64_t generation, const QString& problem);

    std::shared_ptr<Mailbox> m_mailbox;
    std::shared_ptr<YarnJob> m_job; ///< null when there is no run
    bool m_running = false;
    bool m_dragging = false;
    std::uint64_t m_generation = 0;
    int m_edits = 0;
    simulation::Surroundings m_surroundings = simulation::Surroundings::Flat;
    std::shared_ptr<const YarnShape> m_shape;
    QString m_problem;
    QThreadPool m_pool; ///< of one thread: opening a file does not wait for it; last: it waits for its run
};

} // namespace knittsim::document
