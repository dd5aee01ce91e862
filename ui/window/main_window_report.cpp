#include "core/base/sha256.h"
#include "core/export/report.h"
#include "core/machine/profile_library.h"
#include "core/pattern/project.h"
#include "ui/document/message_text.h"
#include "ui/window/banner.h"
#include "ui/window/machine_choice.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QPointer>
#include <QStatusBar>
#include <QThreadPool>

namespace knittsim::ui {

namespace {

const QString kMachine = QStringLiteral("machine/chosen");
const QString kRulesOff = QStringLiteral("checks/off"); // lines RULE=REASON

QString firstOf(const Diagnostics& problems) {
    const Diagnostic& first = problems.front();
    const QString place = document::placeText(first.place);
    return (place.isEmpty() ? QString() : place + QStringLiteral(": ")) + document::causeText(first) + u' ' +
           document::cureText(first);
}

/// Everything but the hash, which needs the file's bytes.
exports::Report reportOf(const document::Document& document) {
    exports::Report report;
    report.checks = {document.problems(), document.waived()};
    report.version = QCoreApplication::applicationVersion().toStdString();
    return report;
}

void finish(exports::Report& report, const document::OpenedFile& file,
            const std::vector<machine::CarrierYarn>& carriers) {
    const document::OpenRequest& request = file.request;
    report.file = (request.path.isEmpty() ? request.title : request.path).toStdString();
    // Of a chart what is saved, or would be.
    const Result<std::string> bytes = file.project ? pattern::writeProject(*file.project)
                                      : request.path.isEmpty()
                                          ? Result<std::string>(request.text.toStdString())
                                          : readFile(request.path.toStdString());
    report.sha256 = bytes ? sha256(bytes.value()) : "";
    if (file.readable()) {
        report.knitting = exports::describe(*file.timeline, *file.fabric, carriers);
    }
}

} // namespace

void MainWindow::exportReport(const QString& path) {
    const auto file = m_document.failedFile() ? m_document.failedFile() : m_document.file();
    if (!file) {
        return;
    }
    QThreadPool::globalInstance()->start([report = reportOf(m_document), file,
                                          carriers = m_document.carriers(), path,
                                          window = QPointer<MainWindow>(this)]() mutable {
        finish(report, *file, carriers);
        const auto written = exports::writeReport(report, path.toStdString());
        QMetaObject::invokeMethod(qApp, [path, window, problems = written.diagnostics()] {
            if (window && !problems.empty()) {
                window->m_banner->showMessage(Banner::Kind::Error,
                                              tr("The report cannot be written to %1.").arg(path) + u' ' +
                                                  firstOf(problems));
            } else if (window) {
                window->statusBar()->showMessage(tr("Report written to %1").arg(path), 5000);
            }
        });
    });
}

void MainWindow::chooseReportFile() {
    const auto file = m_document.failedFile() ? m_document.failedFile() : m_document.file();
    if (!file) {
        return;
    }
    const QString start = m_session.lastFolder() + u'/' + QFileInfo(file->request.title).completeBaseName() +
                          QStringLiteral(".html");
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Export the report"), start, tr("Reports (*.html *.json)"));
    if (!path.isEmpty()) {
        m_session.setLastFolder(QFileInfo(path).absolutePath());
        exportReport(path);
    }
}

void MainWindow::chooseMachineFile() {
    const QString path = askWhich(tr("Add a machine"), tr("Machine profiles (*.json);;All files (*)"));
    if (!path.isEmpty()) {
        addMachine(path);
    }
}

void MainWindow::addMachine(const QString& path) {
    const auto profile = machine::addProfile(path.toStdString(), machine::userProfileFolder());
    if (!profile) {
        const Diagnostics& problems = profile.diagnostics();
        const auto more = static_cast<int>(problems.size()) - 1;
        m_banner->showMessage(
            Banner::Kind::Error,
            tr("%1 is no machine profile that can be used.").arg(QFileInfo(path).fileName()) + u' ' +
                firstOf(problems) + (more > 0 ? u' ' + tr("And %1 more.").arg(more) : QString()));
        return;
    }
    m_machine->reload();
    m_document.setMachine(QString::fromStdString(profile.value().id));
    statusBar()->showMessage(tr("Machine %1 added").arg(QString::fromStdString(profile.value().name)), 5000);
}

void MainWindow::restoreChecks() {
    if (m_document.file()) {
        return; // it came with its own
    }
    std::vector<machine::Waiver> rules;
    for (const QByteArray& line : m_session.value(kRulesOff).split('\n')) {
        if (auto waiver = machine::parseWaiver(line.toStdString())) {
            rules.push_back(std::move(waiver).value());
        }
    }
    const QString chosen = QString::fromUtf8(m_session.value(kMachine));
    m_document.setRulesOff(std::move(rules));
    m_document.setMachine(m_machine->findData(chosen) < 0 ? QString() : chosen);
}

void MainWindow::saveChecks() {
    QByteArrayList lines;
    for (const machine::Waiver& waiver : m_document.rulesOff()) {
        lines << QByteArray::fromStdString(waiver.rule + '=' + waiver.reason);
    }
    m_session.setValue(kRulesOff, lines.join('\n'));
    m_session.setValue(kMachine, m_document.chosenMachine().toUtf8());
}

} // namespace knittsim::ui
