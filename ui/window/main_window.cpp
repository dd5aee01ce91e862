#include "ui/window/main_window.h"

#include "core/pattern/samples.h"
#include "ui/document/message_text.h"
#include "ui/views/diagnostics/diagnostics_panel.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/views/history/history_card.h"
#include "ui/views/lesson/lesson_panel.h"
#include "ui/views/pattern_editor/pattern_grid.h"
#include "ui/views/simulation_panel/activity_text.h"
#include "ui/views/simulation_panel/ladder_text.h"
#include "ui/views/source/source_view.h"
#include "ui/views/step_player/step_player.h"
#include "ui/views/style/appearance.h"
#include "ui/views/style/icons.h"
#include "ui/window/banner.h"
#include "ui/window/carrier_looks.h"
#include "ui/window/comparison.h"
#include "ui/window/gallery.h"
#include "ui/window/opening_card.h"
#include "ui/window/photograph_card.h"
#include "ui/window/sample_card.h"
#include "ui/window/status_line.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMimeData>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>

namespace knittsim::ui {

namespace {

constexpr int kSettleDelayMs = 350;

QString firstLocalFile(const QMimeData* data) {
    for (const QUrl& url : data->urls()) {
        if (url.isLocalFile()) {
            return url.toLocalFile();
        }
    }
    return {};
}

/// It goes with the document from window to window, so that nothing is missed in between.
document::FileWatch& watchOf(document::Document& document) {
    auto* watch = document.findChild<document::FileWatch*>();
    return watch ? *watch : *new document::FileWatch(&document);
}

} // namespace

MainWindow::MainWindow(QWidget* parent) : MainWindow(std::make_unique<document::Document>(), parent) {}

MainWindow::MainWindow(std::unique_ptr<document::Document> document, QWidget* parent)
    : QMainWindow(parent), m_ownDocument(std::move(document)), m_document(*m_ownDocument),
      m_watch(watchOf(m_document)) {
    setObjectName(QStringLiteral("mainWindow"));
    setWindowTitle(tr("KnittSim"));
    setWindowIcon(applicationIcon());
    setAcceptDrops(true);
    setDockOptions(AllowTabbedDocks | AllowNestedDocks | GroupedDragging);
    buildCentre();
    buildDocks();
    buildTeaching();
    buildActions();
    connectDocument();
    connectFabric();
    restoreSession();
    restoreChecks();
    takeRecentFiles();
    takeActions();
    if (m_document.file()) {
        takeChart();
        takeDocument();
        takeFabric();
        takeFrame();
        takePins();
        takeProblems();
        takeDescription();
        if (m_watch.hasChanged()) {
            takeForeignChange();
        }
    } else {
        showGallery();
        offerRecovery();
    }
}

std::unique_ptr<document::Document> MainWindow::releaseDocument() {
    saveSession();
    return std::move(m_ownDocument);
}

MainWindow::~MainWindow() {
    // The views look at the document, which is a member and goes before the window's children would.
    hide();
    for (QDockWidget* dock : docks()) {
        delete dock;
    }
    for (QWidget* view : std::initializer_list<QWidget*>{m_toolBar, m_status, centralWidget()}) {
        delete view;
    }
}

void MainWindow::buildCentre() {
    auto* centre = new QWidget(this);
    m_banner = new Banner(centre);
    m_pages = new QStackedWidget(centre);
    m_gallery = new Gallery(m_pages);
    m_workspace = new QWidget(m_pages);
    m_fabric = new FabricView(m_workspace);
    m_fabric->setObjectName(QStringLiteral("fabricView"));
    m_fabric->setAccessibleName(tr("Fabric"));
    m_fabric->setFocusPolicy(Qt::StrongFocus);
    m_fabric->setDark(isDark(palette()));
    m_history = new HistoryCard(m_document, m_fabric);
    m_photograph = new PhotographCard(*m_fabric);
    m_player = new StepPlayer(m_document, m_workspace);
    auto* work = new QVBoxLayout(m_workspace);
    work->setContentsMargins(0, 0, 0, 0);
    work->setSpacing(0);
    m_comparison = new Comparison(m_document, *m_fabric, m_workspace);
    work->addWidget(m_comparison, 1);
    work->addWidget(m_player);
    m_pages->addWidget(m_gallery);
    m_pages->addWidget(m_workspace);
    auto* rows = new QVBoxLayout(centre);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(m_banner);
    rows->addWidget(m_pages, 1);
    setCentralWidget(centre);
    new OpeningCard(m_document, centre);
    m_status = new StatusLine(m_document, this);
    statusBar()->addPermanentWidget(m_status, 1);
    connect(m_gallery, &Gallery::sampleChosen, this, &MainWindow::openSample);
    connect(m_gallery, &Gallery::fileChosen, this, &MainWindow::openFile);
    connect(m_gallery, &Gallery::openWanted, this, &MainWindow::chooseFile);
    connect(m_gallery, &Gallery::newWanted, this, &MainWindow::newChart);
}

void MainWindow::connectDocument() {
    using document::Document;
    connect(&m_document, &Document::opened, this, &MainWindow::takeFile);
    connect(&m_document, &Document::chartChanged, this, &MainWindow::takeChart);
    connect(&m_document, &Document::saved, this, [this] {
        takeTitle();
        m_watch.watch(m_document.path());
        m_views.moveTo(m_document.path());
        movePhotograph();
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

void MainWindow::connectFabric() {
    using document::Document;
    connect(&m_document, &Document::frameShown, this, [this] {
        takeFrame();
        m_status->setRenderer(m_fabric->hasOpenGl() ? m_fabric->rendererName() : tr("Qt, flat"));
    });
    connect(&m_document, &Document::yarnRunChanged, this, &MainWindow::takeYarnRun);
    connect(&m_document, &Document::pinsChanged, this, &MainWindow::takePins);
    connect(&m_document, &Document::yarnsChanged, this,
            [this] { m_fabric->setLooks(looksOf(m_document.carriers())); });
    connect(&m_document, &Document::selectionChanged, this, [this] {
        const auto fabric = m_document.shownFabric();
        const int loop = m_document.selection().loop;
        m_fabric->setSelection(fabric && loop < static_cast<int>(fabric->loops.size()) ? loop : -1);
    });
    connect(m_fabric, &FabricView::loopClicked, &m_document, &Document::selectLoop);
    connect(m_fabric, &FabricView::pointClicked, &m_document, &Document::selectPoint);
    connect(&m_document, &Document::pointChanged, this,
            [this] { m_fabric->setSelectedPoint(m_document.selectedPoint()); });
    connect(m_history, &HistoryCard::lineWanted, this, &MainWindow::showLine);
    connect(m_history, &HistoryCard::closeWanted, this,
            [this] { findChild<QAction*>(QStringLiteral("actionHistory"))->setChecked(false); });
    connect(m_fabric, &FabricView::loopHovered, m_status, &StatusLine::setHoveredLoop);
    connect(m_grid, &PatternGrid::loopHovered, m_status, &StatusLine::setHoveredLoop);
    connect(m_fabric, &FabricView::dragMoved, &m_document, [this](int point, QVector3D place) {
        m_document.drag(point, {place.x(), place.y(), place.z()});
    });
    connect(m_fabric, &FabricView::dragEnded, &m_document, &Document::releaseDrag);
    m_fabric->setDescriber([this](int loop) { return describeLoop(loop); });
    connect(m_fabric, &FabricView::measured, this, [this](double millimetres) {
        statusBar()->showMessage(tr("Tape: %1").arg(lengthText(millimetres)), 10000);
    });
    connect(m_comparison, &Comparison::changed, this, &MainWindow::takeActions);
    connect(m_comparison, &Comparison::failed, this,
            [this](const QString& text) { m_banner->showMessage(Banner::Kind::Error, text); });
    connect(m_fabric, &FabricView::glFailed, this,
            [this](const QString& reason) { m_banner->showMessage(Banner::Kind::Note, reason); });
}

void MainWindow::takeDescription() {
    const auto file = m_document.file();
    m_fabric->setAccessibleDescription(file ? tr("%1 columns, %2 courses, %3, %4 problems")
                                                  .arg(file->grid->columnCount())
                                                  .arg(file->grid->courseCount())
                                                  .arg(activityWord(m_document.activity()))
                                                  .arg(m_document.problems().size())
                                            : QString());
}

void MainWindow::takeFrame() {
    m_fabric->setFollowing(m_document.step() == m_document.operationCount() && !m_document.laddersRun());
    m_fabric->setFrame(m_document.shownFrame());
    m_fabric->setNeedles(m_document.needleHooks());
    takeYarnRun();
}

void MainWindow::takePins() {
    m_fabric->setPins(m_document.pins());
}

void MainWindow::takeYarnRun() {
    m_fabric->setYarn(m_document.showsYarn() ? m_document.yarnRun().shape()->picture : nullptr);
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

void MainWindow::takeFabric() {
    m_fabric->setFabric(m_document.shownFabric(), looksOf(m_document.carriers()));
    if (const auto frame = m_document.shownFrame()) {
        m_fabric->setFrame(frame);
    }
    markProblems();
    const int loop = m_document.selection().loop;
    const auto fabric = m_document.shownFabric();
    m_fabric->setSelection(fabric && loop < static_cast<int>(fabric->loops.size()) ? loop : -1);
    m_fabric->setSelectedPoint(m_document.selectedPoint());
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

void MainWindow::showWorkspace() {
    if (m_pages->currentWidget() == m_workspace) {
        return;
    }
    m_pages->setCurrentWidget(m_workspace);
    if (m_arrangement.isEmpty() || !restoreState(m_arrangement)) {
        arrange(m_layout);
    }
    takeClass();
    m_fabric->setFocus();
}

void MainWindow::showGallery() {
    if (m_pages->currentWidget() == m_workspace) {
        m_arrangement = saveState();
    }
    m_pages->setCurrentWidget(m_gallery);
    for (QDockWidget* dock : docks()) {
        dock->hide();
    }
    m_toolBar->hide();
    m_status->hide();
    applyContrast(*qApp, false);
    m_gallery->setRecentFiles(m_session.recentFiles());
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

void MainWindow::setAppearance(document::Appearance appearance) {
    m_session.setAppearance(appearance);
    applyAppearance(*qApp, appearance);
}

void MainWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && m_fabric) {
        m_fabric->setDark(isDark(palette()));
    }
    QMainWindow::changeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!firstLocalFile(event->mimeData()).isEmpty()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    if (const QString path = firstLocalFile(event->mimeData()); !path.isEmpty()) {
        event->acceptProposedAction();
        openFile(path);
    }
}

void MainWindow::closeEvent(QCloseEvent* event) {
    event->ignore();
    whenLeft([this, event] {
        saveSession();
        QMainWindow::closeEvent(event);
    });
}

} // namespace knittsim::ui
