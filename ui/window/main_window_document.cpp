#include "core/pattern/samples.h"
#include "ui/document/message_text.h"
#include "ui/views/diagnostics/diagnostics_panel.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/views/lesson/lesson_panel.h"
#include "ui/views/simulation_panel/ladder_text.h"
#include "ui/views/source/source_view.h"
#include "ui/window/banner.h"
#include "ui/window/main_window.h"
#include "ui/window/sample_card.h"

#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QTimer>

namespace knittsim::ui {

namespace {

constexpr int kSettleDelayMs = 350;

} // namespace

void MainWindow::connectDocument() {
    using document::Document;
    connect(&m_document, &Document::opened, this, &MainWindow::takeFile);
    connect(&m_document, &Document::chartChanged, this, &MainWindow::takeChart);
    connect(&m_document, &Document::saved, this, [this] {
        takeTitle();
        m_watch.watch(m_document.path());
        m_views.moveTo(m_document.path());
        movePhotograph();
        moveMarks();
    });
    connect(&m_watch, &document::FileWatch::changed, this, &MainWindow::takeForeignChange);
    connect(m_document.undoStack(), &QUndoStack::cleanChanged, this, &MainWindow::takeTitle);
    connect(&m_document, &Document::openFailed, this, &MainWindow::takeFailure);
    connect(&m_document, &Document::lifted, this, &MainWindow::takeLifted);
    connect(&m_document, &Document::problemsChanged, this, &MainWindow::takeProblems);
    connect(&m_document, &Document::fabricShown, this, &MainWindow::takeFabric);
    connect(&m_document, &Document::activityChanged, this, &MainWindow::takeActions);
    connect(&m_document, &Document::ladderChanged, this, [this] {
        if (m_banner->text() == m_nothingRuns) {
            m_banner->hide();
        }
        takeActions();
    });
    connect(&m_document, &Document::nothingRuns, this, [this] {
        m_nothingRuns = nothingRunsText(m_document);
        m_banner->showMessage(Banner::Kind::Note, m_nothingRuns);
    });
    connect(&m_document, &Document::activityChanged, this, &MainWindow::takeDescription);
    connect(&m_document, &Document::problemsChanged, this, &MainWindow::saveChecks);
    connect(&m_document, &Document::machineChanged, this, &MainWindow::saveChecks);
    connect(m_problems, &DiagnosticsPanel::reportWanted, this, &MainWindow::chooseReportFile);
    connect(m_problems, &DiagnosticsPanel::placeWanted, this, &MainWindow::showPlace);
    connect(m_banner, &Banner::actionWanted, this, [this] {
        m_problemDock->show();
        m_problemDock->raise();
        m_problems->walk(+1);
    });
}

void MainWindow::openFile(const QString& path) {
    whenLeft([this, path] {
        m_session.setLastFolder(QFileInfo(path).absolutePath());
        m_document.open(path);
    });
}

void MainWindow::openSample(const QString& id) {
    for (const pattern::Sample& sample : pattern::samples()) {
        if (QString::fromStdString(sample.id) == id) {
            const auto project = std::make_shared<const pattern::Project>(
                pattern::Project{.chart = pattern::sampleChart(sample.id), .machine = {}});
            whenLeft([this, &sample, project] { m_document.openProject(sampleTitle(sample), project); });
        }
    }
}

void MainWindow::takeFile() {
    const document::OpenRequest& request = m_document.file()->request;
    m_watch.watch(m_document.path());
    if (!request.path.isEmpty()) {
        m_session.addRecentFile(request.path);
        takeRecentFiles();
    }
    m_banner->hide();
    takeDocument();
    recallLook();
    takeActions();
    m_lesson->takeProgram();
    startSoon();
}

/// A file that was opened, or that another window has had before.
void MainWindow::takeDocument() {
    takeTitle();
    if (m_watch.path() != m_document.path()) {
        m_watch.watch(m_document.path());
    }
    recallViews();
    recallPhotograph();
    recallMarks();
    m_fabric->setFabric(nullptr, {}); // an empty view fits the next fabric
    showWorkspace();
}

void MainWindow::startSoon() {
    // The eye needs to see the fabric as the machine leaves it, else a small one is at rest before the first
    // picture.
    QTimer::singleShot(kSettleDelayMs, this, [this, file = std::weak_ptr(m_document.file())] {
        const document::YarnRun& yarn = m_document.yarnRun(); // somebody was faster
        if (file.lock() == m_document.file() && m_document.activity() == document::Activity::Machine &&
            !yarn.running() && !yarn.shape()) {
            m_document.start();
        }
    });
}

void MainWindow::takeFailure() {
    const auto failed = m_document.failedFile();
    const Diagnostics& problems = failed->diagnostics;
    QString text = (failed->request.asChart ? tr("%1 cannot become a chart.") : tr("%1 could not be opened."))
                       .arg(failed->request.title);
    if (!problems.empty()) {
        text += u' ' + document::causeText(problems.front());
    }
    if (m_document.file()) {
        text += u' ' + tr("%1 stays open.").arg(m_document.file()->request.title);
    }
    m_banner->showMessage(Banner::Kind::Error, text,
                          problems.empty() || problems.front().place.line < 0 ? QString()
                                                                              : tr("Show the place"));
}

void MainWindow::takeProblems() {
    const Diagnostics& found = m_document.problems();
    const std::size_t count = problemCount(found);
    // Notes alone do not push themselves forward, and a dock that was closed stays closed while a chart is
    // drawn.
    if ((count > 0) != (m_problemsShown > 0)) {
        m_problemDock->setVisible(count > 0);
    }
    m_problemsShown = count;
    markProblems();
    m_problemDock->setWindowTitle(count > 0 ? tr("Problems (%1)").arg(count) : tr("Problems"));
    takeActions();
}

void MainWindow::showPlace(const Diagnostic& problem) {
    if (problem.place.line > 0) {
        m_sourceDock->show();
        m_sourceDock->raise();
        m_source->showProblemLine(problem.place.line);
    }
    if (!m_document.failedFile() && problem.place.operation >= 0) {
        m_document.selectOperation(problem.place.operation);
    }
}

void MainWindow::showLine(int line) {
    m_sourceDock->show();
    m_sourceDock->raise();
    m_source->showLine(line);
}

QString MainWindow::openFilter() {
    return tr("Charts and machine programs (*.knitt *.k *.knitout *.dat *.kc *.sin);;"
              "WKT of 1998 is not publicly documented: knitout or Sintral text fills its place (*.k *.sin);;"
              "All files (*)");
}

void MainWindow::chooseFile() {
    const QString path = QFileDialog::getOpenFileName(this, tr("Open a chart or a machine program"),
                                                      m_session.lastFolder(), openFilter());
    if (!path.isEmpty()) {
        openFile(path);
    }
}

} // namespace knittsim::ui
