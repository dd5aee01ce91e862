#include "ui/window/main_window.h"

#include "ui/views/fabric_view/fabric_view.h"
#include "ui/views/history/history_card.h"
#include "ui/views/step_player/step_player.h"
#include "ui/views/style/appearance.h"
#include "ui/views/style/icons.h"
#include "ui/window/banner.h"
#include "ui/window/comparison.h"
#include "ui/window/gallery.h"
#include "ui/window/opening_card.h"
#include "ui/window/photograph_card.h"
#include "ui/window/status_line.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QMimeData>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

namespace knittsim::ui {

namespace {

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
    buildPlayer();
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
    connect(m_gallery, &Gallery::pictureWanted, this, &MainWindow::choosePicture);
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
    m_gallery->setFocus();
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
