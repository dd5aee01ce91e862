// The part of the document that takes ladders out.

#include "ui/document/document.h"
#include "ui/document/ladder_command.h"

#include <algorithm>
#include <utility>

namespace knittsim::document {

namespace {

std::size_t loopsGone(const fabric::Fabric& fabric) {
    return static_cast<std::size_t>(
        std::ranges::count_if(fabric.loops, [](const fabric::Loop& loop) { return loop.headLeft < 0; }));
}

} // namespace

void Document::setStitchHolder(bool on) {
    if (on != m_stitchHolder && !m_ladders.running()) {
        m_stitchHolder = on;
        countLoops();
        emit ladderChanged();
    }
}

void Document::countLoops() {
    m_runs = m_file ? fabric::findRuns(*m_whole, {.stitchHolder = m_stitchHolder}) : fabric::Runs{};
    m_loopsGone = m_file ? loopsGone(*m_whole) : 0;
}

std::size_t Document::unstableLoops() const {
    return m_runs.loopCount() - m_ladders.loopsRun();
}

std::size_t Document::removedLoops() const {
    return m_loopsGone + m_ladders.loopsRun();
}

void Document::removeLadders() {
    if (!m_file) {
        return;
    }
    if (m_ladders.running()) {
        m_ladders.finish();
    } else if (m_runs.steps.empty()) {
        emit nothingRuns();
    } else {
        auto ladder = std::make_shared<Ladder>();
        ladder->before = m_whole;
        ladder->runs = m_runs;
        m_undo.push(new LadderCommand(*this, std::move(ladder)));
    }
}

void Document::cancelLadders() {
    if (!m_ladders.running()) {
        return;
    }
    const bool last = dynamic_cast<const LadderCommand*>(m_undo.command(m_undo.index() - 1)) != nullptr;
    if (last) {
        m_undo.undo();
    } else {
        m_ladders.finish(); // something was done since, which is not to be undone with it
    }
}

void Document::takeOut(const std::shared_ptr<Ladder>& ladder) {
    setStep(operationCount());
    ladder->placesBefore = presentPlaces();
    if (ladder->after) {
        showWhole(fabricOf(ladder->after), placesOf(ladder->after->entryBefore));
        countLoops();
        emit ladderChanged();
    } else {
        m_ladders.start(ladder);
        emit ladderChanged();
    }
}

void Document::putBack(const Ladder& ladder) {
    m_ladders.cancel();
    m_restartAfterLadder = false;
    setStep(operationCount());
    showWhole(ladder.before, ladder.placesBefore);
    countLoops();
    emit ladderChanged();
}

void Document::takeLadderStep(const std::shared_ptr<const fabric::ReducedFabric>& reduced,
                              const std::vector<fabric::EntryIndex>& pairs) {
    showWhole(fabricOf(reduced), placesOf(pairs));
    if (!m_ladders.running()) {
        countLoops();
        if (std::exchange(m_restartAfterLadder, false)) {
            restart();
        }
    }
    emit ladderChanged();
}

std::vector<float> Document::presentPlaces() const {
    const auto frame = m_bridge.frame();
    const auto wanted = 3 * static_cast<std::size_t>(m_whole->entryCount);
    return frame && frame->positions.size() == wanted ? frame->positions : std::vector<float>{};
}

std::vector<float> Document::placesOf(const std::vector<fabric::EntryIndex>& entries) const {
    const std::vector<float> places = presentPlaces();
    return places.empty() ? places : fabric::pickPositions(entries, places);
}

void Document::showWhole(std::shared_ptr<const fabric::Fabric> fabric, std::vector<float> places) {
    m_whole = std::move(fabric);
    m_bridge.replace(m_whole, std::move(places));
    if (m_step < operationCount()) {
        m_prefixes.request(m_file->timeline, m_whole, m_step);
    } else {
        emit fabricShown();
        updateShownFrame();
    }
}

} // namespace knittsim::document
