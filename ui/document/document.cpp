#include "ui/document/document.h"

#include "core/base/resources.h"
#include "ui/document/lift_command.h"
#include "ui/document/session.h"
#include "ui/document/yarn_command.h"

#include <QFileInfo>
#include <QThreadPool>

#include <algorithm>

namespace knittsim::document {

namespace {

namespace command = simulation::command;

std::shared_ptr<const yarn::YarnLibrary> readLibrary() {
    std::vector<yarn::Yarn> yarns;
    for (const std::filesystem::path& folder :
         {std::filesystem::path(Document::ownYarnFolder().toStdString()), resourceFolder() / "yarns"}) {
        const auto library = yarn::YarnLibrary::read(folder);
        for (const yarn::Yarn& yarn : library ? library.value().yarns() : std::vector<yarn::Yarn>()) {
            if (std::ranges::find(yarns, yarn.id, &yarn::Yarn::id) == yarns.end()) {
                yarns.push_back(yarn);
            }
        }
    }
    if (yarns.empty()) {
        yarns.push_back(yarn::defaultYarn());
    }
    return std::make_shared<yarn::YarnLibrary>(std::move(yarns));
}

/// The neighbour of `value` among rising stops; the ends of the program count as stops.
OperationIndex nextStop(const std::vector<OperationIndex>& stops, OperationIndex value, int direction,
                        OperationIndex end) {
    if (direction > 0) {
        const auto found = std::upper_bound(stops.begin(), stops.end(), value);
        return found == stops.end() ? end : *found;
    }
    const auto found = std::lower_bound(stops.begin(), stops.end(), value);
    return found == stops.begin() ? 0 : *(found - 1);
}

} // namespace

Document::Document(QObject* parent)
    : QObject(parent), m_library(readLibrary()), m_opener(m_library), m_rebuilder(m_library) {
    if (const auto known = simulation::integrators(); !known.empty()) {
        m_integrator = QString::fromUtf8(known.front().id);
    }
    connect(&m_opener, &Opener::stageChanged, this, &Document::openingStage);
    connect(&m_opener, &Opener::finished, this, &Document::take);
    connect(&m_rebuilder, &Opener::finished, this, &Document::takeRebuilt);
    // Points of another fabric have other numbers.
    connect(this, &Document::fabricShown, this,
            [this] { setPoint(m_point < 0 ? -1 : firstPointOf(m_selection.loop)); });
    connect(&m_bridge, &SimulationBridge::frameArrived, this, &Document::updateShownFrame);
    connect(&m_bridge, &SimulationBridge::stateChanged, this, &Document::activityChanged);
    connect(&m_yarnRun, &YarnRun::changed, this, &Document::yarnRunChanged);
    connect(this, &Document::fabricShown, &m_yarnRun, &YarnRun::clear);
    connect(this, &Document::fabricShown, this, &Document::forgetPins);
    connect(this, &Document::activityChanged, &m_yarnRun, [this] {
        if (activity() == Activity::Settling) {
            m_yarnRun.clear();
        }
    });
    connect(this, &Document::activityChanged, this, &Document::followWithYarn);
    connect(&m_ladders, &LadderRunner::stepped, this, &Document::takeLadderStep);
    connect(&m_prefixes, &PrefixBuilder::built, this,
            [this](const std::shared_ptr<const PrefixFabric>& prefix) {
                // A large one takes a while to free; the window need not wait for it.
                QThreadPool::globalInstance()->start([old = std::exchange(m_prefix, prefix)] {});
                m_prefixFrame.reset();
                emit fabricShown();
                updateShownFrame();
            });
}

Document::~Document() {
    m_undo.blockSignals(true); // it tells that it is clean when it goes
}

QString Document::ownYarnFolder() {
    return QFileInfo(Session::filePath()).absolutePath() + QStringLiteral("/yarns");
}

void Document::reloadLibrary() {
    m_library = readLibrary();
    m_opener.setLibrary(m_library);
    m_rebuilder.setLibrary(m_library);
    emit libraryChanged();
}

void Document::open(const QString& path) {
    begin({path, QFileInfo(path).fileName(), {}});
}

void Document::openText(const QString& title, const QString& knitout) {
    begin({{}, title, knitout});
}

void Document::setMachine(const QString& id) {
    m_machine = id;
    emit machineChanged();
    if (m_project) {
        rebuild();
    } else if (m_file) {
        begin(m_file->request);
    }
}

void Document::begin(OpenRequest request) {
    request.machine = m_machine;
    m_openingTitle = request.title;
    m_opensModified = false;
    m_opener.open(request);
    emit openingStarted();
    emit activityChanged();
}

void Document::cancelOpening() {
    if (m_opener.busy()) {
        m_opener.cancel();
        emit openingEnded();
        emit activityChanged();
    }
}

void Document::take(const std::shared_ptr<const OpenedFile>& file) {
    emit openingEnded();
    if (file->readable() && file->request.asChart) {
        m_undo.push(new LiftCommand(*this, file));
        emit lifted();
    } else if (file->readable()) {
        show(file);
    } else {
        m_failed = file;
        applyRulesOff();
        emit openFailed();
    }
    emit problemsChanged();
    emit activityChanged();
}

void Document::show(const std::shared_ptr<const OpenedFile>& file) {
    const bool otherMachine = m_file && !file->project && m_file->request.path == file->request.path &&
                              m_file->request.text == file->request.text &&
                              m_file->timeline->profile().id != file->timeline->profile().id &&
                              m_carriers.size() == file->carriers.size();
    const std::vector<CarrierYarn> kept = otherMachine ? m_carriers : std::vector<CarrierYarn>();
    m_rebuilder.cancel();
    exchangeFile(file);
    m_project = m_knitted = file->project;
    m_title = file->request.title;
    m_path = file->request.path;
    m_carriers = otherMachine ? kept : file->carriers;
    m_step = operationCount();
    m_undo.clear();
    if (m_opensModified) {
        m_undo.resetClean();
    }
    tellFile(true);
}

void Document::exchangeFile(const std::shared_ptr<const OpenedFile>& file) {
    // A large file takes a while to free; the window need not wait for it.
    QThreadPool::globalInstance()->start(
        [old = std::move(m_file), prefix = std::move(m_prefix), whole = std::move(m_whole)] {});
    m_file = file;
    m_failed.reset();
    applyRulesOff();
    m_prefixes.cancel();
    m_prefix.reset();
    m_prefixFrame.reset();
    m_selection = {};
    m_point = -1;
    m_ladders.cancel();
    m_restartAfterLadder = false;
    m_whole = file->fabric;
    countLoops();
}

void Document::tellFile(bool another) {
    m_bridge.load(m_whole, machine::yarnsOf(m_carriers));
    if (another && m_file->shape.size() == 3 * static_cast<std::size_t>(m_whole->entryCount)) {
        m_bridge.replace(m_whole, m_file->shape); // as it lay when it was saved
    }
    emit generationChanged();
    emit fileChanged();
    if (another) {
        emit chartChanged();
        emit chartFollowed();
        emit opened();
    }
    emit yarnsChanged();
    emit stepChanged();
    emit selectionChanged();
    emit pointChanged();
    emit fabricShown();
    emit ladderChanged();
}

void Document::applyRulesOff() {
    const auto file = m_failed ? m_failed : m_file;
    m_checked = file ? machine::applyWaivers(file->diagnostics, m_rulesOff) : machine::CheckResult{};
    if (file) {
        m_checked.waived.insert(m_checked.waived.end(), file->waived.begin(), file->waived.end());
    }
    m_marks =
        m_file && !m_failed ? document::problemMarks(*m_file->timeline, m_checked.findings) : ProblemMarks{};
}

void Document::setRulesOff(std::vector<machine::Waiver> rules) {
    m_rulesOff = std::move(rules);
    applyRulesOff();
    emit problemsChanged();
}

void Document::turnRuleOff(const std::string& rule, const std::string& reason) {
    std::vector<machine::Waiver> rules = m_rulesOff;
    std::erase_if(rules, [&](const machine::Waiver& waiver) { return waiver.rule == rule; });
    rules.push_back({rule, reason});
    setRulesOff(std::move(rules));
}

void Document::turnRuleOn(const std::string& rule) {
    std::vector<machine::Waiver> rules = m_rulesOff;
    std::erase_if(rules, [&](const machine::Waiver& waiver) { return waiver.rule == rule; });
    setRulesOff(std::move(rules));
}

void Document::setStep(OperationIndex count) {
    const OperationIndex end = operationCount();
    const OperationIndex step = std::clamp(count, 0, end);
    if (!m_file || step == m_step) {
        return;
    }
    m_step = step;
    if (step == end) {
        m_prefixes.cancel();
        m_prefix.reset();
        m_prefixFrame.reset();
        emit fabricShown();
        updateShownFrame();
    } else {
        m_ladders.finish(); // it runs out of sight
        m_prefixes.request(m_file->timeline, m_whole, step);
    }
    emit stepChanged();
    selectOperation(step < end ? step - 1 : -1);
    selectMoved();
}

/// After a transfer the loop that moved is selected.
void Document::selectMoved() {
    if (m_selection.operation < 0) {
        return;
    }
    const auto& operations = m_file->timeline->program().operations;
    const machine::Operation& op = operations[static_cast<std::size_t>(m_selection.operation)];
    if (op.kind == machine::OperationKind::Xfer) {
        const machine::MachineState state = machineState();
        if (const auto loops = state.loopsOn(op.target); !loops.empty()) {
            Selection moved = m_selection;
            moved.loop = loops.back();
            select(moved);
        }
    }
}

void Document::movePass(int direction) {
    if (m_file) {
        setStep(nextStop(m_file->passEnds, m_step, direction, operationCount()));
    }
}

void Document::moveCourse(int direction) {
    if (m_file) {
        setStep(nextStop(m_file->courseEnds, m_step, direction, operationCount()));
    }
}

machine::MachineState Document::machineState() const {
    return m_file ? m_file->timeline->stateAfter(m_step) : machine::MachineState{};
}

std::shared_ptr<const fabric::Fabric> Document::shownFabric() const {
    if (showsPrefix()) {
        return m_prefix->fabric;
    }
    return m_whole;
}

std::shared_ptr<const simulation::Frame> Document::shownFrame() const {
    return showsPrefix() ? m_prefixFrame : m_bridge.frame();
}

void Document::updateShownFrame() {
    const auto whole = m_bridge.frame();
    const bool foreign = showsPrefix() && m_prefix->whole != m_whole; // its successor is under way
    if (!whole || foreign) {
        return;
    }
    m_hooks.clear();
    if (showsPrefix()) {
        auto frame = std::make_shared<simulation::Frame>();
        frame->generation = whole->generation;
        frame->positions = prefixPositions(*m_prefix, whole->positions);
        frame->state = whole->state;
        const auto& operations = m_file->timeline->program().operations;
        const auto done = static_cast<std::size_t>(m_prefix->count);
        m_hooks = fabric::hangOnNeedles(*m_prefix->fabric, m_prefix->held,
                                        done > 0 ? &operations[done - 1] : nullptr, frame->positions);
        m_prefixFrame = frame;
    }
    emit frameShown();
}

void Document::select(const Selection& selection) {
    if (selection != m_selection) {
        m_selection = selection;
        emit selectionChanged();
    }
}

void Document::selectLoop(LoopIndex loop) {
    select(m_file ? selectionOfLoop(m_file->timeline->program(), m_file->timeline->loops(), loop)
                  : Selection{});
    setPoint(firstPointOf(m_selection.loop));
}

void Document::selectPoint(fabric::PointIndex point) {
    const auto fabric = shownFabric();
    if (!fabric || point < 0 || static_cast<std::size_t>(point) >= fabric->points.size()) {
        clearSelection();
        return;
    }
    selectLoop(fabric->points[static_cast<std::size_t>(point)].loop);
    setPoint(point);
}

void Document::setPoint(fabric::PointIndex point) {
    if (point >= 0 || m_point >= 0) {
        m_point = point;
        emit pointChanged();
    }
}

/// -1 where the fabric shown has no such loop, or no longer.
fabric::PointIndex Document::firstPointOf(LoopIndex loop) const {
    const auto fabric = shownFabric();
    const bool there = fabric && loop >= 0 && static_cast<std::size_t>(loop) < fabric->loops.size();
    return there ? fabric->loops[static_cast<std::size_t>(loop)].headLeft : -1;
}

std::optional<fabric::PointHistory> Document::pointHistory() const {
    if (m_point < 0) {
        return std::nullopt;
    }
    const OperationIndex shown = showsPrefix() ? m_prefix->count : operationCount();
    return fabric::pointHistory(*shownFabric(), *m_file->timeline, m_point, shown);
}

void Document::selectOperation(OperationIndex operation) {
    setPoint(-1);
    select(m_file ? selectionOfOperation(m_file->timeline->program(), m_file->timeline->loops(), operation)
                  : Selection{});
}

void Document::selectLine(int line) {
    setPoint(-1);
    select(m_file ? selectionOfLine(m_file->timeline->program(), m_file->timeline->loops(), line)
                  : Selection{});
}

void Document::clearSelection() {
    setPoint(-1);
    select({});
}

void Document::assignYarn(int carrier, const yarn::Yarn& yarn) {
    if (carrier >= 0 && static_cast<std::size_t>(carrier) < m_carriers.size() && !isOpening() &&
        m_carriers[static_cast<std::size_t>(carrier)].yarn != yarn) {
        m_undo.push(new YarnCommand(*this, carrier, yarn));
    }
}

void Document::setCarrierColour(int carrier, yarn::Colour colour) {
    if (carrier >= 0 && static_cast<std::size_t>(carrier) < m_carriers.size()) {
        yarn::Yarn changed = m_carriers[static_cast<std::size_t>(carrier)].yarn;
        changed.colour = colour;
        assignYarn(carrier, changed);
    }
}

void Document::applyYarn(int carrier, const yarn::Yarn& yarn) {
    if (static_cast<std::size_t>(carrier) >= m_carriers.size()) {
        return; // of a machine that had more carriers
    }
    yarn::Yarn& present = m_carriers[static_cast<std::size_t>(carrier)].yarn;
    const bool body = !machine::sameBody(present, yarn);
    present = yarn;
    putYarn(m_carriers[static_cast<std::size_t>(carrier)].carrier, yarn);
    if (body) {
        m_bridge.post(command::SetYarn{carrier, yarn});
        if (m_yarnRun.exists()) {
            m_yarnRun.setYarn(static_cast<machine::CarrierIndex>(carrier), yarn);
        } else {
            m_bridge.post(command::Start{});
        }
    }
    emit yarnsChanged();
}

} // namespace knittsim::document
