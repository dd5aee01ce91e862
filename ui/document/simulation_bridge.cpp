#include "ui/document/simulation_bridge.h"

#include "ui/document/mailbox.h"

#include <algorithm>
#include <atomic>

namespace knittsim::document {

namespace {

constexpr qint64 kFrameIntervalMs = 16;

} // namespace

SimulationBridge::SimulationBridge(QObject* parent)
    : QObject(parent), m_mailbox(std::make_shared<Mailbox>(this)) {
    m_next.setSingleShot(true);
    connect(&m_next, &QTimer::timeout, this, &SimulationBridge::drain);
    m_sinceDrain.start();
    const auto asked = std::make_shared<std::atomic<bool>>(false);
    m_worker = std::make_unique<simulation::Worker>([this, mailbox = m_mailbox, asked] {
        if (asked->exchange(true)) {
            return;
        }
        mailbox->post([this, asked] {
            asked->store(false);
            if (!m_next.isActive()) {
                m_next.start(
                    static_cast<int>(std::max<qint64>(0, kFrameIntervalMs - m_sinceDrain.elapsed())));
            }
        });
    });
}

SimulationBridge::~SimulationBridge() {
    m_mailbox->close();
}

void SimulationBridge::load(std::shared_ptr<const fabric::Fabric> fabric, std::vector<yarn::Yarn> yarns) {
    ++m_generation;
    m_frame.reset();
    m_worker->post(simulation::command::Load{
        .fabric = std::move(fabric), .yarns = std::move(yarns), .generation = m_generation});
    takeState(simulation::State::Ready, simulation::StopReason::None);
}

void SimulationBridge::replace(std::shared_ptr<const fabric::Fabric> fabric, std::vector<float> places) {
    ++m_generation;
    if (m_frame && !places.empty()) {
        // Until the worker's first frame comes: the same picture, less what has gone.
        auto frame = std::make_shared<simulation::Frame>(*m_frame);
        frame->generation = m_generation;
        frame->positions = places;
        frame->tension.clear();
        m_frame = std::move(frame);
    } else {
        m_frame.reset();
    }
    m_worker->post(simulation::command::Replace{
        .fabric = std::move(fabric), .positions = std::move(places), .generation = m_generation});
}

void SimulationBridge::restart() {
    ++m_generation;
    m_worker->post(simulation::command::Restart{m_generation});
}

void SimulationBridge::post(simulation::Command command) {
    m_worker->post(std::move(command));
}

void SimulationBridge::takeState(simulation::State state, simulation::StopReason reason) {
    if (state != m_state || reason != m_reason) {
        m_state = state;
        m_reason = reason;
        emit stateChanged();
    }
}

void SimulationBridge::drain() {
    m_sinceDrain.restart();
    m_worker->takeEvents(); // every state they tell is in the frames too; taking them keeps the queue short
    const auto frame = m_worker->takeFrame();
    if (!frame || frame->generation != m_generation) {
        return;
    }
    m_frame = frame;
    takeState(frame->state, frame->reason);
    emit frameArrived();
}

} // namespace knittsim::document
