#include "core/pattern/samples.h"
#include "ui/dialogs/about_dialog.h"
#include "ui/dialogs/key_dialog.h"
#include "ui/dialogs/pull_dialog.h"
#include "ui/views/chart_editor/chart_canvas.h"
#include "ui/views/chart_editor/chart_editor.h"
#include "ui/views/diagnostics/diagnostics_model.h"
#include "ui/views/diagnostics/diagnostics_panel.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/views/history/history_card.h"
#include "ui/views/lesson/lesson_panel.h"
#include "ui/views/needle_beds/needle_beds.h"
#include "ui/views/pattern_editor/pattern_grid.h"
#include "ui/views/simulation_panel/ladder_text.h"
#include "ui/views/simulation_panel/simulation_panel.h"
#include "ui/views/simulation_panel/yarn_run_text.h"
#include "ui/views/step_player/step_player.h"
#include "ui/views/style/icons.h"
#include "ui/views/yarn_library/yarn_panel.h"
#include "ui/window/comparison.h"
#include "ui/window/gallery.h"
#include "ui/window/machine_choice.h"
#include "ui/window/main_window.h"
#include "ui/window/sample_card.h"
#include "ui/window/sample_thumbnail.h"

#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QFileInfo>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include <algorithm>

namespace knittsim::ui {

using document::Appearance;
using render::DrawStyle;

QAction* MainWindow::addAction(QMenu* menu, const QString& name, const QString& text,
                               const QKeySequence& keys, const QString& iconName,
                               const std::function<void()>& action) {
    auto* made = new QAction(text, this);
    made->setObjectName(name);
    made->setShortcut(keys);
    if (!iconName.isEmpty()) {
        made->setIcon(icon(iconName));
    }
    const QString plain = QString(text).remove(u'&').remove(QChar(0x2026));
    made->setToolTip(keys.isEmpty()
                         ? plain
                         : QStringLiteral("%1 (%2)").arg(plain, keys.toString(QKeySequence::NativeText)));
    connect(made, &QAction::triggered, this, action);
    menu->addAction(made);
    return made;
}

QAction* MainWindow::addChoice(QMenu* menu, QActionGroup* group, const QString& name, const QString& text,
                               const QKeySequence& keys, const QString& iconName,
                               const std::function<void()>& action) {
    QAction* made = addAction(menu, name, text, keys, iconName, action);
    made->setCheckable(true);
    if (group) {
        group->addAction(made);
    }
    return made;
}

void MainWindow::buildActions() {
    buildFileMenu();
    buildEditMenu();
    buildViewMenu();
    buildChartMenu();
    buildMachineMenu();
    buildSimulateMenu();
    buildLessonMenu();
    buildWindowMenu();
    buildHelpMenu();
    buildToolBar();
}

void MainWindow::buildFileMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&File"));
    addAction(menu, "actionNew", tr("&New chart\u2026"), QKeySequence::New, "new", [this] { newChart(); });
    addAction(menu, "actionOpen", tr("&Open\u2026"), QKeySequence::Open, "open", [this] { chooseFile(); });
    m_recentMenu = menu->addMenu(tr("Open &recent"));
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

void MainWindow::buildViewMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&View"));
    addAction(menu, "actionFront", tr("&Front"), Qt::Key_1, "view-front", [this] { m_fabric->lookFront(); });
    addAction(menu, "actionBack", tr("&Back"), Qt::CTRL | Qt::Key_1, "view-back",
              [this] { m_fabric->lookBack(); });
    addAction(menu, "actionRight", tr("&Right"), Qt::Key_3, {}, [this] { m_fabric->lookRight(); });
    addAction(menu, "actionLeft", tr("&Left"), Qt::CTRL | Qt::Key_3, {}, [this] { m_fabric->lookLeft(); });
    addAction(menu, "actionTop", tr("&Top"), Qt::Key_7, "view-top", [this] { m_fabric->lookTop(); });
    addAction(menu, "actionBottom", tr("B&ottom"), Qt::CTRL | Qt::Key_7, {},
              [this] { m_fabric->lookBottom(); });
    menu->addSeparator();
    QAction* flat =
        addChoice(menu, nullptr, "actionOrthographic", tr("Ort&hographic"), Qt::Key_5, "ortho", [] {});
    connect(flat, &QAction::toggled, this, [this](bool on) { m_fabric->setOrthographic(on); });
    addAction(menu, "actionFit", tr("Fit the fa&bric"), Qt::Key_F, "fit", [this] { m_comparison->fit(); });
    addAction(menu, "actionCentre", tr("&Centre on the selection"), Qt::Key_C, {}, [this] {
        if (m_fabric->selection() >= 0) {
            m_fabric->centreOn(m_fabric->selection());
        }
    });
    addAction(menu, "actionNearer", tr("Zoom &in"), QKeySequence::ZoomIn, {},
              [this] { m_fabric->zoomBy(1.25); });
    addAction(menu, "actionFarther", tr("Zoom o&ut"), QKeySequence::ZoomOut, {},
              [this] { m_fabric->zoomBy(0.8); });
    addAction(menu, "actionFitChart", tr("Fit the &pattern grid"), Qt::CTRL | Qt::SHIFT | Qt::Key_F, {},
              [this] { shownChart()->fitChart(); });
    menu->addSeparator();
    auto* styles = new QActionGroup(this);
    addChoice(menu, styles, "actionStyleYarn", tr("Lit &yarn"), Qt::ALT | Qt::Key_1, "style-yarn",
              [this] { m_fabric->setStyle(DrawStyle::Yarn); });
    addChoice(menu, styles, "actionStyleStrokes", tr("Three &strokes"), Qt::ALT | Qt::Key_2, "style-strokes",
              [this] { m_fabric->setStyle(DrawStyle::Strokes); });
    addChoice(menu, styles, "actionStyleMesh", tr("Bonding points and &mesh"), Qt::ALT | Qt::Key_3,
              "style-mesh", [this] { m_fabric->setStyle(DrawStyle::Mesh); });
    QAction* hair = addChoice(menu, nullptr, "actionHair", tr("Fu&zz of hairy yarn"), Qt::Key_Z, {}, [] {});
    hair->setToolTip(tr("Loose fibres around hairy yarn, seen near by (Z)"));
    connect(hair, &QAction::toggled, this, [this](bool on) { m_fabric->setHair(on); });
    buildDetailMenu(menu);
    auto* colours = new QActionGroup(this);
    colours->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    QAction* tension =
        addChoice(menu, colours, "actionTension", tr("Yarn &tension as colour"), Qt::Key_T, {}, [] {});
    QAction* contact = addChoice(menu, colours, "actionContact", tr("Contact force as colour"),
                                 Qt::SHIFT | Qt::Key_T, {}, [] {});
    contact->setToolTip(tr("How hard other yarn presses, when settled as yarn (Shift+T)"));
    QAction* speed = addChoice(menu, colours, "actionSpeed", tr("Speed of settling as colour"),
                               Qt::CTRL | Qt::SHIFT | Qt::Key_Y, {}, [] {});
    speed->setToolTip(tr("How far the yarn has moved since the last picture (Ctrl+Shift+Y)"));
    connect(colours, &QActionGroup::triggered, this, [this, tension, contact, speed] {
        m_fabric->setColourBy(tension->isChecked()   ? render::ColourBy::Tension
                              : speed->isChecked()   ? render::ColourBy::Speed
                              : contact->isChecked() ? render::ColourBy::Contact
                                                     : render::ColourBy::Yarn);
    });
    QAction* history = addChoice(menu, nullptr, "actionHistory", tr("H&istory of the selected bonding point"),
                                 Qt::Key_H, {}, [] {});
    connect(history, &QAction::toggled, this, [this](bool on) { m_history->setSwitchedOn(on); });
    buildOverlayMenu(menu);
    buildCompareMenu(menu);
    buildViewsMenu(menu);
    buildPhotographMenu(menu);
    menu->addSeparator();
    QAction* beds = m_bedDock->toggleViewAction();
    beds->setObjectName(QStringLiteral("actionNeedleBeds"));
    beds->setShortcut(Qt::Key_N);
    beds->setToolTip(tr("Shows the needle beds while they work (N)"));
    menu->addAction(beds);
    connect(beds, &QAction::triggered, this, [this](bool on) {
        if (on) {
            m_bedDock->raise();
        }
    });
    addAction(menu, "actionFollowNeedle", tr("Follo&w the working needle"), Qt::SHIFT | Qt::Key_N, {},
              [this] { m_beds->follow(); });
    menu->addSeparator();
    buildLanguageMenu(menu);
    QMenu* appearance = menu->addMenu(tr("&Appearance"));
    auto* looks = new QActionGroup(this);
    const std::initializer_list<std::tuple<const char*, QString, Appearance>> choices{
        {"actionSystemLook", tr("As the &system"), Appearance::System},
        {"actionLight", tr("&Light"), Appearance::Light},
        {"actionDark", tr("&Dark"), Appearance::Dark}};
    for (const auto& [name, text, value] : choices) {
        QAction* action =
            addChoice(appearance, looks, name, text, {}, {}, [this, value = value] { setAppearance(value); });
        action->setChecked(m_session.appearance() == value);
    }
    QAction* full = addChoice(menu, nullptr, "actionFullScreen", tr("F&ull screen"), Qt::Key_F11, {}, [] {});
    connect(full, &QAction::toggled, this, [this](bool on) { on ? showFullScreen() : showNormal(); });
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

void MainWindow::buildToolBar() {
    m_toolBar = addToolBar(tr("Tools"));
    m_toolBar->setObjectName(QStringLiteral("toolBar"));
    m_toolBar->setMovable(false);
    m_toolBar->setIconSize({20, 20});
    m_toolBar->setContextMenuPolicy(Qt::PreventContextMenu);
    const auto add = [this](std::initializer_list<const char*> names) {
        for (const char* name : names) {
            m_toolBar->addAction(findChild<QAction*>(QString::fromLatin1(name)));
        }
        m_toolBar->addSeparator();
    };
    for (const char* name : {"actionNew", "actionOpen", "actionSave"}) {
        m_toolBar->addAction(findChild<QAction*>(QString::fromLatin1(name)));
    }
    auto* samples = new QToolButton(m_toolBar);
    samples->setIcon(icon(QStringLiteral("samples")));
    samples->setToolTip(tr("Samples"));
    samples->setAccessibleName(tr("Samples"));
    samples->setMenu(findChild<QMenu*>(QStringLiteral("sampleMenu")));
    samples->setPopupMode(QToolButton::InstantPopup);
    m_toolBar->addWidget(samples);
    add({"actionExport"});
    add({"actionUndo", "actionRedo"});
    add({"actionFit", "actionFront", "actionBack", "actionTop", "actionOrthographic"});
    add({"actionStyleYarn", "actionStyleStrokes", "actionStyleMesh"});
    for (const char* name : {"actionRun", "actionRestart", "actionDrag"}) {
        m_toolBar->addAction(findChild<QAction*>(QString::fromLatin1(name)));
    }

    auto* stretch = new QWidget(m_toolBar);
    stretch->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    m_toolBar->addWidget(stretch);
    m_machine = new MachineChoice(m_document, m_toolBar);
    connect(m_machine, &MachineChoice::addWanted, this, &MainWindow::chooseMachineFile);
    m_toolBar->addWidget(m_machine);
    m_problemButton = new QToolButton(m_toolBar);
    m_problemButton->setObjectName(QStringLiteral("problemButton"));
    m_problemButton->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_problemButton->setToolTip(tr("Shows the list of problems"));
    connect(m_problemButton, &QToolButton::clicked, m_problemDock->toggleViewAction(), &QAction::trigger);
    m_toolBar->addWidget(m_problemButton);
}

void MainWindow::takeRecentFiles() {
    m_recentMenu->clear();
    const QStringList files = m_session.recentFiles();
    for (const QString& path : files) {
        QAction* action =
            m_recentMenu->addAction(QFileInfo(path).fileName(), this, [this, path] { openFile(path); });
        action->setToolTip(path);
        action->setStatusTip(path);
        if (const QPixmap picture = thumbnailOf(path); !picture.isNull()) {
            action->setIcon(picture);
        }
    }
    m_recentMenu->setEnabled(!files.isEmpty());
    if (!files.isEmpty()) {
        m_recentMenu->addSeparator();
        m_recentMenu->addAction(tr("&Forget these files"), this, [this] {
            m_session.clearRecentFiles();
            takeRecentFiles();
            m_gallery->setRecentFiles({});
        });
    }
}

void MainWindow::takeActions() {
    const bool open = m_document.file() != nullptr;
    for (const char* menu : {"machineMenu", "simulateMenu"}) {
        for (QAction* action : findChild<QMenu*>(QString::fromLatin1(menu))->actions()) {
            action->setEnabled(open);
        }
    }
    for (const char* name : {"actionStopNext", "actionStopBack"}) {
        findChild<QAction*>(QString::fromLatin1(name))->setEnabled(m_lesson->running());
    }
    for (const char* name : {"actionExport", "actionExportMachine", "actionFront", "actionBack", "actionLeft",
                             "actionRight", "actionTop", "actionBottom", "actionFit", "actionFitChart",
                             "actionCentre", "actionNearer", "actionFarther"}) {
        findChild<QAction*>(QString::fromLatin1(name))->setEnabled(open);
    }
    for (const char* name : {"actionSave", "actionSaveAs", "actionExportChart"}) {
        findChild<QAction*>(QString::fromLatin1(name))->setEnabled(m_document.project() != nullptr);
    }
    takeCompareActions();
    takePhotographActions();
    findChild<QAction*>(QStringLiteral("actionExportReport"))->setEnabled(open || m_document.failedFile());
    const bool running = m_document.activity() == document::Activity::Settling;
    QAction* run = findChild<QAction*>(QStringLiteral("actionRun"));
    run->setIcon(icon(running ? QStringLiteral("pause") : QStringLiteral("play")));
    run->setText(running ? tr("Pau&se") : tr("&Start"));
    run->setToolTip(running ? tr("Pause the simulation (F5)") : tr("Start the simulation (F5)"));
    const bool ladder = m_document.laddersRun();
    QAction* remove = findChild<QAction*>(QStringLiteral("actionRemoveLadders"));
    remove->setText(ladder ? tr("Skip to the end of the &ladder") : tr("Remove &ladders"));
    remove->setToolTip(removeLaddersHelp());
    QAction* holder = findChild<QAction*>(QStringLiteral("actionStitchHolder"));
    holder->setChecked(m_document.stitchHolder());
    holder->setEnabled(open && !ladder);
    const DrawStyle style = m_fabric->style();
    findChild<QAction*>(style == DrawStyle::Yarn      ? QStringLiteral("actionStyleYarn")
                        : style == DrawStyle::Strokes ? QStringLiteral("actionStyleStrokes")
                                                      : QStringLiteral("actionStyleMesh"))
        ->setChecked(true);
    const std::initializer_list<std::pair<const char*, bool>> overlays{
        {"actionHair", m_fabric->hasHair()},
        {"actionLegend", m_fabric->hasLegend()},
        {"actionDimensions", m_fabric->hasDimensions()},
        {"actionMarks", m_fabric->hasProblemMarks()},
        {"actionGuides", m_fabric->hasGuides()},
        {"actionTape", m_fabric->isTaping()},
        {"actionSection", m_fabric->section().has_value()},
        {"actionYarnAlone", m_fabric->alone() == FabricView::Alone::Yarn},
        {"actionCourseAlone", m_fabric->alone() == FabricView::Alone::Course}};
    for (const auto& [name, on] : overlays) {
        findChild<QAction*>(QString::fromLatin1(name))->setChecked(on);
    }
    findChild<QAction*>(m_layout == Layout::Teaching   ? QStringLiteral("actionLayoutTeaching")
                        : m_layout == Layout::Checking ? QStringLiteral("actionLayoutChecking")
                                                       : QStringLiteral("actionLayoutStandard"))
        ->setChecked(true);
    findChild<QAction*>(QStringLiteral("actionHistory"))->setChecked(m_history->isSwitchedOn());
    findChild<QAction*>(QStringLiteral("actionOrthographic"))->setChecked(m_fabric->isOrthographic());
    const Diagnostics& found = m_document.problems();
    const std::size_t problems = problemCount(found);
    const std::size_t notes = found.size() - problems;
    m_problemButton->setText(found.empty()   ? tr("No problems")
                             : problems == 1 ? tr("1 problem")
                             : problems > 1  ? tr("%1 problems").arg(problems)
                             : notes == 1    ? tr("1 note")
                                             : tr("%1 notes").arg(notes));
    m_problemButton->setIcon(severityIcon(hasErrors(found) ? Severity::Error
                                          : problems > 0   ? Severity::Warning
                                                           : Severity::Info));
    m_problemButton->setEnabled(!found.empty());
}

} // namespace knittsim::ui
