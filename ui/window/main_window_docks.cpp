#include "ui/views/chart_editor/chart_editor.h"
#include "ui/views/chart_editor/legend_panel.h"
#include "ui/views/diagnostics/diagnostics_panel.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/views/history/history_card.h"
#include "ui/views/lesson/lesson_panel.h"
#include "ui/views/lesson/teaching_board.h"
#include "ui/views/needle_beds/needle_beds.h"
#include "ui/views/pattern_editor/pattern_grid.h"
#include "ui/views/simulation_panel/simulation_panel.h"
#include "ui/views/source/source_view.h"
#include "ui/views/step_player/step_player.h"
#include "ui/views/style/appearance.h"
#include "ui/views/style/icons.h"
#include "ui/views/yarn_library/yarn_panel.h"
#include "ui/window/key_guard.h"
#include "ui/window/main_window.h"
#include "ui/window/status_line.h"

#include <QApplication>
#include <QDockWidget>
#include <QScreen>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QUndoView>

#include <algorithm>

namespace knittsim::ui {

namespace {

const QString kGeometry = QStringLiteral("window/geometry");
const QString kArrangement = QStringLiteral("window/arrangement3"); // the number rises when docks change
const QString kLayout = QStringLiteral("window/layout");
const QString kStyle = QStringLiteral("window/style");
const QString kOrthographic = QStringLiteral("window/orthographic");
const QString kHair = QStringLiteral("window/hair");
const QString kLegend = QStringLiteral("window/legend");
const QString kLook = QStringLiteral("window/chartLook");
const QString kHistory = QStringLiteral("window/history");

/// Where the arrangement of each layout is kept.
QString arrangementKey(Layout layout) {
    return kArrangement + QString::number(static_cast<int>(layout));
}

constexpr double kTeachingSpeed = 0.5; ///< operations a second, so that their phases are seen
constexpr int kLeftWidth = 320;
constexpr int kChartWidth = 470; ///< the symbols of 40 wales are seen
constexpr int kRightWidth = 290;
/// In a lower window yarns and simulation share one place.
constexpr int kLeastHeightForBoth = 760;

} // namespace

QDockWidget* MainWindow::addDock(const QString& name, const QString& title, QWidget* content,
                                 Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setWidget(content);
    addDockWidget(area, dock);
    connect(dock, &QDockWidget::visibilityChanged, this, &MainWindow::takeTitleBars);
    connect(dock, &QDockWidget::topLevelChanged, this, &MainWindow::takeTitleBars);
    connect(dock, &QDockWidget::dockLocationChanged, this, &MainWindow::takeTitleBars);
    return dock;
}

void MainWindow::buildDocks() {
    m_grid = new PatternGrid(m_document, m_look, this);
    m_source = new SourceView(m_document, this);
    m_yarns = new YarnPanel(m_document, this);
    m_simulation = new SimulationPanel(m_document, this);
    m_problems = new DiagnosticsPanel(m_document, this);
    m_beds = new NeedleBeds(m_document, this);
    m_chart = new ChartEditor(m_document, m_look, this);
    m_patterns = new QStackedWidget(this);
    m_patterns->addWidget(m_grid);
    m_patterns->addWidget(m_chart);
    m_gridDock = addDock(QStringLiteral("gridDock"), tr("Pattern"), m_patterns, Qt::LeftDockWidgetArea);
    m_sourceDock = addDock(QStringLiteral("sourceDock"), tr("Source"), m_source, Qt::LeftDockWidgetArea);
    m_yarnDock = addDock(QStringLiteral("yarnDock"), tr("Yarns"), m_yarns, Qt::RightDockWidgetArea);
    m_simulationDock =
        addDock(QStringLiteral("simulationDock"), tr("Simulation"), m_simulation, Qt::RightDockWidgetArea);
    m_problemDock =
        addDock(QStringLiteral("problemDock"), tr("Problems"), m_problems, Qt::BottomDockWidgetArea);
    m_bedDock = addDock(QStringLiteral("bedDock"), tr("Needle beds"), m_beds, Qt::BottomDockWidgetArea);
    m_legendDock = addDock(QStringLiteral("legendDock"), tr("Legend"),
                           new LegendPanel(m_document, m_look, this), Qt::RightDockWidgetArea);
    auto* steps = new QUndoView(m_document.undoStack(), this);
    steps->setObjectName(QStringLiteral("steps"));
    steps->setAccessibleName(tr("Steps of the work"));
    steps->setWhatsThis(tr("What was done, the last step at the end. A click goes there and back again."));
    steps->setToolTip(tr("Click a step to go there; the disk marks what is saved"));
    steps->setEmptyLabel(tr("As it was opened"));
    steps->setCleanIcon(icon(QStringLiteral("save")));
    steps->setFrameShape(QFrame::NoFrame);
    m_stepsDock = addDock(QStringLiteral("stepsDock"), tr("Steps"), steps, Qt::RightDockWidgetArea);
    connect(m_player, &StepPlayer::playingChanged, m_beds, &NeedleBeds::setPlaying);
    connect(m_player, &StepPlayer::tempoChanged, m_beds, &NeedleBeds::setSpeed);
    m_beds->setSpeed(m_player->speed());
    for (const Qt::Corner corner : {Qt::TopLeftCorner, Qt::BottomLeftCorner}) {
        setCorner(corner, Qt::LeftDockWidgetArea);
    }
    for (const Qt::Corner corner : {Qt::TopRightCorner, Qt::BottomRightCorner}) {
        setCorner(corner, Qt::RightDockWidgetArea);
    }
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    tabifyDockWidget(m_gridDock, m_sourceDock);
    m_gridDock->raise();
}

std::vector<QDockWidget*> MainWindow::docks() const {
    return {m_gridDock,       m_sourceDock,  m_legendDock, m_yarnDock,  m_stepsDock,
            m_simulationDock, m_problemDock, m_bedDock,    m_lessonDock};
}

void MainWindow::takeTitleBars() {
    // A dock behind a tab is named and moved by the tab; a title bar would say the same again.
    for (auto* dock : findChildren<QDockWidget*>()) {
        const auto others = tabifiedDockWidgets(dock);
        const bool shared = std::ranges::any_of(
            others, [](QDockWidget* other) { return other->toggleViewAction()->isChecked(); });
        const bool tabbed = !dock->isFloating() && shared;
        if (tabbed && !dock->titleBarWidget()) {
            dock->setTitleBarWidget(new QWidget(dock));
        } else if (!tabbed && dock->titleBarWidget()) {
            QWidget* empty = dock->titleBarWidget();
            dock->setTitleBarWidget(nullptr);
            empty->deleteLater();
        }
    }
}

void MainWindow::arrange(Layout layout) {
    const std::initializer_list<std::pair<QDockWidget*, Qt::DockWidgetArea>> homes{
        {m_gridDock, Qt::LeftDockWidgetArea},   {m_sourceDock, Qt::LeftDockWidgetArea},
        {m_yarnDock, Qt::RightDockWidgetArea},  {m_simulationDock, Qt::RightDockWidgetArea},
        {m_bedDock, Qt::BottomDockWidgetArea},  {m_problemDock, Qt::BottomDockWidgetArea},
        {m_lessonDock, Qt::RightDockWidgetArea}};
    for (QDockWidget* dock : {m_legendDock, m_stepsDock, m_simulationDock}) {
        dock->hide(); // above each other they would make a low window grow
        dock->setFloating(false);
    }
    for (const auto& [dock, area] : homes) {
        dock->setFloating(false);
        addDockWidget(area, dock);
    }
    tabifyDockWidget(m_gridDock, m_sourceDock);
    const bool teaching = layout == Layout::Teaching;
    tabifyDockWidget(m_problemDock, m_bedDock);
    const bool low = height() < kLeastHeightForBoth;
    if (low) {
        tabifyDockWidget(m_yarnDock, m_simulationDock);
    }
    for (QDockWidget* dock : {m_legendDock, m_stepsDock}) {
        tabifyDockWidget(m_yarnDock, dock);
    }
    m_gridDock->setVisible(!teaching);
    m_bedDock->setVisible(teaching);
    m_sourceDock->setVisible(!teaching);
    m_yarnDock->setVisible(layout == Layout::Standard);
    m_simulationDock->setVisible(layout == Layout::Standard);
    m_legendDock->setVisible(layout == Layout::Standard);
    m_stepsDock->setVisible(layout == Layout::Standard);
    m_problemDock->setVisible(layout == Layout::Checking ||
                              (!teaching && hasWarnings(m_document.problems())));
    m_lessonDock->setVisible(m_lesson->running());
    if (!teaching) {
        (layout == Layout::Checking ? m_sourceDock : m_gridDock)->raise();
    }
    (low ? m_simulationDock : m_yarnDock)->raise();
    resizeDocks({m_gridDock, m_yarnDock}, {m_document.project() ? kChartWidth : kLeftWidth, kRightWidth},
                Qt::Horizontal);
    resizeDocks({m_yarnDock, m_simulationDock}, {380, 320}, Qt::Vertical);
    if (teaching) {
        m_bedDock->raise();
        resizeDocks({m_bedDock}, {height() * 2 / 5}, Qt::Vertical);
        m_player->setSpeed(kTeachingSpeed);
    }
    takeClass();
}

/// What a class needs beyond the places of the panels.
void MainWindow::takeClass() {
    const bool teaching = m_layout == Layout::Teaching;
    m_board->setVisible(teaching);
    m_player->setWords(!teaching);
    m_toolBar->setVisible(!teaching);
    m_status->setVisible(!teaching);
    statusBar()->setVisible(!teaching);
    setProperty(KeyGuard::kSteps, teaching);
    m_player->setSkimming(teaching);
    m_fabric->setForClass(teaching);
    applyContrast(*qApp, teaching);
}

void MainWindow::applyLayout(Layout layout) {
    const bool again = layout == m_layout;
    const bool shown = m_pages->currentWidget() == m_workspace;
    if (shown && !again) {
        m_session.setValue(arrangementKey(m_layout), saveState());
    }
    m_layout = layout;
    if (shown) {
        // The first press brings the layout as it was left, the next one as it comes.
        if (again || !restoreState(m_session.value(arrangementKey(layout)))) {
            arrange(layout);
        }
        takeClass();
        takeActions();
    } else {
        m_arrangement.clear(); // the docks are hidden now and come with the next file
    }
}

void MainWindow::restoreSession() {
    resize(QSize(1280, 800).boundedTo(screen()->availableSize()));
    if (const QByteArray geometry = m_session.value(kGeometry); !geometry.isEmpty()) {
        restoreGeometry(geometry);
    }
    m_arrangement = m_session.value(kArrangement);
    const int layout = m_session.value(kLayout).toInt();
    m_layout = layout == 1 ? Layout::Teaching : layout == 2 ? Layout::Checking : Layout::Standard;
    const int style = m_session.value(kStyle).toInt();
    m_fabric->setStyle(style == 1   ? render::DrawStyle::Strokes
                       : style == 2 ? render::DrawStyle::Mesh
                                    : render::DrawStyle::Yarn);
    m_fabric->setOrthographic(m_session.value(kOrthographic) == "1");
    m_fabric->setHair(m_session.value(kHair) != "0");
    m_fabric->setLegend(m_session.value(kLegend) != "0");
    m_look.restore(m_session.value(kLook));
    m_history->setSwitchedOn(m_session.value(kHistory) != "0");
}

void MainWindow::saveSession() {
    m_session.setValue(kGeometry, saveGeometry());
    m_session.setValue(kArrangement, m_pages->currentWidget() == m_workspace ? saveState() : m_arrangement);
    m_session.setValue(kLayout, QByteArray::number(static_cast<int>(m_layout)));
    const render::DrawStyle style = m_fabric->style();
    m_session.setValue(kStyle, style == render::DrawStyle::Strokes ? "1"
                               : style == render::DrawStyle::Mesh  ? "2"
                                                                   : "0");
    m_session.setValue(kOrthographic, m_fabric->isOrthographic() ? "1" : "0");
    m_session.setValue(kHair, m_fabric->hasHair() ? "1" : "0");
    m_session.setValue(kLegend, m_fabric->hasLegend() ? "1" : "0");
    m_session.setValue(kLook, m_look.save());
    m_session.setValue(kHistory, m_history->isSwitchedOn() ? "1" : "0");
}

} // namespace knittsim::ui
