// The part of the main window that makes, shows and keeps charts.

#include "core/base/file.h"
#include "core/formats/formats.h"
#include "ui/dialogs/picture_dialog.h"
#include "ui/document/message_text.h"
#include "ui/views/chart_editor/chart_canvas.h"
#include "ui/views/chart_editor/chart_editor.h"
#include "ui/views/chart_editor/new_chart_dialog.h"
#include "ui/views/pattern_editor/pattern_grid.h"
#include "ui/window/banner.h"
#include "ui/window/main_window.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMenuBar>
#include <QMessageBox>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>

#include <algorithm>

namespace knittsim::ui {

/// A file to write, of the kind that was chosen; asks before one that exists. Empty: nowhere.
QString MainWindow::askWhere(const QString& title, const QString& start, const QStringList& kinds) {
    QFileDialog dialog(this, title, start, kinds.join(QStringLiteral(";;")));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    // "Name (*.a *.b)": the first one is appended to a name without extension.
    const auto suffixOf = [](const QString& kind) {
        return kind.section(QStringLiteral("(*."), 1).section(u' ', 0, 0).remove(u')');
    };
    dialog.setDefaultSuffix(suffixOf(kinds.front()));
    connect(&dialog, &QFileDialog::filterSelected, &dialog,
            [&](const QString& kind) { dialog.setDefaultSuffix(suffixOf(kind)); });
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) {
        return {};
    }
    const QString path = dialog.selectedFiles().front();
    const bool known = std::ranges::any_of(kinds, [&](const QString& kind) {
        return kind.contains(QStringLiteral("*.") + QFileInfo(path).suffix());
    });
    const QString whole = known ? path : path + u'.' + dialog.defaultSuffix();
    const bool asked =
        whole == path || !QFileInfo::exists(whole) ||
        QMessageBox::question(this, title, tr("%1 exists. Replace it?").arg(whole)) == QMessageBox::Yes;
    return asked ? whole : QString();
}

void MainWindow::buildChartMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&Pattern"));
    menu->setObjectName(QStringLiteral("patternMenu"));
    QAction* lift = addAction(menu, "actionEditAsChart", tr("E&dit as chart"),
                              Qt::CTRL | Qt::ALT | Qt::Key_C, {}, [this] { m_document.editAsChart(); });
    lift->setToolTip(tr("Machine data becomes a chart that can be changed; what a chart cannot say is kept"));
    lift->setEnabled(false);
    menu->addSeparator();
    for (QAction* action : m_chart->toolActions()) {
        menu->addAction(action);
    }
    menu->addSeparator();
    for (QAction* action : m_chart->editActions()) {
        menu->addAction(action);
    }
}

/// Says what the chart could not take from the machine data.
void MainWindow::takeLifted() {
    QString text = tr("This is a chart now. Undo brings the machine data back.");
    for (const Diagnostic& note : m_document.file()->diagnostics) {
        if (note.id == "KS0511" || note.id == "KS0513") {
            text += u' ' + document::causeText(note) + u' ' + document::cureText(note);
        }
    }
    m_banner->showMessage(Banner::Kind::Note, text);
}

/// Charts are drawn, machine data is looked at.
void MainWindow::takeChart() {
    const bool chart = m_document.project() != nullptr;
    m_patterns->setCurrentWidget(chart ? static_cast<QWidget*>(m_chart) : m_grid);
    for (QAction* action : m_chart->toolActions() + m_chart->editActions()) {
        action->setEnabled(chart);
    }
    findChild<QAction*>(QStringLiteral("actionEditAsChart"))
        ->setEnabled(!chart && m_document.file() != nullptr);
    takeTitle();
}

void MainWindow::takeTitle() {
    const auto file = m_document.file();
    if (!file) {
        return;
    }
    const QString title = m_document.title();
    setWindowFilePath(m_document.path());
    setWindowTitle(tr("%1[*] \u2013 KnittSim").arg(title));
    setWindowModified(m_document.isModified());
}

void MainWindow::newChart() {
    auto* dialog = new NewChartDialog(m_document.chosenMachine(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        const auto project = std::make_shared<const pattern::Project>(dialog->project());
        whenLeft([this, project] {
            m_chart->canvas()->setTool(ChartTool::Pencil);
            m_document.openProject(tr("New chart"), project);
        });
    });
    dialog->open();
}

void MainWindow::choosePicture() {
    const QString path = QFileDialog::getOpenFileName(this, tr("Import a picture"), m_session.lastFolder(),
                                                      tr("Pictures (*.png *.jpg *.jpeg);;All files (*)"));
    if (!path.isEmpty()) {
        m_session.setLastFolder(QFileInfo(path).absolutePath());
        importPicture(path);
    }
}

void MainWindow::importPicture(const QString& path) {
    const auto project = m_document.project();
    const auto file = m_document.file();
    auto* dialog = new PictureDialog(
        path, project ? project->chart.yarns : std::vector<pattern::ChartYarn>(),
        project && file ? file->timeline->profile().carriers : machine::genericProfile().carriers, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, path, project] {
        auto imported = std::make_shared<pattern::Project>();
        imported->chart = dialog->chart();
        imported->machine = project ? project->machine : m_document.chosenMachine().toStdString();
        const QString title = QFileInfo(path).completeBaseName();
        whenLeft([this, title, imported] { m_document.openProject(title, imported, true); });
    });
    dialog->open();
}

bool MainWindow::saveChart() {
    const QString path = m_document.path();
    return pattern::isProjectFile(path.toStdString()) ? saveChartTo(path) : saveChartAs();
}

bool MainWindow::saveChartAs() {
    if (!m_document.project()) {
        return false;
    }
    const QString start =
        m_session.lastFolder() + u'/' + QFileInfo(m_document.title()).baseName() + QStringLiteral(".knitt");
    const QString path = askWhere(tr("Save the chart"), start, {tr("Charts (*.knitt)")});
    return !path.isEmpty() && saveChartTo(path);
}

bool MainWindow::saveChartTo(const QString& path) {
    const Diagnostics problems = m_document.save(path);
    if (hasErrors(problems)) {
        m_banner->showMessage(Banner::Kind::Error,
                              tr("%1 could not be saved. %2")
                                  .arg(QFileInfo(path).fileName(), document::causeText(problems.front())));
        return false;
    }
    m_session.setLastFolder(QFileInfo(path).absolutePath());
    m_session.addRecentFile(path);
    takeRecentFiles();
    statusBar()->showMessage(tr("Saved %1").arg(path), 5000);
    return true;
}

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
    const auto bytes = formats::writeProgram(file->timeline->program(), target);
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
    m_session.setLastFolder(QFileInfo(path).absolutePath());
    statusBar()->showMessage(tr("Machine data written to %1").arg(path), 5000);
}

void MainWindow::offerRecovery() {
    const auto found = document::Recovery::leftovers();
    const auto newest = std::ranges::find_if(found, [](const document::Recovery::Leftover& leftover) {
        return bool(pattern::readProjectFile(std::filesystem::path(leftover.path.toStdString())));
    });
    if (newest == found.end()) {
        return;
    }
    m_leftover = *newest;
    m_banner->showMessage(
        Banner::Kind::Note,
        tr("Unsaved work on %1 of %2 was found.")
            .arg(m_leftover->title, QLocale().toString(m_leftover->time, QLocale::ShortFormat)),
        tr("Restore"));
}

void MainWindow::restoreLeftover() {
    const document::Recovery::Leftover leftover = *m_leftover;
    auto project = pattern::readProjectFile(std::filesystem::path(leftover.path.toStdString()));
    m_leftover.reset();
    if (!project) {
        m_banner->showMessage(Banner::Kind::Error, document::causeText(project.diagnostics().front()));
        return;
    }
    const auto chart = std::make_shared<const pattern::Project>(std::move(project).value());
    whenLeft([this, leftover, chart] {
        m_document.openProject(leftover.title, chart, true);
        connect(
            &m_document, &document::Document::opened, this,
            [this, leftover, chart] {
                if (m_document.project() == chart) { // not something else that was faster
                    m_document.keepCopy();
                    document::Recovery::discard(leftover);
                }
            },
            Qt::SingleShotConnection);
    });
}

void MainWindow::whenLeft(const std::function<void()>& action) {
    if (!m_document.isModified()) {
        action();
        return;
    }
    QMessageBox question(QMessageBox::Question, tr("Unsaved changes"),
                         tr("%1 has changes that are not saved.").arg(m_document.title()),
                         QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
    question.setObjectName(QStringLiteral("unsaved"));
    question.setDefaultButton(QMessageBox::Save);
    const int answer = question.exec();
    if (answer == QMessageBox::Discard || (answer == QMessageBox::Save && saveChart())) {
        action();
    }
}

} // namespace knittsim::ui
