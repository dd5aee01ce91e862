#include "ui/views/chart_editor/chart_editor.h"

#include "core/pattern/chart_edit.h"
#include "ui/document/message_text.h"
#include "ui/views/chart_editor/chart_canvas.h"
#include "ui/views/chart_editor/colour_method_menu.h"
#include "ui/views/chart_editor/own_module_dialogs.h"
#include "ui/views/chart_editor/palettes.h"
#include "ui/views/style/appearance.h"
#include "ui/views/style/icons.h"

#include <QActionGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace knittsim::ui {

ChartEditor::ChartEditor(document::Document& document, ChartLook& look, QWidget* parent)
    : QWidget(parent), m_document(document), m_canvas(new ChartCanvas(document, look, this)),
      m_stitches(new StitchPalette(look, this)), m_yarns(new YarnPalette(document, this)),
      m_catalogue(new CataloguePopup(look, this)), m_tools(new QToolBar(this)),
      m_toolGroup(new QActionGroup(this)), m_hint(new QLabel(this)) {
    setObjectName(QStringLiteral("chartEditor"));
    m_tools->setIconSize({18, 18});
    buildTools();
    buildEdits();
    auto* palettes = new QHBoxLayout;
    palettes->setContentsMargins(6, 0, 6, 2);
    palettes->addWidget(m_stitches);
    palettes->addSpacing(8);
    palettes->addWidget(m_yarns, 1);
    m_hint->setObjectName(QStringLiteral("chartHint"));
    m_hint->setContentsMargins(8, 2, 8, 4);
    m_hint->setTextFormat(Qt::PlainText);
    m_hint->setMinimumWidth(0);
    m_hint->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(m_tools);
    rows->addLayout(palettes);
    rows->addWidget(m_canvas, 1);
    rows->addWidget(m_hint);
    setFocusProxy(m_canvas);

    connect(m_stitches, &StitchPalette::changed, this, &ChartEditor::takeBrush);
    connect(m_yarns, &YarnPalette::changed, this, &ChartEditor::takeBrush);
    connect(m_canvas, &ChartCanvas::picked, this, [this](pattern::Cell cell) {
        m_stitches->choose(cell.stitch);
        m_yarns->choose(cell.yarn);
        takeBrush();
    });
    connect(m_catalogue, &CataloguePopup::chosen, this, [this](const pattern::Module* module) {
        m_canvas->setModule(module);
        m_canvas->setTool(ChartTool::Stamp);
        m_canvas->setFocus();
        m_hint->setText(tr("A click lays down %1, its lower left corner first; a drag repeats it.")
                            .arg(QString::fromStdString(module->name)));
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

void ChartEditor::takeBrush() {
    m_canvas->setBrush({m_stitches->chosen(), m_yarns->chosen()});
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

void ChartEditor::addEdit(const QString& name, const QString& text, const QKeySequence& key,
                          const std::function<void()>& action) {
    auto* made = new QAction(text, this);
    made->setObjectName(name);
    made->setShortcut(key);
    made->setShortcutContext(Qt::WidgetWithChildrenShortcut); // other views copy and paste, too
    addAction(made);
    m_editActions << made;
    connect(made, &QAction::triggered, this, action);
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
    qobject_cast<QToolButton*>(m_tools->widgetForAction(colours))
        ->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
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
