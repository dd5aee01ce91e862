#include "ui/views/chart_editor/chart_editor.h"

#include "core/pattern/chart_edit.h"
#include "ui/document/message_text.h"
#include "ui/views/chart_editor/chart_canvas.h"
#include "ui/views/chart_editor/colour_method_menu.h"
#include "ui/views/chart_editor/own_module_dialogs.h"
#include "ui/views/chart_editor/palettes.h"
#include "ui/views/chart_editor/stitch_picture.h"
#include "ui/views/style/appearance.h"
#include "ui/views/style/icons.h"

#include <QActionGroup>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace knittsim::ui {

ChartEditor::ChartEditor(document::Document& document, ChartLook& look, QWidget* parent)
    : QWidget(parent), m_document(document), m_canvas(new ChartCanvas(document, look, this)),
      m_stitches(new StitchPalette(look, this)), m_yarns(new YarnPalette(document, this)),
      m_catalogue(new CataloguePopup(look, this)), m_tools(new QToolBar(this)),
      m_toolGroup(new QActionGroup(this)), m_toolHint(new QLabel(this)), m_hint(new QLabel(this)),
      m_brushMenu(new QMenu(tr("Stitch and &yarn to draw with"), this)),
      m_directionMenu(new QMenu(tr("Shi&ft, move and repeat"), this)) {
    setObjectName(QStringLiteral("chartEditor"));
    m_tools->setIconSize({18, 18});
    buildTools();
    buildEdits();
    buildCourseEdits();
    buildDirections();
    buildBrushMenu();
    auto* palettes = new QHBoxLayout;
    palettes->setContentsMargins(6, 0, 6, 2);
    palettes->addWidget(m_stitches);
    palettes->addSpacing(8);
    palettes->addWidget(m_yarns, 1);
    m_toolHint->setObjectName(QStringLiteral("chartToolHint"));
    m_hint->setObjectName(QStringLiteral("chartHint"));
    for (QLabel* line : {m_toolHint, m_hint}) {
        line->setTextFormat(Qt::PlainText);
        line->setMinimumWidth(0);
        line->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        line->setWordWrap(true);
    }
    m_toolHint->setContentsMargins(8, 3, 8, 0);
    m_hint->setContentsMargins(8, 1, 8, 4);
    // Its room stays: cells must not move below the pointer when its text comes and goes.
    m_hint->setFixedHeight(2 * m_hint->fontMetrics().lineSpacing() + 5);
    m_hint->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(m_tools);
    rows->addLayout(palettes);
    rows->addWidget(m_canvas, 1);
    rows->addWidget(m_toolHint);
    rows->addWidget(m_hint);
    setFocusProxy(m_canvas);

    connect(m_stitches, &StitchPalette::changed, this, &ChartEditor::takeStitch);
    connect(m_yarns, &YarnPalette::changed, this, &ChartEditor::takeYarn);
    connect(m_canvas, &ChartCanvas::toolChanged, this, &ChartEditor::takeToolHint);
    connect(m_canvas, &ChartCanvas::picked, this, [this](pattern::Cell cell) {
        m_stitches->choose(cell.stitch);
        m_yarns->choose(cell.yarn);
        takeBrush();
    });
    connect(m_catalogue, &CataloguePopup::chosen, this, [this](const pattern::Module* module) {
        m_canvas->setModule(module);
        m_canvas->setTool(ChartTool::Stamp);
        m_canvas->setFocus();
    });
    connect(m_catalogue, &CataloguePopup::problemFound, m_hint, &QLabel::setText);
    connect(m_canvas, &ChartCanvas::hovered, m_hint, &QLabel::setText);
    connect(&m_document, &document::Document::chartFollowed, this, &ChartEditor::takeFollowing);
    connect(&m_document, &document::Document::chartChanged, this, &ChartEditor::takeBeds);
    m_stitches->choose(pattern::Stitch::Purl);
    takeBeds();
    takeBrush();
}

void ChartEditor::takeBeds() {
    const auto project = m_document.project();
    const bool both = project && project->chart.beds == pattern::BedUse::Double;
    m_stitches->setTwoBeds(both);
    m_beds->setChecked(both);
}

/// Who chooses a stitch draws stitches, who chooses a yarn colours; with Shift both.
void ChartEditor::takeStitch() {
    if (!QGuiApplication::keyboardModifiers().testFlag(Qt::ShiftModifier)) {
        m_yarns->choose(std::nullopt);
    }
    takeBrush();
}

void ChartEditor::takeYarn() {
    if (!QGuiApplication::keyboardModifiers().testFlag(Qt::ShiftModifier)) {
        m_stitches->choose(std::nullopt);
    }
    takeBrush();
}

void ChartEditor::takeBrush() {
    if (!m_stitches->chosen() && !m_yarns->chosen()) { // what was chosen was clicked again
        m_stitches->choose(m_canvas->brush().stitch);
        m_yarns->choose(m_canvas->brush().yarn);
    }
    m_canvas->setBrush({m_stitches->chosen(), m_yarns->chosen()});
    takeToolHint();
}

QString ChartEditor::brushText() const {
    const auto stitch = m_stitches->chosen();
    const auto yarn = m_yarns->chosen();
    const auto project = m_document.project();
    const QString name = stitch ? stitchName(*stitch).section(u':', 0, 0) : QString();
    const QString carrier = yarn && project && *yarn < project->chart.yarns.size()
                                ? QString::fromStdString(project->chart.yarns[*yarn].carrier)
                                : QString();
    return carrier.isEmpty() ? tr("%1; the yarns stay").arg(name)
           : name.isEmpty()  ? tr("yarn of carrier %1; the stitches stay").arg(carrier)
                             : tr("%1 with the yarn of carrier %2").arg(name, carrier);
}

void ChartEditor::takeToolHint() {
    QString text;
    switch (m_canvas->tool()) {
    case ChartTool::Select:
        text = tr("Select: drag over cells. Drag the selection to move it, its edge to repeat it.");
        break;
    case ChartTool::Pencil:
        text = tr("Pencil: %1").arg(brushText());
        break;
    case ChartTool::Line:
        text = tr("Line: %1").arg(brushText());
        break;
    case ChartTool::Rectangle:
        text = tr("Rectangle: %1").arg(brushText());
        break;
    case ChartTool::Fill:
        text = tr("Fill: %1").arg(brushText());
        break;
    case ChartTool::Stamp:
        text = m_canvas->module() ? tr("%1: a click lays it down, a drag repeats it.")
                                        .arg(QString::fromStdString(m_canvas->module()->name))
                                  : tr("Choose a stitch of the catalogue (Shift+B).");
        break;
    }
    m_toolHint->setText(text);
    m_toolHint->setToolTip(text);
}

/// What is out of date says so.
void ChartEditor::takeFollowing() {
    const bool failed = !m_document.isRebuilding() && !m_document.fabricFollowsChart();
    if (m_document.isRebuilding()) {
        m_hint->setText(tr("The fabric follows\u2026"));
    } else if (failed && !m_document.problems().empty()) {
        m_hint->setText(
            tr("The fabric is out of date: %1").arg(document::causeText(m_document.problems().front())));
    } else {
        m_hint->clear();
    }
    QPalette colours = palette();
    if (failed) {
        colours.setColor(QPalette::WindowText, accentsOf(palette()).error);
    }
    m_hint->setPalette(colours);
}

QAction* ChartEditor::addTool(int tool, const QString& name, const QString& text, const QKeySequence& key,
                              const QString& iconName) {
    auto* action = new QAction(icon(iconName), text, this);
    action->setObjectName(name);
    action->setCheckable(true);
    action->setShortcut(key);
    action->setToolTip(QStringLiteral("%1 (%2)").arg(text, key.toString(QKeySequence::NativeText)));
    m_toolGroup->addAction(action);
    m_toolActions << action;
    const auto value = static_cast<ChartTool>(tool);
    connect(action, &QAction::triggered, this, [this, value] {
        m_canvas->setTool(value);
        m_canvas->setFocus();
    });
    connect(m_canvas, &ChartCanvas::toolChanged, action,
            [this, action, value] { action->setChecked(m_canvas->tool() == value); });
    action->setChecked(m_canvas->tool() == value);
    m_tools->addAction(action);
    return action;
}

void ChartEditor::buildTools() {
    const auto add = [this](ChartTool tool, const char* name, const QString& text, Qt::Key key,
                            const char* iconName) {
        return addTool(static_cast<int>(tool), QString::fromUtf8(name), text, key,
                       QString::fromUtf8(iconName));
    };
    add(ChartTool::Select, "actionChartSelect", tr("Select"), Qt::Key_S, "select");
    add(ChartTool::Pencil, "actionChartPencil", tr("Pencil"), Qt::Key_B, "pencil");
    add(ChartTool::Line, "actionChartLine", tr("Line"), Qt::Key_L, "line");
    add(ChartTool::Rectangle, "actionChartRectangle", tr("Rectangle"), Qt::Key_U, "rectangle");
    add(ChartTool::Fill, "actionChartFill", tr("Fill"), Qt::Key_K, "fill");
    m_tools->addSeparator();
    QAction* stamp = addTool(static_cast<int>(ChartTool::Stamp), QStringLiteral("actionChartStamp"),
                             tr("Stitch catalogue"), Qt::SHIFT | Qt::Key_B, QStringLiteral("samples"));
    auto* button = qobject_cast<QToolButton*>(m_tools->widgetForAction(stamp));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    connect(stamp, &QAction::triggered, this, [this, button] {
        const QWidget* at = button->isVisible() ? static_cast<QWidget*>(button) : this;
        m_catalogue->popup(at->mapToGlobal(QPoint(0, at == this ? 0 : at->height())));
    });
}

QAction* ChartEditor::addEdit(const QString& name, const QString& text, const QKeySequence& key,
                              const std::function<void()>& action, QMenu* menu) {
    auto* made = new QAction(text, this);
    made->setObjectName(name);
    made->setShortcut(key);
    made->setShortcutContext(Qt::WidgetWithChildrenShortcut); // other views copy and paste, too
    addAction(made);
    m_editActions << made;
    if (menu) {
        menu->addAction(made);
    }
    connect(made, &QAction::triggered, this, action);
    return made;
}

void ChartEditor::addTo(QMenu* menu) const {
    menu->addActions(m_toolActions);
    menu->addMenu(m_brushMenu);
    menu->addSeparator();
    const QList<QAction*> brushes = m_brushMenu->actions();
    const QList<QAction*> directions = m_directionMenu->actions();
    for (QAction* action : m_editActions) {
        if (!brushes.contains(action) && !directions.contains(action)) {
            menu->addAction(action);
        }
    }
    menu->addMenu(m_directionMenu);
}

void ChartEditor::setUsable(bool on) {
    for (QAction* action : m_toolActions + m_editActions) {
        action->setEnabled(on);
    }
}

void ChartEditor::buildBrushMenu() {
    const auto add = [this](const char* name, const QString& text, const QKeySequence& key,
                            const std::function<void()>& action) {
        addEdit(QString::fromUtf8(name), text, key, action, m_brushMenu)
            ->setShortcutContext(Qt::WindowShortcut); // as the tools
    };
    add("actionChartNextStitch", tr("&Next stitch"), Qt::Key_E, [this] { m_stitches->step(+1); });
    add("actionChartPreviousStitch", tr("&Previous stitch"), Qt::SHIFT | Qt::Key_E, [this] {
        m_stitches->step(-1);
        m_yarns->choose(std::nullopt); // Shift is in the key, not held for both
        takeBrush();
    });
    add("actionChartNextYarn", tr("Next &yarn"), Qt::Key_O, [this] { m_yarns->step(+1); });
    add("actionChartPreviousYarn", tr("Previous y&arn"), Qt::SHIFT | Qt::Key_O, [this] {
        m_yarns->step(-1);
        m_stitches->choose(std::nullopt);
        takeBrush();
    });
    add("actionChartPick", tr("P&ick both under the cursor"), Qt::Key_Q, [this] { m_canvas->pick(); });
    add("actionChartAddYarn", tr("A&dd a yarn"), Qt::CTRL | Qt::ALT | Qt::Key_Y,
        [this] { m_yarns->addYarn(); });
}

void ChartEditor::buildDirections() {
    struct Direction {
        const char* name;
        QString text;
        Qt::Key key;
        int wales;
        int courses;
    };
    const Direction kAll[] = {{"Left", tr("to the left"), Qt::Key_Left, -1, 0},
                              {"Right", tr("to the right"), Qt::Key_Right, +1, 0},
                              {"Up", tr("upwards"), Qt::Key_Up, 0, +1},
                              {"Down", tr("downwards"), Qt::Key_Down, 0, -1}};
    struct Way {
        const char* name;
        QString text;
        Qt::KeyboardModifiers keys;
        void (ChartCanvas::*change)(int, int);
    };
    const Way kWays[] = {{"Shift", tr("Shift %1"), Qt::ControlModifier, &ChartCanvas::shift},
                         {"Move", tr("Move the selection %1"), Qt::AltModifier, &ChartCanvas::moveSelected},
                         {"Repeat", tr("Repeat the selection %1"), Qt::ControlModifier | Qt::ShiftModifier,
                          &ChartCanvas::repeatBy}};
    for (const Way& way : kWays) {
        for (const Direction& to : kAll) {
            addEdit(
                QStringLiteral("actionChart%1%2").arg(QLatin1String(way.name), QLatin1String(to.name)),
                way.text.arg(to.text), QKeySequence(QKeyCombination(way.keys, to.key)),
                [this, change = way.change, to] { (m_canvas->*change)(to.wales, to.courses); },
                m_directionMenu);
        }
        m_directionMenu->addSeparator();
    }
}

void ChartEditor::buildEdits() {
    ChartCanvas* canvas = m_canvas;
    addEdit("actionChartCut", tr("Cu&t"), QKeySequence::Cut, [canvas] { canvas->cut(); });
    addEdit("actionChartCopy", tr("&Copy"), QKeySequence::Copy, [canvas] { canvas->copy(); });
    addEdit("actionChartPaste", tr("&Paste"), QKeySequence::Paste, [canvas] { canvas->paste(); });
    addEdit("actionChartClear", tr("C&lear"), QKeySequence::Delete, [canvas] { canvas->clearSelected(); });
    addEdit("actionChartAll", tr("Select &all"), QKeySequence::SelectAll, [canvas] { canvas->selectAll(); });
    addEdit("actionChartMirror", tr("&Mirror left and right"), Qt::CTRL | Qt::Key_M,
            [canvas] { canvas->mirror(pattern::Mirror::LeftRight); });
    addEdit("actionChartMirrorUp", tr("Mirror &up and down"), Qt::CTRL | Qt::SHIFT | Qt::Key_M,
            [canvas] { canvas->mirror(pattern::Mirror::UpDown); });
    addEdit("actionChartRotate", tr("&Rotate a square selection"), Qt::CTRL | Qt::Key_R,
            [canvas] { canvas->rotate(); });
    addEdit("actionChartRepeat", tr("R&epeat the selection over the chart"), Qt::CTRL | Qt::Key_T,
            [canvas] { canvas->repeat(); });
    addEdit("actionChartSaveModule", tr("Save the selection as a m&odule\u2026"),
            Qt::CTRL | Qt::SHIFT | Qt::Key_B, [this] {
                const auto project = m_document.project();
                if (m_canvas->selection().empty()) {
                    m_hint->setText(tr("Select the stitches of the module first."));
                } else if (project &&
                           saveAsOwnModule(this, pattern::copyOf(project->chart, m_canvas->selection()))) {
                    m_hint->setText(tr("The module stands at the end of the stitch catalogue."));
                }
            });
}

/// What is done with whole courses and wales.
void ChartEditor::buildCourseEdits() {
    ChartCanvas* canvas = m_canvas;
    addEdit("actionChartInsertCourses", tr("&Insert courses"), Qt::CTRL | Qt::Key_I,
            [canvas] { canvas->insertCourses(); });
    addEdit("actionChartRemoveCourses", tr("Remo&ve courses"), Qt::CTRL | Qt::SHIFT | Qt::Key_I,
            [canvas] { canvas->removeCourses(); });
    addEdit("actionChartInsertWales", tr("Insert &wales"), Qt::CTRL | Qt::Key_J,
            [canvas] { canvas->insertWales(); });
    addEdit("actionChartRemoveWales", tr("Remove wale&s"), Qt::CTRL | Qt::SHIFT | Qt::Key_J,
            [canvas] { canvas->removeWales(); });
    addEdit("actionChartBindOff", tr("&Bind off above the chart"), Qt::CTRL | Qt::ALT | Qt::Key_O, [this] {
        bool done = false;
        m_document.editChart(tr("bind off"), [&](pattern::Chart& chart) { done = pattern::bindOff(chart); });
        if (!done) {
            m_hint->setText(tr("Only a chart on one bed, with two loops or more, can be bound off."));
        }
    });
    addEdit("actionChartCourseYarn", tr("&Yarn of the course\u2026"), Qt::CTRL | Qt::Key_U,
            [canvas] { canvas->chooseCourseYarn(); });
    addEdit("actionChartColours", tr("&Knitting of the colours\u2026"), Qt::CTRL | Qt::ALT | Qt::Key_U,
            [canvas] { canvas->chooseColourMethod(); });
    QAction* colours = m_editActions.back();
    colours->setIcon(colourMethodIcon(pattern::ColourMethod::Birdseye, *this));
    colours->setToolTip(tr("How the colours are knitted: floats, intarsia, a birdseye or ladder back (%1)")
                            .arg(colours->shortcut().toString(QKeySequence::NativeText)));
    m_tools->addSeparator();
    colours->setIconText(tr("Colours"));
    m_tools->addAction(colours);
    auto* button = qobject_cast<QToolButton*>(m_tools->widgetForAction(colours));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setIconSize({40, 18});
    addEdit("actionChartBeds", tr("Work on bot&h beds"), Qt::CTRL | Qt::ALT | Qt::Key_B, [canvas, this] {
        canvas->useBothBeds(m_beds->isChecked());
        takeBeds(); // it may be refused
    });
    m_beds = m_editActions.back();
    m_beds->setCheckable(true);
    addEdit("actionChartStitchSize", tr("Stitch si&ze of the course\u2026"), Qt::CTRL | Qt::ALT | Qt::Key_G,
            [canvas] { canvas->editStitchSize(); });
    addEdit("actionChartRacking", tr("Rackin&g of the course\u2026"), Qt::CTRL | Qt::SHIFT | Qt::Key_G,
            [canvas] { canvas->editRacking(); });
}

} // namespace knittsim::ui
