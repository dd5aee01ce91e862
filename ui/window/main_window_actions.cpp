#include "ui/views/diagnostics/diagnostics_model.h"
#include "ui/views/diagnostics/diagnostics_panel.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/views/history/history_card.h"
#include "ui/views/lesson/lesson_panel.h"
#include "ui/views/simulation_panel/ladder_text.h"
#include "ui/views/style/icons.h"
#include "ui/window/gallery.h"
#include "ui/window/machine_choice.h"
#include "ui/window/main_window.h"
#include "ui/window/sample_thumbnail.h"

#include <QActionGroup>
#include <QDockWidget>
#include <QFileInfo>
#include <QMenu>
#include <QToolBar>
#include <QToolButton>

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
