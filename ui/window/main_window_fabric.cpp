#include "ui/dialogs/export_dialog.h"
#include "ui/document/operation_text.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/views/history/history_card.h"
#include "ui/views/pattern_editor/pattern_grid.h"
#include "ui/views/simulation_panel/activity_text.h"
#include "ui/views/style/appearance.h"
#include "ui/window/banner.h"
#include "ui/window/carrier_looks.h"
#include "ui/window/comparison.h"
#include "ui/window/main_window.h"
#include "ui/window/status_line.h"

#include <QAction>
#include <QFileInfo>
#include <QLocale>
#include <QMenu>
#include <QStatusBar>

#include <algorithm>
#include <utility>

namespace knittsim::ui {

void MainWindow::connectFabric() {
    using document::Document;
    connect(&m_document, &Document::frameShown, this, [this] {
        takeFrame();
        m_status->setRenderer(m_fabric->hasOpenGl() ? m_fabric->rendererName() : tr("Qt, flat"));
    });
    connect(&m_document, &Document::yarnRunChanged, this, &MainWindow::takeYarnRun);
    for (const auto signal :
         {&Document::chartFollowed, &Document::yarnRunChanged, &Document::activityChanged}) {
        connect(&m_document, signal, this, &MainWindow::takeNotice);
    }
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

void MainWindow::takeFrame() {
    m_fabric->setFollowing(m_layout == Layout::Teaching ||
                           (m_document.step() == m_document.operationCount() && !m_document.laddersRun()));
    m_fabric->setNeedles(m_document.needleHooks());
    m_fabric->setFrame(m_document.shownFrame());
    takeYarnRun();
}

/// What is out of date says so.
void MainWindow::takeNotice() {
    const bool behind = m_document.project() && !m_document.fabricFollowsChart();
    m_fabric->setNotice(behind                    ? tr("out of date: the chart has changed")
                        : m_document.awaitsYarn() ? tr("preview: the yarn has not settled yet")
                                                  : QString());
}

void MainWindow::takePins() {
    m_fabric->setPins(m_document.pins());
}

void MainWindow::takeYarnRun() {
    m_fabric->setYarn(m_document.showsYarn() ? m_document.yarnRun().shape()->picture : nullptr);
}

void MainWindow::takeDescription() {
    const auto file = m_document.file();
    m_fabric->setAccessibleDescription(file ? tr("%1 columns, %2 courses, %3, %4 problems")
                                                  .arg(file->grid->columnCount())
                                                  .arg(file->grid->courseCount())
                                                  .arg(activityWord(m_document))
                                                  .arg(m_document.problems().size())
                                            : QString());
}

void MainWindow::buildOverlayMenu(QMenu* view) {
    QMenu* menu = view->addMenu(tr("&Overlays"));
    menu->setObjectName(QStringLiteral("overlayMenu"));
    const auto add = [&](const char* name, const QString& text, const QKeySequence& keys, auto set) {
        QAction* action = addChoice(menu, nullptr, name, text, keys, {}, [] {});
        connect(action, &QAction::toggled, this, [this, set](bool on) { (m_fabric->*set)(on); });
    };
    add("actionLegend", tr("Legend of the &mesh"), Qt::ALT | Qt::Key_4, &FabricView::setLegend);
    add("actionDimensions", tr("&Dimensions and gauge"), Qt::ALT | Qt::Key_5, &FabricView::setDimensions);
    add("actionMarks", tr("Signs at &problems"), Qt::ALT | Qt::Key_6, &FabricView::setProblemMarks);
    add("actionGuides", tr("&Lines along courses and wales"), Qt::Key_G, &FabricView::setGuides);
    add("actionSection", tr("&Section parallel to the picture"), Qt::Key_X, &FabricView::setSection);
    add("actionTape", tr("Measuring &tape"), Qt::Key_M, &FabricView::setTaping);
    menu->addSeparator();
    const auto addAlone = [&](const char* name, const QString& text, const QKeySequence& keys,
                              FabricView::Alone what) {
        QAction* action = addChoice(menu, nullptr, name, text, keys, {}, [this, what] {
            const bool again = m_fabric->alone() == what;
            if (!m_fabric->showAlone(again ? FabricView::Alone::Nothing : what)) {
                statusBar()->showMessage(tr("Select a stitch first, or point at one"), 5000);
            }
            takeActions();
        });
        action->setToolTip(tr("%1: hides all but that of the selected stitch").arg(action->toolTip()));
    };
    addAlone("actionYarnAlone", tr("Only this &yarn"), Qt::Key_I, FabricView::Alone::Yarn);
    addAlone("actionCourseAlone", tr("Only this &course"), Qt::SHIFT | Qt::Key_I, FabricView::Alone::Course);
}

/// Signs at the stitches that have problems.
void MainWindow::markProblems() {
    std::vector<LoopProblem> marks;
    for (const auto& [loop, problem] : m_document.problemMarks()) {
        marks.push_back({static_cast<int>(loop), problem.severity});
    }
    m_fabric->setProblems(std::move(marks));
}

QString MainWindow::describeLoop(int loop) const {
    const auto file = m_document.file();
    const auto& loops = file->timeline->loops();
    if (static_cast<std::size_t>(loop) >= loops.loops.size()) {
        return {};
    }
    const machine::Loop& made = loops.loops[static_cast<std::size_t>(loop)];
    const auto& carriers = m_document.carriers();
    return document::stitchText(file->timeline->program(), loops, *file->grid, loop) + u'\n' +
           tr("%1, %2 mm of yarn in the loop")
               .arg(made.carrier < carriers.size() ? QString::fromStdString(carriers[made.carrier].yarn.name)
                                                   : QString(),
                    QLocale().toString(made.lengthMm, 'f', 2));
}

void MainWindow::exportShown() {
    ExportSource source;
    source.fabric = m_document.shownFabric();
    if (!source.fabric) {
        return;
    }
    if (m_document.showsYarn()) {
        const auto picture = m_document.yarnRun().shape()->picture;
        source.curves = {picture, &picture->curves};
        source.surroundings = m_document.yarnRun().surroundings();
        source.places = picture->positions;
    } else if (const auto frame = m_document.shownFrame()) {
        source.places = frame->positions;
    }
    source.yarns = machine::yarnsOf(m_document.carriers());
    source.style = m_fabric->style();
    source.camera = m_fabric->cameraState();
    source.section = m_fabric->section();
    source.keep = m_fabric->shownPoints();
    source.parts = m_fabric->shownPart();
    source.hair = m_fabric->hasHair();
    source.level = m_fabric->detail();
    source.dark = isDark(palette());
    const QString name = QFileInfo(m_document.title()).completeBaseName();
    auto* dialog =
        new ExportDialog(std::move(source), m_session.lastFolder() + u'/' + name, m_fabric->size(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &ExportDialog::written, this, [this](const QString& path) {
        m_session.setLastFolder(QFileInfo(path).absolutePath());
        statusBar()->showMessage(tr("Written to %1").arg(path), 5000);
    });
    dialog->open();
}

} // namespace knittsim::ui
