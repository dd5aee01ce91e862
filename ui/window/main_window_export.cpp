// The part of the main window that writes the chart for machines and for people.

#include "core/base/file.h"
#include "core/formats/formats.h"
#include "core/machine/checks/check.h"
#include "core/pattern/machine_data.h"
#include "ui/document/message_text.h"
#include "ui/views/chart_editor/chart_sheet.h"
#include "ui/window/banner.h"
#include "ui/window/main_window.h"

#include <QFileInfo>
#include <QProgressDialog>
#include <QStatusBar>

#include <algorithm>

namespace knittsim::ui {

namespace {

/// What is shown, for the machine that takes the format; 250,000 operations take a tenth of a second.
Result<pattern::MachineData> machineData(const document::Document& document, const document::OpenedFile& file,
                                         const std::filesystem::path& path) {
    if (!document.project()) {
        return pattern::MachineData{file.timeline->program(), file.timeline->profile()};
    }
    Diagnostics ignored; // told at the start of the program
    const auto machines = machine::ProfileLibrary::read(machine::profileFolders(), ignored);
    return pattern::machineDataFor(path, *document.project(), machines);
}

/// Errors of the checks on the machine of the data.
Diagnostics errorsOf(const pattern::MachineData& data) {
    Diagnostics findings = machine::check(machine::Timeline(data.program, data.machine));
    std::erase_if(findings, [](const Diagnostic& finding) { return finding.severity != Severity::Error; });
    return findings;
}

} // namespace

void MainWindow::exportMachineData() {
    const auto file = m_document.file();
    if (m_document.project() && !m_document.fabricFollowsChart()) {
        m_banner->showMessage(Banner::Kind::Error,
                              m_document.isRebuilding()
                                  ? tr("The program of the chart is not ready yet.")
                                  : tr("The chart cannot be knitted as it is: there is no machine data."));
        return;
    }
    const QString start =
        m_session.lastFolder() + u'/' + QFileInfo(m_document.title()).baseName() + QStringLiteral(".k");
    const QString path =
        askWhere(tr("Export machine data"), start,
                 {tr("Knitout (*.k *.knitout)"), tr("Shima DAT (*.dat)"), tr("Kniterate k-code (*.kc)")});
    if (path.isEmpty()) {
        return;
    }
    const std::filesystem::path target(path.toStdString());
    const auto data = machineData(m_document, *file, target);
    const auto bytes = data ? formats::writeProgram(data.value().program, target)
                            : Result<std::string>::failure(data.diagnostics());
    Diagnostics problems = bytes.diagnostics();
    if (bytes) {
        const auto written = writeFileAtomically(target, bytes.value());
        problems.insert(problems.end(), written.diagnostics().begin(), written.diagnostics().end());
    }
    if (hasErrors(problems)) {
        m_banner->showMessage(
            Banner::Kind::Error,
            tr("The machine data cannot be written. %1").arg(document::causeText(problems.front())));
        return;
    }
    if (!m_document.path().isEmpty() &&
        QFileInfo(path).absoluteFilePath() == QFileInfo(m_document.path()).absoluteFilePath()) {
        m_watch.watch(m_document.path()); // no other program has
    }
    m_session.setLastFolder(QFileInfo(path).absolutePath());
    const QString machine = QString::fromStdString(data.value().machine.name);
    statusBar()->showMessage(tr("Machine data for %1 written to %2").arg(machine, path), 5000);
    if (const Diagnostics errors = errorsOf(data.value()); !errors.empty()) {
        m_banner->showMessage(
            Banner::Kind::Error,
            tr("%1 is written, but %2 will not knit it without problems (%3 errors). %4")
                .arg(QFileInfo(path).fileName(), machine)
                .arg(errors.size())
                .arg(document::causeText(errors.front()) + u' ' + document::cureText(errors.front())));
    }
}

namespace {

/// Yarns of the chart, and how much of each the fabric takes where one follows it.
std::vector<SheetYarn> sheetYarns(const document::Document& document) {
    std::vector<SheetYarn> yarns;
    for (const pattern::ChartYarn& own : document.project()->chart.yarns) {
        SheetYarn& yarn = yarns.emplace_back();
        yarn.carrier = QString::fromStdString(own.carrier);
        yarn.colour = {own.colour.r, own.colour.g, own.colour.b};
        const auto& carriers = document.carriers();
        const auto carrier = std::ranges::find(carriers, own.carrier, &document::CarrierYarn::carrier);
        if (carrier == carriers.end()) {
            continue;
        }
        yarn.name = QString::fromStdString(carrier->yarn.name);
        yarn.colour = {carrier->yarn.colour.r, carrier->yarn.colour.g, carrier->yarn.colour.b};
        if (!document.fabricFollowsChart()) {
            continue;
        }
        for (const fabric::Yarn& fed : document.file()->fabric->yarns) {
            if (fed.carrier == carrier - carriers.begin()) {
                yarn.metres += fed.lengthMm / 1000;
            }
        }
        yarn.grams = yarn.metres * carrier->yarn.tex / 1000; // tex: g per 1000 m
    }
    return yarns;
}

} // namespace

void MainWindow::exportChart() {
    const QString start =
        m_session.lastFolder() + u'/' + QFileInfo(m_document.title()).baseName() + QStringLiteral(".pdf");
    const QString path =
        askWhere(tr("Export the chart"), start, {tr("PDF pages (*.pdf)"), tr("PNG picture (*.png)")});
    if (path.isEmpty()) {
        return;
    }
    const ChartSheet sheet{.title = m_document.title(),
                           .chart = m_document.project()->chart,
                           .firstNeedle = m_document.project()->firstNeedle,
                           .symbols = m_look.symbols(),
                           .yarns = sheetYarns(m_document)};
    QProgressDialog progress(tr("Drawing the chart\u2026"), tr("Cancel"), 0, 0, this);
    progress.setWindowModality(Qt::WindowModal);
    progress.setMinimumDuration(400);
    const auto tell = [&](int done, int pages) {
        progress.setMaximum(pages);
        progress.setValue(done);
        return !progress.wasCanceled();
    };
    const bool picture = path.endsWith(QStringLiteral(".png"), Qt::CaseInsensitive);
    const Diagnostics problems =
        picture ? writeChartPng(sheet, path, tell) : writeChartPdf(sheet, path, tell);
    progress.reset();
    if (hasErrors(problems)) {
        m_banner->showMessage(
            Banner::Kind::Error,
            tr("The chart was not exported. %1").arg(document::causeText(problems.front())));
        return;
    }
    m_session.setLastFolder(QFileInfo(path).absolutePath());
    statusBar()->showMessage(tr("Chart written to %1").arg(path), 5000);
}

} // namespace knittsim::ui
