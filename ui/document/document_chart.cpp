// The part of the document that edits and keeps a chart.

#include "core/base/file.h"
#include "ui/document/chart_command.h"
#include "ui/document/colourway_command.h"
#include "ui/document/document.h"

#include <QFileInfo>

#include <algorithm>

namespace knittsim::document {

void Document::openProject(const QString& title, std::shared_ptr<const pattern::Project> project,
                           bool modified) {
    begin({.path = {}, .title = title, .text = {}, .project = std::move(project)});
    m_opensModified = modified;
}

void Document::editAsChart() {
    if (m_file && !m_project && !isOpening()) {
        OpenRequest request = m_file->request;
        request.asChart = true;
        begin(std::move(request));
    }
}

/// Machine data and its chart take each other's place: the fabric is the same, undo goes on.
void Document::exchangeProgram(const std::shared_ptr<const OpenedFile>& file,
                               const std::vector<CarrierYarn>& carriers,
                               const std::shared_ptr<const fabric::Fabric>& whole) {
    m_rebuilder.cancel();
    exchangeFile(file);
    m_whole = whole;
    countLoops();
    m_project = m_knitted = file->project;
    m_carriers = carriers;
    m_step = operationCount();
    tellFile(false);
    emit chartChanged();
    emit chartFollowed();
    emit problemsChanged();
    start();
}

void Document::editChart(const QString& text, const std::function<void(pattern::Chart&)>& edit) {
    if (!m_project || isOpening()) {
        return; // what comes next has been asked for
    }
    pattern::Chart after = m_project->chart;
    edit(after);
    if (after != m_project->chart) {
        m_undo.push(new ChartCommand(*this, text, {m_project->chart, after}));
    }
}

void Document::applyPatch(const pattern::ChartPatch& patch, bool forwards) {
    auto changed = std::make_shared<pattern::Project>(*m_project);
    forwards ? patch.apply(changed->chart) : patch.revert(changed->chart);
    m_project = std::move(changed);
    emit chartChanged();
    rebuild();
}

/// The chart keeps what yarn its carriers have; program and fabric stay as they are.
void Document::putYarn(const std::string& carrier, const yarn::Yarn& yarn) {
    const auto isOwn = [&](const pattern::ChartYarn& own) { return own.carrier == carrier; };
    if (!m_project || std::ranges::none_of(m_project->chart.yarns, isOwn)) {
        return;
    }
    auto changed = std::make_shared<pattern::Project>(*m_project);
    pattern::ChartYarn& own = *std::ranges::find_if(changed->chart.yarns, isOwn);
    own.libraryId = yarn.id;
    own.colour = yarn.colour;
    replaceYarns(std::move(changed));
}

/// The program of a chart with other yarns is the same, but one that is being made has the old ones.
void Document::replaceYarns(std::shared_ptr<const pattern::Project> changed) {
    m_knitted = m_knitted == m_project ? changed : m_knitted;
    m_project = std::move(changed);
    emit chartChanged();
    if (m_rebuilder.busy()) {
        rebuild();
    }
}

void Document::editColourways(const QString& text,
                              const std::function<void(pattern::Colourways&, pattern::Chart&)>& edit) {
    if (!m_project || isOpening()) {
        return;
    }
    pattern::Colourways after = m_project->colourways;
    pattern::Chart chart;
    chart.yarns = m_project->chart.yarns;
    edit(after, chart);
    if (after != m_project->colourways || chart.yarns != m_project->chart.yarns) {
        m_undo.push(new ColourwayCommand(*this, text, std::move(after), std::move(chart.yarns)));
    }
}

void Document::applyColourways(const pattern::Colourways& colourways,
                               const std::vector<pattern::ChartYarn>& yarns) {
    for (const pattern::ChartYarn& own : yarns) {
        const auto carrier = std::ranges::find(m_carriers, own.carrier, &CarrierYarn::carrier);
        if (carrier != m_carriers.end()) {
            const yarn::Yarn* known = m_library->find(own.libraryId);
            yarn::Yarn wanted = known && carrier->yarn.id != known->id ? *known : carrier->yarn;
            wanted.colour = own.colour;
            if (wanted != carrier->yarn) {
                applyYarn(static_cast<int>(carrier - m_carriers.begin()), wanted);
            }
        }
    }
    // Last, so that a yarn that the library does not know stays named as it was.
    auto changed = std::make_shared<pattern::Project>(*m_project);
    changed->colourways = colourways;
    changed->chart.yarns = yarns;
    replaceYarns(std::move(changed));
}

void Document::rebuild() {
    m_rebuilder.open(
        {.path = m_path, .title = m_title, .text = {}, .machine = m_machine, .project = m_project}, false);
    emit chartFollowed();
}

void Document::takeRebuilt(const std::shared_ptr<const OpenedFile>& file) {
    if (file->readable()) {
        update(file);
    } else {
        m_failed = file; // the fabric stays as it was before
        applyRulesOff();
    }
    emit chartFollowed();
    emit problemsChanged();
}

/// The window goes on: undo, yarns that were given to carriers and the camera stay.
void Document::update(const std::shared_ptr<const OpenedFile>& file) {
    const bool atEnd = m_step == operationCount();
    m_yarnFollows = atEnd && (m_yarnFollows || m_yarnRun.exists());
    std::vector<CarrierYarn> carriers = file->carriers;
    for (std::size_t i = 0; i < std::min(carriers.size(), m_carriers.size()); ++i) {
        if (carriers[i] == m_file->carriers[i]) {
            carriers[i] = m_carriers[i];
        }
    }
    exchangeFile(file);
    m_knitted = file->project;
    m_carriers = std::move(carriers);
    m_step = atEnd ? operationCount() : std::min(m_step, operationCount());
    if (!atEnd) {
        m_prefixes.request(m_file->timeline, m_whole, m_step);
    }
    tellFile(false);
    start();
}

/// Who looks at yarn sees yarn again after an edit: first the bonding points, at rest the yarn.
void Document::followWithYarn() {
    if (m_yarnFollows && activity() == Activity::AtRest) {
        m_yarnFollows = false;
        startYarn();
    }
}

bool Document::fabricFollowsChart() const {
    return m_project && !m_rebuilder.busy() && m_knitted == m_project && !m_file->chartCourseEnds.empty();
}

namespace {

/// The last loop that these operations made on needles of `wale`, or -1.
LoopIndex lastLoop(const machine::LoopTable& made, OperationIndex first, OperationIndex end,
                   std::int32_t needle) {
    const auto from = std::ranges::lower_bound(made.loops, first, {}, &machine::Loop::operation);
    const auto to = std::ranges::lower_bound(made.loops, end, {}, &machine::Loop::operation);
    for (auto loop = to; loop != from;) {
        --loop;
        if (loop->needle.index == needle) {
            return static_cast<LoopIndex>(loop - made.loops.begin());
        }
    }
    return -1;
}

} // namespace

LoopIndex Document::loopOfCell(pattern::CellPlace place) const {
    const auto course = static_cast<std::size_t>(std::max(place.course, 0));
    if (!fabricFollowsChart() || course >= m_file->chartCourseEnds.size()) {
        return -1;
    }
    const std::vector<OperationIndex>& ends = m_file->chartCourseEnds;
    return lastLoop(m_file->timeline->loops(), course > 0 ? ends[course - 1] : 0, ends[course],
                    place.wale + m_project->firstNeedle);
}

std::optional<pattern::CellPlace> Document::cellOfLoop(LoopIndex loop) const {
    if (!fabricFollowsChart() || loop < 0 ||
        static_cast<std::size_t>(loop) >= m_file->timeline->loops().loops.size()) {
        return std::nullopt;
    }
    const machine::Loop& made = m_file->timeline->loops().loops[static_cast<std::size_t>(loop)];
    const auto course = std::ranges::upper_bound(m_file->chartCourseEnds, made.operation);
    return pattern::CellPlace{made.needle.index - m_project->firstNeedle,
                              static_cast<int>(course - m_file->chartCourseEnds.begin())};
}

int Document::knittedCourses() const {
    if (!m_file || !m_project) {
        return 0;
    }
    const auto end = std::ranges::upper_bound(m_file->chartCourseEnds, m_step);
    return static_cast<int>(end - m_file->chartCourseEnds.begin());
}

Diagnostics Document::save(const QString& path, const pattern::ProjectLook& look) {
    if (!m_project) {
        return {};
    }
    const auto written = writeFileAtomically(std::filesystem::path(path.toStdString()),
                                             pattern::writeProject(*m_project, look));
    if (written) {
        m_path = path;
        m_title = QFileInfo(path).fileName();
        m_undo.setClean();
        emit saved();
    }
    return written.diagnostics();
}

std::vector<float> Document::shapeAtRest() const {
    const bool whole = fabricFollowsChart() && m_whole == m_file->fabric;
    const bool atRest = m_bridge.state() == simulation::State::AtRest || m_yarnRun.exists();
    return whole && atRest ? presentPlaces() : std::vector<float>{};
}

} // namespace knittsim::document
