#pragma once

#include "core/simulation/worker.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <memory>
#include <vector>

namespace knittsim::document {

class Mailbox;

/// The worker as a Qt object: numbers the generations, drops frames of older ones, and passes news on at most
/// about 60 times a second. Never waits for the worker.
class SimulationBridge : public QObject {
    Q_OBJECT

public:
    explicit SimulationBridge(QObject* parent = nullptr);
    ~SimulationBridge() override;

    /// Frames that follow belong to `fabric`.
    void load(std::shared_ptr<const fabric::Fabric> fabric, std::vector<yarn::Yarn> yarns);
    /// Goes on with another fabric at these places (3 per entry, mm; empty: the machine's).
    void replace(std::shared_ptr<const fabric::Fabric> fabric, std::vector<float> places);
    void restart();
    void post(simulation::Command command);

    /// The latest frame of the present generation; null before the first.
    std::shared_ptr<const simulation::Frame> frame() const { return m_frame; }
    std::uint64_t generation() const { return m_generation; }
    simulation::State state() const { return m_state; }
    simulation::StopReason reason() const { return m_reason; }

signals:
    void frameArrived();
    void stateChanged();

private:
    void drain();
    void takeState(simulation::State state, simulation::StopReason reason);

    std::shared_ptr<Mailbox> m_mailbox;
    std::shared_ptr<const simulation::Frame> m_frame;
    std::uint64_t m_generation = 0;
    simulation::State m_state = simulation::State::Empty;
    simulation::StopReason m_reason = simulation::StopReason::None;
    QTimer m_next;
    QElapsedTimer m_sinceDrain;
    std::unique_ptr<simulation::Worker> m_worker; ///< last: its thread ends before anything above goes
};

} // namespace knittsim::document
