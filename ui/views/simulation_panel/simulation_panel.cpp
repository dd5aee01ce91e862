#include "ui/views/simulation_panel/simulation_panel.h"

#include "ui/views/simulation_panel/activity_text.h"
#include "ui/views/simulation_panel/energy_plot.h"
#include "ui/views/simulation_panel/ladder_text.h"
#include "ui/views/simulation_panel/yarn_run_text.h"
#include "ui/views/style/icons.h"
#include "ui/views/style/numbers.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>

namespace knittsim::ui {

QString integratorName(const simulation::IntegratorInfo& info) {
    return QCoreApplication::translate("integrators", info.name);
}

QString integratorPurpose(const simulation::IntegratorInfo& info) {
    return QCoreApplication::translate("integrators", info.purpose);
}

SimulationPanel::SimulationPanel(document::Document& document, QWidget* parent)
    : QWidget(parent), m_document(document) {
    setObjectName(QStringLiteral("simulationPanel"));
    build();
    connect(&m_document, &document::Document::activityChanged, this, &SimulationPanel::takeActivity);
    connect(&m_document, &document::Document::frameShown, this, &SimulationPanel::takeFrame);
    connect(&m_document, &document::Document::integratorChanged, this, &SimulationPanel::takeIntegrator);
    connect(&m_document, &document::Document::generationChanged, m_plot, &EnergyPlot::clear);
    connect(&m_document, &document::Document::ladderChanged, this, &SimulationPanel::takeLadders);
    connect(&m_document, &document::Document::yarnRunChanged, this, &SimulationPanel::takeYarnRun);
    takeActivity();
    takeIntegrator();
    takeLadders();
    takeYarnRun();
}

QToolButton* SimulationPanel::addButton(const char* name, const char* iconName, const QString& text,
                                        const QString& keys) {
    auto* button = new QToolButton(this);
    button->setObjectName(QString::fromLatin1(name));
    button->setIcon(icon(QString::fromLatin1(iconName)));
    button->setIconSize({18, 18});
    button->setToolTip(QStringLiteral("%1 (%2)").arg(text, keys));
    button->setAccessibleName(text);
    return button;
}

void SimulationPanel::build() {
    m_dot = new QLabel(this);
    m_dot->setFixedSize(12, 12);
    m_state = new QLabel(this);
    m_state->setObjectName(QStringLiteral("simulationState"));
    m_state->setWordWrap(true);
    m_run = addButton("simulationRun", "play", tr("Start"), tr("F5"));
    m_step = addButton("simulationStep", "step", tr("One step of the integrator"), tr("F6"));
    m_restart = addButton("simulationRestart", "restart", tr("Restart from the machine"), tr("R"));
    m_stop = addButton("simulationStop", "stop", tr("Stop and forget the velocity"), tr("Shift+F5"));
    m_integrator = new QComboBox(this);
    m_integrator->setObjectName(QStringLiteral("integratorChoice"));
    m_integrator->setAccessibleName(tr("Integrator"));
    m_integrator->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_integrator->setMinimumContentsLength(8);
    for (const simulation::IntegratorInfo& info : simulation::integrators()) {
        m_integrator->addItem(integratorName(info), QString::fromUtf8(info.id));
        m_integrator->setItemData(m_integrator->count() - 1, integratorPurpose(info), Qt::ToolTipRole);
    }
    m_ladders = addButton("removeLadders", "ladder", tr("Remove ladders"), tr("Ctrl+L"));
    m_ladders->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_yarn = addButton("settleYarn", "style-yarn", tr("Settle as yarn"), tr("Y"));
    m_yarn->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_yarnState = new QLabel(this);
    m_yarnState->setObjectName(QStringLiteral("yarnState"));
    m_yarnState->setWordWrap(true);
    m_surroundings = new QComboBox(this);
    m_surroundings->setObjectName(QStringLiteral("surroundingsChoice"));
    m_surroundings->setAccessibleName(tr("Surroundings of the yarn"));
    m_surroundings->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_surroundings->setMinimumContentsLength(8);
    for (const simulation::SurroundingsInfo& info : simulation::surroundingsKinds()) {
        m_surroundings->addItem(surroundingsName(info));
        m_surroundings->setItemData(m_surroundings->count() - 1, surroundingsPurpose(info), Qt::ToolTipRole);
    }
    m_holder = new QCheckBox(tr("Stitch holder"), this);
    m_holder->setObjectName(QStringLiteral("stitchHolder"));
    m_holder->setToolTip(tr("%1 (Ctrl+Shift+L)").arg(stitchHolderHelp()));
    m_numbers = new QLabel(this);
    m_numbers->setObjectName(QStringLiteral("simulationNumbers"));
    m_plot = new EnergyPlot(this);

    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(3);
    for (QToolButton* button : {m_run, m_step, m_restart, m_stop}) {
        buttons->addWidget(button);
    }
    buttons->addSpacing(6);
    buttons->addWidget(m_dot);
    buttons->addWidget(m_state, 1);
    auto* ladders = new QHBoxLayout;
    ladders->addWidget(m_ladders);
    ladders->addStretch(1);
    ladders->addWidget(m_holder);
    auto* yarn = new QHBoxLayout;
    yarn->addWidget(m_yarn);
    yarn->addWidget(m_surroundings, 1);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(8, 8, 8, 8);
    rows->setSpacing(6);
    rows->addLayout(buttons);
    rows->addWidget(m_integrator);
    rows->addLayout(yarn);
    rows->addWidget(m_yarnState);
    rows->addLayout(ladders);
    rows->addWidget(m_plot, 1);
    rows->addWidget(m_numbers);

    connect(m_run, &QToolButton::clicked, this, &SimulationPanel::toggleRunning);
    connect(m_step, &QToolButton::clicked, &m_document, &document::Document::stepSimulation);
    connect(m_restart, &QToolButton::clicked, &m_document, &document::Document::restart);
    connect(m_stop, &QToolButton::clicked, &m_document, &document::Document::stop);
    connect(m_yarn, &QToolButton::clicked, &m_document, &document::Document::settleYarn);
    connect(m_surroundings, &QComboBox::activated, this, [this](int index) {
        m_document.setSurroundings(simulation::surroundingsKinds()[static_cast<std::size_t>(index)].value);
    });
    connect(m_ladders, &QToolButton::clicked, &m_document, &document::Document::removeLadders);
    connect(m_holder, &QCheckBox::toggled, &m_document, &document::Document::setStitchHolder);
    connect(m_integrator, &QComboBox::currentIndexChanged, this,
            [this] { m_document.setIntegrator(m_integrator->currentData().toString()); });
}

void SimulationPanel::toggleRunning() {
    if (running()) {
        m_document.pause();
    } else {
        m_document.start();
    }
}

void SimulationPanel::takeActivity() {
    const bool open = m_document.file() != nullptr;
    for (QWidget* control : std::initializer_list<QWidget*>{m_run, m_step, m_restart, m_stop, m_yarn,
                                                            m_surroundings, m_ladders, m_holder}) {
        control->setEnabled(open);
    }
    const QString run = running() ? tr("Pause") : tr("Start");
    m_run->setIcon(icon(running() ? QStringLiteral("pause") : QStringLiteral("play")));
    m_run->setToolTip(QStringLiteral("%1 (F5)").arg(run));
    m_run->setAccessibleName(run);
    m_state->setText(activityText(m_document));
    m_state->setToolTip(m_state->text());
    QPixmap dot(m_dot->size() * devicePixelRatioF());
    dot.setDevicePixelRatio(devicePixelRatioF());
    dot.fill(Qt::transparent);
    QPainter painter(&dot);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(activityColour(m_document, palette()));
    painter.drawEllipse(QRectF(1.5, 3, 8, 8));
    painter.end();
    m_dot->setPixmap(dot);
}

void SimulationPanel::takeFrame() {
    const auto frame = m_document.frame();
    if (!frame) {
        return;
    }
    const auto& samples = m_plot->history().samples();
    if (samples.empty() || samples.back().step != frame->step) {
        m_plot->add({frame->step, frame->energies, frame->residual});
    }
    QString numbers =
        tr("Step %1 \u00b7 %2 ms each").arg(countText(frame->step), shortNumber(frame->millisecondsPerStep));
    if (frame->stepSize > 0) {
        numbers += tr(" \u00b7 dt %1 s").arg(shortNumber(frame->stepSize));
    }
    m_numbers->setText(numbers);
}

void SimulationPanel::takeIntegrator() {
    const QSignalBlocker quiet(m_integrator);
    const int index = m_integrator->findData(m_document.integrator());
    m_integrator->setCurrentIndex(index);
    m_integrator->setToolTip(
        tr("Integrator. %1").arg(m_integrator->itemData(index, Qt::ToolTipRole).toString()));
}

void SimulationPanel::takeLadders() {
    const bool running = m_document.laddersRun();
    const QString text = running ? tr("Skip to the end") : tr("Remove ladders");
    m_ladders->setText(text);
    m_ladders->setAccessibleName(text);
    m_ladders->setToolTip(running
                              ? tr("Shows the end of the run at once (Ctrl+L); Escape puts the loops back")
                              : tr("%1 (Ctrl+L)").arg(removeLaddersHelp()));
    const QSignalBlocker quiet(m_holder);
    m_holder->setChecked(m_document.stitchHolder());
    m_holder->setEnabled(m_document.file() && !running);
}

void SimulationPanel::takeYarnRun() {
    const document::YarnRun& run = m_document.yarnRun();
    const QString text = settleYarnText(run);
    m_yarn->setText(text);
    m_yarn->setAccessibleName(text);
    m_yarn->setToolTip(run.running() ? tr("Keeps the shape that the yarn has reached (Y)")
                                     : tr("%1 (Y)").arg(settleYarnHelp()));
    const auto surroundings = static_cast<int>(run.surroundings());
    m_surroundings->setCurrentIndex(surroundings);
    m_surroundings->setToolTip(tr("What the yarn lies on or hangs from. %1")
                                   .arg(m_surroundings->itemData(surroundings, Qt::ToolTipRole).toString()));
    m_yarnState->setText(yarnRunText(run));
    m_yarnState->setVisible(!m_yarnState->text().isEmpty());
    m_yarnState->setToolTip(yarnRunDetails(run));
    takeActivity();
}

void SimulationPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && m_plot) {
        takeActivity();
    }
    QWidget::changeEvent(event);
}

} // namespace knittsim::ui
