#include "ui/window/status_line.h"

#include "ui/document/operation_text.h"
#include "ui/views/simulation_panel/activity_text.h"
#include "ui/views/simulation_panel/ladder_text.h"
#include "ui/views/style/appearance.h"
#include "ui/views/style/numbers.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>

namespace knittsim::ui {

namespace {

const QString kNone = QStringLiteral("\u2013");

QString arrow(machine::Direction direction) {
    return direction == machine::Direction::Right ? QStringLiteral("\u2192") : QStringLiteral("\u2190");
}

} // namespace

StatusLine::StatusLine(document::Document& document, QWidget* parent)
    : QWidget(parent), m_document(document) {
    setObjectName(QStringLiteral("statusLine"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 0, 0, 0);
    row->setSpacing(14);
    m_needle = addField("statusNeedle", tr("Needle: f front bed, b rear bed"), tr("needle %1").arg("f8888"));
    m_course = addField("statusCourse", tr("Fabric course, counted from the first one knitted"),
                        tr("course %1").arg(888));
    m_rack =
        addField("statusRack", tr("Racking of the rear bed in needle pitches"), tr("rack %1").arg("+0.25"));
    m_carrier = addField("statusCarrier", tr("Yarn carrier and its direction"),
                         tr("carrier %1 %2").arg("10", "\u2192"));
    row->addStretch(1);
    m_state = addField("statusState", tr("What the simulation does"), {});
    m_stitches = addField("statusStitches", tr("Loops made up to the operation shown"), {});
    m_ladders =
        addField("statusLadders", tr("Loops that nothing holds: Remove ladders (Ctrl+L) lets them run"), {});
    m_energy = addField("statusEnergy", tr("Spring energy V of the fabric"), tr("V %1").arg("888 mJ"));
    m_time =
        addField("statusTime", tr("Computing time of one integrator step"), tr("%1 ms/step").arg("88.8"));
    m_detail = addField("statusDetail", {}, {});
    m_detail->hide();
    m_renderer = addField("statusRenderer", tr("What draws the fabric (OpenGL)"), {});
    connect(&m_document, &document::Document::stepChanged, this, &StatusLine::takePlace);
    connect(&m_document, &document::Document::selectionChanged, this, &StatusLine::takePlace);
    connect(&m_document, &document::Document::frameShown, this, &StatusLine::takeFrame);
    connect(&m_document, &document::Document::activityChanged, this, &StatusLine::takeFrame);
    connect(&m_document, &document::Document::yarnRunChanged, this, &StatusLine::takeFrame);
    connect(&m_document, &document::Document::ladderChanged, this, &StatusLine::takeLadders);
    takePlace();
    takeFrame();
    takeLadders();
}

QLabel* StatusLine::addField(const char* name, const QString& toolTip, const QString& widest) {
    auto* field = new QLabel(this);
    field->setObjectName(QString::fromLatin1(name));
    field->setToolTip(toolTip);
    if (!widest.isEmpty()) {
        field->setMinimumWidth(fontMetrics().horizontalAdvance(widest));
    }
    layout()->addWidget(field);
    return field;
}

void StatusLine::setHoveredLoop(int loop) {
    m_hovered = loop;
    takePlace();
}

void StatusLine::setRenderer(const QString& name) {
    if (name.isEmpty()) {
        return;
    }
    m_renderer->setToolTip(tr("Drawn by %1").arg(name));
    m_renderer->setText(name.section(u'(', 0, 0).trimmed().left(24));
}

void StatusLine::setDetail(const QString& level, bool fixed) {
    m_detail->setText(level);
    m_detail->setToolTip(fixed ? tr("Level of detail that you chose (View > Detail of the yarn)")
                               : tr("Level of detail drawn, chosen by the width of the yarn on the screen"));
    m_detail->setVisible(!level.isEmpty());
}

void StatusLine::showLoop(machine::LoopIndex loop) {
    const auto file = m_document.file();
    const machine::Loop& made = file->timeline->loops().loops[static_cast<std::size_t>(loop)];
    m_needle->setText(tr("needle %1").arg(QString::fromStdString(machine::toString(made.needle))));
    m_course->setText(tr("course %1").arg(file->grid->placeOf(loop).course + 1));
    m_rack->setText(tr("rack %1").arg(document::rackText(made.rack)));
    m_carrier->setText(
        tr("carrier %1 %2")
            .arg(document::carrierText(file->timeline->program(), {made.carrier}), arrow(made.direction)));
}

void StatusLine::showOperation(machine::OperationIndex operation) {
    const auto file = m_document.file();
    const auto& operations = file->timeline->program().operations;
    if (operation < 0) {
        return;
    }
    const machine::Operation& op = operations[static_cast<std::size_t>(operation)];
    const bool needle = machine::carriesYarn(op.kind) || op.kind == machine::OperationKind::Xfer ||
                        op.kind == machine::OperationKind::Drop;
    if (needle) {
        m_needle->setText(tr("needle %1").arg(QString::fromStdString(machine::toString(op.needle))));
    }
    if (!op.carriers.empty()) {
        m_carrier->setText(tr("carrier %1 %2")
                               .arg(document::carrierText(file->timeline->program(), op.carriers),
                                    machine::carriesYarn(op.kind) ? arrow(op.direction) : QString()));
    }
}

void StatusLine::takePlace() {
    m_needle->setText(tr("needle %1").arg(kNone));
    m_course->setText(tr("course %1").arg(kNone));
    m_rack->setText(tr("rack %1").arg(kNone));
    m_carrier->setText(tr("carrier %1 %2").arg(kNone, QString()));
    const auto file = m_document.file();
    if (!file) {
        m_stitches->clear();
        return;
    }
    const auto count = static_cast<machine::LoopIndex>(file->timeline->loops().loops.size());
    const machine::MachineState state = m_document.machineState();
    const machine::LoopIndex selected = m_document.selection().loop;
    if (m_hovered >= 0 && m_hovered < count) {
        showLoop(m_hovered);
    } else if (selected >= 0) {
        showLoop(selected);
    } else {
        m_rack->setText(tr("rack %1").arg(document::rackText(state.rack)));
        showOperation(m_document.step() - 1);
    }
    m_stitches->setText(tr("%1 stitches").arg(countText(state.loopCount)));
}

void StatusLine::takeLadders() {
    m_ladders->setText(ladderText(m_document));
    m_ladders->setVisible(!m_ladders->text().isEmpty());
    QPalette colours = palette();
    if (m_document.unstableLoops() > 0) {
        colours.setColor(QPalette::WindowText, accentsOf(palette()).warning);
    }
    m_ladders->setPalette(colours);
}

void StatusLine::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        takeLadders();
    }
    QWidget::changeEvent(event);
}

void StatusLine::takeFrame() {
    m_state->setText(activityWord(m_document));
    const auto frame = m_document.frame();
    m_energy->setText(frame ? tr("V %1").arg(energyText(frame->energies.potential)) : QString());
    m_time->setText(frame ? tr("%1 ms/step").arg(shortNumber(frame->millisecondsPerStep)) : QString());
}

} // namespace knittsim::ui
