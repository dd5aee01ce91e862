#include "ui/document/document.h"

#include <algorithm>
#include <vector>

namespace knittsim::document {

namespace command = simulation::command;

Activity Document::activity() const {
    if (!m_file) {
        return isOpening() ? Activity::Opening : Activity::Empty;
    }
    switch (m_bridge.state()) {
    case simulation::State::Running:
        return Activity::Settling;
    case simulation::State::Paused:
        return Activity::Paused;
    case simulation::State::AtRest:
        return Activity::AtRest;
    case simulation::State::Failed:
        return Activity::Failed;
    default:
        return Activity::Machine;
    }
}

void Document::start() {
    m_yarnRun.clear(); // what is at rest at once never shows that it moved
    m_bridge.post(command::Start{});
}
void Document::pause() {
    m_yarnFollows = false;
    m_bridge.post(command::Pause{});
}
void Document::stepSimulation() {
    m_yarnRun.clear();
    m_bridge.post(command::Step{});
}
void Document::stop() {
    m_yarnFollows = false;
    m_bridge.post(command::Stop{});
}

void Document::settleYarn() {
    m_yarnFollows = false;
    if (m_yarnRun.running()) {
        m_yarnRun.pause();
    } else if (m_yarnRun.shape() && !m_yarnRun.shape()->finished) {
        m_yarnRun.resume();
    } else {
        startYarn();
    }
}

void Document::startYarn() {
    if (!m_whole || m_ladders.running()) {
        return;
    }
    setStep(operationCount());
    stop(); // what happens to the yarn does not wake the net of bonding points
    m_yarnRun.start(m_whole, machine::yarnsOf(m_carriers));
    for (const fabric::PointIndex point : m_pins) {
        m_yarnRun.setPinned(point, true);
    }
}

void Document::restart() {
    if (m_ladders.running()) {
        m_restartAfterLadder = true;
        m_ladders.finish();
    } else if (m_yarnRun.exists()) {
        startYarn();
    } else if (m_file) {
        m_bridge.restart();
        emit generationChanged();
        start();
    }
}

void Document::setIntegrator(const QString& id) {
    if (id != m_integrator) {
        m_integrator = id;
        m_bridge.post(command::SetIntegrator{id.toStdString()});
        emit integratorChanged();
    }
}

bool Document::showsYarn() const {
    return m_yarnRun.shape() && m_yarnRun.shape()->fabric == shownFabric();
}

fabric::EntryIndex Document::wholeEntryOf(fabric::PointIndex point) const {
    const auto fabric = shownFabric();
    const bool foreign = showsPrefix() && m_prefix->whole != m_whole;
    if (!fabric || foreign || point < 0 || static_cast<std::size_t>(point) >= fabric->points.size()) {
        return -1;
    }
    const fabric::EntryIndex entry = fabric->points[static_cast<std::size_t>(point)].entry;
    const bool mapped = showsPrefix() && static_cast<std::size_t>(entry) < m_prefix->wholeEntry.size();
    return mapped ? m_prefix->wholeEntry[static_cast<std::size_t>(entry)] : entry;
}

void Document::drag(fabric::PointIndex point, Vec3 place) {
    if (showsYarn()) {
        m_yarnRun.drag(point, place);
    } else if (const fabric::EntryIndex entry = wholeEntryOf(point); entry >= 0) {
        m_bridge.post(command::Drag{entry, place.x(), place.y(), place.z()});
    }
}

void Document::releaseDrag() {
    m_bridge.post(command::Release{});
    m_yarnRun.release();
}

/// In both models, so that a pin stays when the model is changed.
void Document::pin(fabric::PointIndex point, bool pinned) {
    const fabric::EntryIndex entry = wholeEntryOf(point);
    if (entry < 0) {
        return;
    }
    std::erase(m_pins, point);
    if (pinned) {
        m_pins.push_back(point);
    }
    m_bridge.post(command::Pin{entry, pinned});
    if (m_yarnRun.exists()) {
        m_yarnRun.setPinned(point, pinned);
    }
}

void Document::togglePin() {
    if (m_point >= 0 && !showsPrefix()) {
        pin(m_point, std::ranges::find(m_pins, m_point) == m_pins.end());
        emit pinsChanged();
    }
}

void Document::removePins() {
    for (const fabric::PointIndex point : std::vector(m_pins)) {
        pin(point, false);
    }
    emit pinsChanged();
}

/// Points of another fabric have other numbers. To a simulation that has another one already this says
/// nothing.
void Document::forgetPins() {
    if (m_pins.empty()) {
        return;
    }
    for (const fabric::PointIndex point : m_pins) {
        if (m_whole && static_cast<std::size_t>(point) < m_whole->points.size()) {
            m_bridge.post(command::Pin{m_whole->points[static_cast<std::size_t>(point)].entry, false});
        }
    }
    m_pins.clear();
    emit pinsChanged();
}

} // namespace knittsim::document
