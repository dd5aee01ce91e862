// The part of the main window that makes and shows charts.

#include "ui/dialogs/picture_dialog.h"
#include "ui/document/message_text.h"
#include "ui/views/chart_editor/chart_canvas.h"
#include "ui/views/chart_editor/chart_editor.h"
#include "ui/views/chart_editor/new_chart_dialog.h"
#include "ui/views/pattern_editor/pattern_grid.h"
#include "ui/views/yarn_library/colourway_bar.h"
#include "ui/window/banner.h"
#include "ui/window/main_window.h"

#include <QActionGroup>
#include <QFileInfo>
#include <QMenuBar>
#include <QStackedWidget>

namespace knittsim::ui {

void MainWindow::buildChartMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&Pattern"));
    menu->setObjectName(QStringLiteral("patternMenu"));
    QAction* lift = addAction(menu, "actionEditAsChart", tr("E&dit as chart"), Qt::CTRL | Qt::ALT | Qt::Key_C,
                              {}, [this] { m_document.editAsChart(); });
    lift->setToolTip(tr("Machine data becomes a chart that can be changed; what a chart cannot say is kept"));
    lift->setEnabled(false);
    menu->addSeparator();
    m_chart->addTo(menu);
    addAction(menu, "actionNextColourway", tr("Ne&xt colourway"), Qt::CTRL | Qt::ALT | Qt::Key_W, {},
              [this] { findChild<ColourwayBar*>(QStringLiteral("colourways"))->useNext(); });
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
    m_chart->setUsable(chart);
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

} // namespace knittsim::ui
