#include "core/pattern/samples.h"
#include "ui/dialogs/about_dialog.h"
#include "ui/dialogs/key_dialog.h"
#include "ui/dialogs/pull_dialog.h"
#include "ui/views/diagnostics/diagnostics_panel.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/views/simulation_panel/ladder_text.h"
#include "ui/views/simulation_panel/simulation_panel.h"
#include "ui/views/simulation_panel/yarn_run_text.h"
#include "ui/views/step_player/step_player.h"
#include "ui/views/style/icons.h"
#include "ui/views/style/menu_pictures.h"
#include "ui/views/yarn_library/yarn_panel.h"
#include "ui/window/comparison.h"
#include "ui/window/gallery.h"
#include "ui/window/main_window.h"
#include "ui/window/sample_card.h"

#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>

namespace knittsim::ui {

namespace {

constexpr int kRecentPicture = 40; ///< pixels
const QString kSaveShapeKey = QStringLiteral("preferences/saveShape");

} // namespace

void MainWindow::buildFileMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&File"));
    addAction(menu, "actionNew", tr("&New chart\u2026"), QKeySequence::New, "new", [this] { newChart(); });
    addAction(menu, "actionOpen", tr("&Open\u2026"), QKeySequence::Open, "open", [this] { chooseFile(); });
    m_recentMenu = menu->addMenu(tr("Open &recent"));
    showPictures(m_recentMenu, kRecentPicture);
    m_recentMenu->setObjectName(QStringLiteral("recentMenu"));
    m_recentMenu->setToolTipsVisible(true);
    QMenu* samples = menu->addMenu(icon(QStringLiteral("samples")), tr("&Samples"));
    samples->setObjectName(QStringLiteral("sampleMenu"));
    samples->setToolTipsVisible(true);
    for (const pattern::Sample& sample : pattern::samples()) {
        const QString id = QString::fromStdString(sample.id);
        QAction* action = addAction(samples, "actionSample_" + id, sampleTitle(sample), {}, {},
                                    [this, id] { openSample(id); });
        action->setToolTip(sampleDescription(sample));
    }
    addAction(menu, "actionGallery", tr("Sample &gallery"), QKeySequence(tr("Ctrl+Shift+O")), {},
              [this] { showGallery(); });
    addAction(menu, "actionImportPicture", tr("&Import a picture\u2026"), QKeySequence(tr("Ctrl+Alt+I")), {},
              [this] { choosePicture(); });
    menu->addSeparator();
    addAction(menu, "actionSave", tr("&Save"), QKeySequence::Save, "save", [this] { saveChart(); });
    addAction(menu, "actionSaveAs", tr("Save &as\u2026"), QKeySequence(tr("Ctrl+Shift+S")), {},
              [this] { saveChartAs(); });
    QAction* shape =
        addChoice(menu, nullptr, "actionSaveShape", tr("Keep the settled s&hape in the file"), {}, {}, [] {});
    shape->setToolTip(tr("The fabric lies there at once when the file is opened again"));
    shape->setChecked(m_session.value(kSaveShapeKey) == "1");
    connect(shape, &QAction::toggled, this,
            [this](bool on) { m_session.setValue(kSaveShapeKey, on ? "1" : "0"); });
    addAction(menu, "actionExportMachine", tr("Export &machine data\u2026"), QKeySequence(tr("Ctrl+Shift+D")),
              {}, [this] { exportMachineData(); });
    menu->addSeparator();
    addAction(menu, "actionExportChart", tr("Export &chart\u2026"), QKeySequence(tr("Ctrl+Shift+P")), {},
              [this] { exportChart(); })
        ->setToolTip(tr("The chart with legend and yarn amounts as PDF or PNG (Ctrl+Shift+P)"));
    addAction(menu, "actionExport", tr("&Export\u2026"), QKeySequence(tr("Ctrl+E")), "picture",
              [this] { exportShown(); });
    addAction(menu, "actionExportReport", tr("Export &report\u2026"), QKeySequence(tr("Ctrl+Shift+E")), {},
              [this] { chooseReportFile(); });
    menu->addSeparator();
    addAction(menu, "actionQuit", tr("&Quit"), QKeySequence(tr("Ctrl+Q")), {},
              [] { QApplication::closeAllWindows(); });
}

void MainWindow::buildEditMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&Edit"));
    QUndoStack* stack = m_document.undoStack();
    for (const bool undo : {true, false}) {
        QAction* action =
            undo ? stack->createUndoAction(this, tr("&Undo")) : stack->createRedoAction(this, tr("&Redo"));
        action->setObjectName(undo ? "actionUndo" : "actionRedo");
        action->setIcon(icon(undo ? QStringLiteral("undo") : QStringLiteral("redo")));
        action->setShortcut(undo ? QKeySequence(QKeySequence::Undo) : QKeySequence(tr("Ctrl+Shift+Z")));
        const QString key = action->shortcut().toString(QKeySequence::NativeText);
        const auto tip = [action, key] {
            action->setToolTip(QStringLiteral("%1 (%2)").arg(action->text().remove(u'&'), key));
        };
        connect(stack, &QUndoStack::indexChanged, action, tip);
        tip();
        menu->addAction(action);
    }
    menu->addSeparator();
    addAction(menu, "actionFindYarn", tr("&Find a yarn"), QKeySequence::Find, "search", [this] {
        m_yarnDock->show();
        m_yarnDock->raise();
        m_yarns->search();
    });
    addAction(menu, "actionSelectNone", tr("Select &nothing"), Qt::Key_Escape, {}, [this] {
        if (m_document.laddersRun()) {
            m_document.cancelLadders();
        } else if (m_fabric->cancelAlignment()) {
            takeActions();
        } else if (m_document.selection() == document::Selection{} && m_comparison->isOpen()) {
            m_comparison->close();
        } else {
            m_document.clearSelection();
        }
    });
    menu->addSeparator();
    addAction(menu, "actionNextProblem", tr("Next &problem"), Qt::Key_F8, {},
              [this] { m_problems->walk(+1); });
    addAction(menu, "actionPreviousProblem", tr("Pre&vious problem"), Qt::SHIFT | Qt::Key_F8, {},
              [this] { m_problems->walk(-1); });
}

void MainWindow::buildMachineMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&Machine"));
    menu->setObjectName(QStringLiteral("machineMenu"));
    addAction(menu, "actionPlay", tr("&Play the operations"), Qt::Key_Space, "play",
              [this] { m_player->togglePlaying(); });
    addAction(menu, "actionSlower", tr("&Slower"), Qt::Key_BracketLeft, {},
              [this] { m_player->changeSpeed(-1); });
    addAction(menu, "actionFaster", tr("&Faster"), Qt::Key_BracketRight, {},
              [this] { m_player->changeSpeed(+1); });
    menu->addSeparator();
    addAction(menu, "actionOperationForward", tr("Operation &forward"), Qt::Key_Right, "forward",
              [this] { m_document.moveStep(+1); });
    addAction(menu, "actionOperationBack", tr("Operation &back"), Qt::Key_Left, "back",
              [this] { m_document.moveStep(-1); });
    addAction(menu, "actionPassForward", tr("Pa&ss forward"), Qt::SHIFT | Qt::Key_Right, {},
              [this] { m_document.movePass(+1); });
    addAction(menu, "actionPassBack", tr("Pass bac&k"), Qt::SHIFT | Qt::Key_Left, {},
              [this] { m_document.movePass(-1); });
    addAction(menu, "actionCourseForward", tr("&Course forward"), Qt::Key_Up, "course-forward",
              [this] { m_document.moveCourse(+1); });
    addAction(menu, "actionCourseBack", tr("C&ourse back"), Qt::Key_Down, "course-back",
              [this] { m_document.moveCourse(-1); });
    addAction(menu, "actionFirst", tr("To the &empty machine"), Qt::Key_Home, "first",
              [this] { m_document.setStep(0); });
    addAction(menu, "actionLast", tr("To the e&nd of the program"), Qt::Key_End, "last",
              [this] { m_document.setStep(m_document.operationCount()); });
    addAction(menu, "actionGoToLine", tr("&Go to line\u2026"), QKeySequence(tr("Ctrl+G")), {},
              [this] { m_player->askForLine(); });
    for (QMenu* marks : m_player->menus()) {
        menu->addMenu(marks);
    }
    menu->addSeparator();
    addAction(menu, "actionAddMachine", tr("&Add machine\u2026"), {}, {}, [this] { chooseMachineFile(); });
}

void MainWindow::buildSimulateMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&Simulate"));
    menu->setObjectName(QStringLiteral("simulateMenu"));
    addAction(menu, "actionRun", tr("&Start or pause"), Qt::Key_F5, "play",
              [this] { m_simulation->toggleRunning(); });
    addAction(menu, "actionStep", tr("One s&tep"), Qt::Key_F6, "step",
              [this] { m_document.stepSimulation(); });
    addAction(menu, "actionRestart", tr("&Restart from the machine"), Qt::Key_R, "restart",
              [this] { m_document.restart(); });
    addAction(menu, "actionStop", tr("St&op"), Qt::SHIFT | Qt::Key_F5, "stop", [this] { m_document.stop(); });
    menu->addSeparator();
    QAction* yarn = addAction(menu, "actionSettleYarn", tr("Settle as &yarn"), Qt::Key_Y, "style-yarn",
                              [this] { m_document.settleYarn(); });
    connect(&m_document, &document::Document::yarnRunChanged, yarn,
            [this, yarn] { yarn->setText(settleYarnText(m_document.yarnRun())); });
    QAction* pull =
        addAction(menu, "actionPullTest", tr("Pull &test\u2026"), Qt::CTRL | Qt::Key_P, {}, [this] {
            auto* dialog = new PullDialog(m_document, this);
            dialog->setAttribute(Qt::WA_DeleteOnClose);
            dialog->open();
        });
    pull->setToolTip(tr("Force against strain of a repeat of the fabric (Ctrl+P)"));
    QMenu* around = menu->addMenu(tr("S&urroundings of the yarn"));
    around->setToolTipsVisible(true);
    auto* surroundings = new QActionGroup(this);
    for (const simulation::SurroundingsInfo& info : simulation::surroundingsKinds()) {
        const simulation::Surroundings value = info.value;
        QAction* action =
            addChoice(around, surroundings, QStringLiteral("actionSurroundings_%1").arg(info.id),
                      surroundingsName(info), {}, {}, [this, value] { m_document.setSurroundings(value); });
        action->setToolTip(surroundingsPurpose(info));
        const auto take = [this, action, value] {
            action->setChecked(m_document.yarnRun().surroundings() == value);
        };
        connect(&m_document, &document::Document::yarnRunChanged, action, take);
        take();
    }
    menu->addSeparator();
    QMenu* integrators = menu->addMenu(tr("&Integrator"));
    integrators->setToolTipsVisible(true);
    auto* group = new QActionGroup(this);
    for (const simulation::IntegratorInfo& info : simulation::integrators()) {
        const QString id = QString::fromUtf8(info.id);
        QAction* action = addChoice(integrators, group, "actionIntegrator_" + id, integratorName(info), {},
                                    {}, [this, id] { m_document.setIntegrator(id); });
        action->setToolTip(integratorPurpose(info));
        action->setChecked(id == m_document.integrator());
        connect(&m_document, &document::Document::integratorChanged, action,
                [this, action, id] { action->setChecked(id == m_document.integrator()); });
    }
    menu->addSeparator();
    addAction(menu, "actionRemoveLadders", tr("Remove &ladders"), Qt::CTRL | Qt::Key_L, "ladder",
              [this] { m_document.removeLadders(); });
    QAction* holder = addChoice(menu, nullptr, "actionStitchHolder", tr("Stitch &holder"),
                                Qt::CTRL | Qt::SHIFT | Qt::Key_L, {}, [] {});
    holder->setToolTip(stitchHolderHelp());
    connect(holder, &QAction::toggled, &m_document, &document::Document::setStitchHolder);
    menu->addSeparator();
    QAction* drag =
        addChoice(menu, nullptr, "actionDrag", tr("&Pull the yarn with the mouse"), Qt::Key_D, "drag", [] {});
    connect(drag, &QAction::toggled, this, [this](bool on) { m_fabric->setDragMode(on); });
    addAction(menu, "actionPin", tr("P&in the selected bonding point, or free it"), Qt::Key_P, {},
              [this] { m_document.togglePin(); });
    addAction(menu, "actionRemovePins", tr("Re&move all pins"), Qt::SHIFT | Qt::Key_P, {},
              [this] { m_document.removePins(); });
}

void MainWindow::buildWindowMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&Window"));
    menu->setObjectName(QStringLiteral("windowMenu"));
    for (QDockWidget* dock : docks()) {
        menu->addAction(dock->toggleViewAction());
    }
    menu->addSeparator();
    auto* layouts = new QActionGroup(this);
    addChoice(menu, layouts, "actionLayoutStandard", tr("&Designer"), Qt::Key_F3, {},
              [this] { applyLayout(Layout::Standard); });
    QAction* teaching = addChoice(menu, layouts, "actionLayoutTeaching", tr("&Teacher"), Qt::Key_F4, {},
                                  [this] { applyLayout(Layout::Teaching); });
    teaching->setShortcuts({Qt::Key_F4, Qt::CTRL | Qt::SHIFT | Qt::Key_T});
    addChoice(menu, layouts, "actionLayoutChecking", tr("&Quality assurance"), Qt::Key_F7, {},
              [this] { applyLayout(Layout::Checking); });
}

void MainWindow::buildHelpMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&Help"));
    addAction(menu, "actionKeys", tr("&Keys"), Qt::Key_F1, "help", [this] {
        auto* dialog = new KeyDialog(menuBar(), this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->open();
    });
    addAction(menu, "actionAbout", tr("&About KnittSim"), {}, {}, [this] {
        auto* dialog = new AboutDialog(m_fabric->rendererName(), this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->open();
    });
}

} // namespace knittsim::ui
