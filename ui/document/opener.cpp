#include "ui/document/opener.h"

#include "core/base/file.h"
#include "core/fabric/fabric_builder.h"
#include "core/formats/formats.h"
#include "core/formats/knitout/reader.h"
#include "core/formats/knitout/writer.h"
#include "core/machine/checks/check.h"
#include "core/machine/profile_library.h"
#include "core/pattern/lift.h"
#include "ui/document/mailbox.h"

#include <QThreadPool>

#include <algorithm>

namespace knittsim::document {

namespace {

/// The text that the source view shows; empty when the file cannot be read or is not text.
std::shared_ptr<const SourceText> readSource(const OpenRequest& request) {
    if (request.path.isEmpty()) {
        return std::make_shared<SourceText>(request.text);
    }
    const Result<std::string> bytes = readFile(std::filesystem::path(request.path.toStdString()));
    if (!bytes || bytes.value().find('\0') != std::string::npos) {
        return std::make_shared<SourceText>();
    }
    return std::make_shared<SourceText>(QString::fromStdString(bytes.value()));
}

Result<machine::Program> readRequest(const OpenRequest& request) {
    return request.path.isEmpty()
               ? formats::knitout::parse(request.text.toStdString(), request.title.toStdString())
               : formats::readProgram(std::filesystem::path(request.path.toStdString()));
}

/// A program without operations, for a chart that cannot be knitted.
machine::Program emptyProgram(const machine::MachineProfile& machine) {
    machine::Program program;
    program.header.machine = machine.id;
    for (const std::string& name : machine.carriers) {
        program.header.carriers.push_back(
            {name, static_cast<int>(program.header.carriers.size()), false, {}});
    }
    return program;
}

/// The program of file.project, as text too.
Result<machine::Program> knitProject(OpenedFile& file, const machine::ProfileLibrary& machines,
                                     bool keepChart) {
    const pattern::CompileOptions options = pattern::optionsOf(*file.project, machines);
    auto compiled = pattern::compileCourses(file.project->chart, options);
    file.diagnostics = compiled.diagnostics();
    if (!compiled && !keepChart) {
        return Result<machine::Program>::failure(file.diagnostics);
    }
    const std::string text =
        formats::knitout::write(compiled ? compiled.value().program : emptyProgram(options.machine));
    file.source = std::make_shared<SourceText>(QString::fromStdString(text));
    file.chartCourseEnds = compiled ? compiled.value().courseEnds : std::vector<OperationIndex>();
    return formats::knitout::parse(text, file.request.title.toStdString());
}

/// The chart of a program, and the program that is knitted from it.
Result<machine::Program> liftProgram(OpenedFile& file, const machine::Program& program,
                                     const machine::ProfileLibrary& machines,
                                     const yarn::YarnLibrary& library) {
    const auto own = machine::chooseProfile(program, machines);
    const auto wanted = machine::chooseProfile(program, machines, file.request.machine.toStdString());
    auto lifted = pattern::lift(program, wanted ? wanted.value() : own.value(),
                                machine::carrierYarns(program, library, yarn::defaultYarn()));
    if (!lifted) {
        file.diagnostics = lifted.diagnostics();
        return Result<machine::Program>::failure(file.diagnostics);
    }
    file.project = std::make_shared<pattern::Project>(std::move(lifted.value().project));
    Result<machine::Program> knitted = knitProject(file, machines, false);
    const Diagnostics& notes = lifted.value().notes;
    file.diagnostics.insert(file.diagnostics.end(), notes.begin(), notes.end());
    return knitted;
}

/// Fills file.source, and file.project where there is a chart.
Result<machine::Program> readProgramOf(OpenedFile& file, const machine::ProfileLibrary& machines,
                                       const yarn::YarnLibrary& library, bool keepChart) {
    const OpenRequest& request = file.request;
    const std::filesystem::path path(request.path.toStdString());
    file.project = request.project;
    if (!file.project && pattern::isProjectFile(path)) {
        auto project = pattern::readProjectFile(path, &file.shape);
        if (!project) {
            file.source = readSource(request);
            file.diagnostics = project.diagnostics();
            return Result<machine::Program>::failure(project.diagnostics());
        }
        file.project = std::make_shared<pattern::Project>(std::move(project).value());
    }
    if (file.project) {
        return knitProject(file, machines, keepChart);
    }
    file.source = readSource(request);
    Result<machine::Program> program = readRequest(request);
    file.diagnostics = program.diagnostics();
    return program && request.asChart ? liftProgram(file, program.value(), machines, library)
                                      : std::move(program);
}

std::vector<OperationIndex> endsOfPasses(const machine::Program& program) {
    std::vector<OperationIndex> ends;
    for (const machine::Pass& pass : machine::findPasses(program)) {
        ends.push_back(pass.first + pass.count);
    }
    return ends;
}

std::vector<OperationIndex> endsOfCourses(const machine::LoopTable& made, const fabric::Fabric& fabric) {
    std::vector<OperationIndex> ends(static_cast<std::size_t>(std::max(fabric.courseCount, 0)), 0);
    for (std::size_t i = 0; i < std::min(made.loops.size(), fabric.loops.size()); ++i) {
        const auto course = static_cast<std::size_t>(std::max(fabric.loops[i].course, 0));
        if (course < ends.size()) {
            ends[course] = std::max(ends[course], made.loops[i].operation + 1);
        }
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    return ends;
}

/// The course in which a finding's operation stitches, or the last one before it.
void nameCourses(const machine::LoopTable& made, const fabric::Fabric& fabric, Diagnostics& findings) {
    for (Diagnostic& finding : findings) {
        const auto after =
            std::ranges::upper_bound(made.loops, finding.place.operation, {}, &machine::Loop::operation);
        const auto loop = static_cast<std::size_t>(after - made.loops.begin());
        if (finding.place.operation >= 0 && loop > 0 && loop <= fabric.loops.size()) {
            finding.place.course = fabric.loops[loop - 1].course;
        }
    }
}

} // namespace

std::shared_ptr<const OpenedFile> openFile(const OpenRequest& request, const yarn::YarnLibrary& library,
                                           const std::function<void(OpeningStage)>& stage, bool keepChart) {
    const auto tell = [&](OpeningStage now) {
        if (stage) {
            stage(now);
        }
    };
    auto file = std::make_shared<OpenedFile>();
    file->request = request;
    tell(OpeningStage::Reading);
    Diagnostics problems;
    const auto machines = machine::ProfileLibrary::read(machine::profileFolders(), problems);
    Result<machine::Program> program = readProgramOf(*file, machines, library, keepChart);
    if (!program) {
        return file;
    }
    tell(OpeningStage::Machine);
    const auto take = [&](const Diagnostics& found) {
        file->diagnostics.insert(file->diagnostics.end(), found.begin(), found.end());
    };
    take(problems);
    auto profile = machine::chooseProfile(program.value(), machines);
    file->machineOfFile = QString::fromStdString(profile->name);
    if (!request.machine.isEmpty()) {
        auto wanted = machine::chooseProfile(program.value(), machines, request.machine.toStdString());
        // A profile that is gone does not keep the file from opening.
        Diagnostics found = wanted.diagnostics();
        for (Diagnostic& finding : found) {
            finding.severity = Severity::Warning;
        }
        take(found);
        profile = wanted ? std::move(wanted) : std::move(profile);
    } else {
        take(profile.diagnostics());
    }
    file->timeline =
        std::make_shared<machine::Timeline>(std::move(program).value(), std::move(profile).value());
    const auto waivers = machine::waiversOf(file->timeline->profile());
    take(waivers.diagnostics());
    machine::CheckResult checked = machine::applyWaivers(
        machine::check(*file->timeline), waivers ? waivers.value() : std::vector<machine::Waiver>());
    take(checked.findings);
    file->waived = std::move(checked.waived);
    tell(OpeningStage::Fabric);
    file->fabric = std::make_shared<fabric::Fabric>(fabric::buildFabric(*file->timeline));
    nameCourses(file->timeline->loops(), *file->fabric, file->diagnostics);
    file->grid = std::make_shared<StitchGrid>(file->timeline->loops(), *file->fabric);
    file->carriers = machine::carrierYarns(file->timeline->program(), library, yarn::defaultYarn());
    file->passEnds = endsOfPasses(file->timeline->program());
    file->courseEnds = endsOfCourses(file->timeline->loops(), *file->fabric);
    return file;
}

Opener::Opener(std::shared_ptr<const yarn::YarnLibrary> library, QObject* parent)
    : QObject(parent), m_library(std::move(library)), m_mailbox(std::make_shared<Mailbox>(this)) {}

Opener::~Opener() {
    m_mailbox->close();
}

void Opener::open(const OpenRequest& request, bool keepChart) {
    const std::uint64_t generation = ++m_generation;
    m_busy = true;
    QThreadPool::globalInstance()->start(
        [this, generation, request, keepChart, library = m_library, mailbox = m_mailbox] {
            const auto file = openFile(
                request, *library,
                [&](OpeningStage stage) {
                    mailbox->post([this, generation, stage] {
                        if (generation == m_generation && m_busy) {
                            emit stageChanged(stage);
                        }
                    });
                },
                keepChart);
            mailbox->post([this, generation, file] {
                if (generation == m_generation && m_busy) {
                    m_busy = false;
                    emit finished(file);
                }
            });
        });
}

void Opener::cancel() {
    ++m_generation;
    m_busy = false;
}

} // namespace knittsim::document
