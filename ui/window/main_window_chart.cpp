// The part of the main window that makes, shows and keeps charts.

#include "core/base/file.h"
#include "core/formats/formats.h"
#include "ui/dialogs/picture_dialog.h"
#include "ui/document/message_text.h"
#include "ui/views/chart_editor/chart_canvas.h"
#include "ui/views/chart_editor/chart_editor.h"
#include "ui/views/chart_editor/chart_sheet.h"
#include "ui/views/chart_editor/new_chart_dialog.h"
#include "ui/views/pattern_editor/pattern_grid.h"
#include "ui/window/banner.h"
#include "ui/window/main_window.h"
#include "ui/window/sample_thumbnail.h"

#include <QActionGroup>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMenuBar>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>

#include <algorithm>

namespace knittsim::ui {

/// A file to write, of the kind that was chosen; asks before one that exists. Empty: nowhere.
QString MainWindow::askWhich(const QString& title, const QString& filter) {
    const QString path = QFileDialog::getOpenFileName(this, title, m_session.lastFolder(), filter);
    if (!path.isEmpty()) {
        m_session.setLastFolder(QFileInfo(path).absolutePath());
    }
    return path;
}

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
    QAction* lift = addAction(menu, "actionEditAsChart", tr("E&dit as chart"), Qt::CTRL | Qt::ALT | Qt::Key_C,
                              {}, [this] { m_document.editAsChart(); });
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
    menu->addSeparator();
    buildLookMenus(menu);
}

ChartArea* MainWindow::shownChart() const {
    return m_document.project() ? static_cast<ChartArea*>(m_chart->canvas()) : m_grid;
}

/// Symbols and columns of the chart and of the pattern grid.
void MainWindow::buildLookMenus(QMenu* menu) {
    QMenu* symbols = menu->addMenu(tr("Symb&ols"));
    auto* group = new QActionGroup(this);
    for (int i = 0; i < kSymbolSets; ++i) {
        const auto set = static_cast<SymbolSet>(i);
        QAction* action = addChoice(symbols, group, QStringLiteral("actionSymbols%1").arg(i),
                                    ChartLook::nameOf(set), {}, {}, [this, set] { m_look.setSymbols(set); });
        const auto take = [this, action, set] { action->setChecked(m_look.symbols() == set); };
        connect(&m_look, &ChartLook::changed, action, take);
        take();
    }
    symbols->addSeparator();
    addAction(symbols, QStringLiteral("actionNextSymbols"), tr("&Next symbols"), Qt::Key_A, {},
              [this] { m_look.nextSymbols(); });
    QMenu* columns = menu->addMenu(tr("Colum&ns beside the chart"));
    columns->setObjectName(QStringLiteral("columnMenu"));
    for (int i = 0; i < kSideColumns; ++i) {
        const auto column = static_cast<SideColumn>(i);
        QAction* action = addChoice(columns, nullptr, QStringLiteral("actionColumn%1").arg(i),
                                    ChartLook::nameOf(column), {}, {}, [] {});
        connect(action, &QAction::triggered, this, [this, column](bool on) {
            m_look.setShown(column, on ? ChartLook::Shown::Always : ChartLook::Shown::Never);
        });
        connect(columns, &QMenu::aboutToShow, action,
                [this, action, column] { action->setChecked(shownChart()->isShown(column)); });
    }
    columns->addSeparator();
    addAction(columns, QStringLiteral("actionColumnsByContent"), tr("Those that &say something"), {}, {},
              [this] { m_look.showByContent(); });
}

/// Says what the chart could not take from the machine data.
void MainWindow::takeLifted() {
    QString text = tr("This is a chart now. Undo brings the machine data back.");
    for (const Diagnostic& note : m_document.file()->diagnostics) {
        if (note.id == "KS0511" || note.id == "KS0513") {
            text += u' ' + document::causeText(note) + u' ' + document::cureText(note);
        }
    }
    m_liftedNote = text;
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
    if (!chart && m_banner->text() == m_liftedNote) {
        m_banner->hide(); // undone
    }
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
    const QString path = askWhich(tr("Import a picture"), tr("Pictures (*.png *.jpg *.jpeg);;All files (*)"));
    if (!path.isEmpty()) {
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
    if (m_watch.hasChanged() && path == m_document.path() &&
        QMessageBox::question(
            this, tr("Save the chart"),
            tr("Another program has changed %1 since it was opened. Replace it with what is here?")
                .arg(QFileInfo(path).fileName())) != QMessageBox::Yes) {
        return false;
    }
    const Diagnostics problems = m_document.save(path, chartThumbnail(m_document.project()->chart));
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
    if (!m_document.path().isEmpty() &&
        QFileInfo(path).absoluteFilePath() == QFileInfo(m_document.path()).absoluteFilePath()) {
        m_watch.watch(m_document.path()); // no other program has
    }
    m_session.setLastFolder(QFileInfo(path).absolutePath());
    statusBar()->showMessage(tr("Machine data written to %1").arg(path), 5000);
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

void MainWindow::offerRecovery() {
    for (const document::Recovery::Leftover& leftover : document::Recovery::leftovers()) {
        auto read = pattern::readProjectFile(std::filesystem::path(leftover.path.toStdString()));
        if (!read) {
            continue;
        }
        const auto project = std::make_shared<const pattern::Project>(std::move(read).value());
        m_banner->ask(
            tr("Unsaved work on %1 of %2 was found.")
                .arg(leftover.title, QLocale().toString(leftover.time, QLocale::ShortFormat)),
            tr("Restore"), [this, leftover, project] { restore(leftover, project); }, tr("Discard"),
            [this, leftover] {
                document::Recovery::discard(leftover);
                offerRecovery(); // the next one
            });
        return;
    }
}

void MainWindow::restore(const document::Recovery::Leftover& leftover,
                         const std::shared_ptr<const pattern::Project>& project) {
    whenLeft([this, leftover, project] {
        m_document.openProject(leftover.title, project, true);
        connect(
            &m_document, &document::Document::opened, this,
            [this, leftover, project] {
                if (m_document.project() == project) { // not something else that was faster
                    m_document.keepCopy();
                    document::Recovery::discard(leftover);
                }
            },
            Qt::SingleShotConnection);
    });
}

void MainWindow::takeForeignChange() {
    const QString name = QFileInfo(m_watch.path()).fileName();
    m_banner->ask(
        m_document.isModified()
            ? tr("Another program has changed %1. Your own changes are not saved yet.").arg(name)
            : tr("Another program has changed %1.").arg(name),
        tr("Reload"), [this] { reload(); }, tr("Keep what is here"), [] {});
}

/// Saving would overwrite the other program's work, so it is not among the answers.
void MainWindow::reload() {
    const QString path = m_watch.path();
    if (m_document.isModified()) {
        QMessageBox question(QMessageBox::Question, tr("Reload the file"),
                             tr("Reloading %1 drops the changes made here.").arg(QFileInfo(path).fileName()),
                             QMessageBox::Cancel, this);
        question.setObjectName(QStringLiteral("reloadQuestion"));
        QPushButton* copy = question.addButton(tr("Save them elsewhere\u2026"), QMessageBox::AcceptRole);
        QPushButton* drop = question.addButton(tr("Drop them"), QMessageBox::DestructiveRole);
        question.exec();
        const bool kept = question.clickedButton() == copy && saveChartAs();
        if (!kept && question.clickedButton() != drop) {
            return;
        }
    }
    m_document.open(path);
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
