#include "ui/dialogs/pull_dialog.h"

#include "core/base/file.h"
#include "ui/dialogs/pull_plot.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>

namespace knittsim::ui {

using document::PullRun;
using State = document::PullRun::State;

PullDialog::PullDialog(document::Document& document, QWidget* parent)
    : QDialog(parent), m_document(document) {
    setObjectName(QStringLiteral("pullDialog"));
    setWindowTitle(tr("Pull test"));
    build();
    connect(&m_run, &PullRun::changed, this, &PullDialog::takeRun);
    takeRun();
}

void PullDialog::build() {
    auto* purpose =
        new QLabel(tr("Draws one repeat of the fabric longer in the yarn model and lets it back, as a "
                      "strip far from its grips."),
                   this);
    purpose->setWordWrap(true);
    m_sides = new QComboBox(this);
    m_sides->setObjectName(QStringLiteral("pullSides"));
    m_sides->addItem(tr("Left and right, along the courses"));
    m_sides->addItem(tr("Top and bottom, along the wales"));
    m_sides->setToolTip(tr("The two opposite sides that are pulled; the others are free"));
    m_strain = new QDoubleSpinBox(this);
    m_strain->setObjectName(QStringLiteral("pullStrain"));
    m_strain->setRange(1, 500);
    m_strain->setDecimals(0);
    m_strain->setValue(60);
    m_strain->setSuffix(tr(" %"));
    m_strain->setToolTip(tr("Largest strain, of the size at rest"));
    m_steps = new QSpinBox(this);
    m_steps->setObjectName(QStringLiteral("pullSteps"));
    m_steps->setRange(2, 500);
    m_steps->setValue(20);
    m_steps->setToolTip(tr("Points up to the largest strain, and as many back"));
    auto* form = new QFormLayout;
    form->addRow(tr("Pulled &sides"), m_sides);
    form->addRow(tr("S&train"), m_strain);
    form->addRow(tr("Ste&ps"), m_steps);
    m_plot = new PullPlot(this);
    m_progress = new QProgressBar(this);
    m_progress->setObjectName(QStringLiteral("pullProgress"));
    m_progress->setAccessibleName(tr("Progress of the pull test"));
    m_progress->setTextVisible(false);
    m_state = new QLabel(this);
    m_state->setObjectName(QStringLiteral("pullState"));
    m_state->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    m_start = buttons->addButton(tr("&Pull"), QDialogButtonBox::ActionRole);
    m_start->setObjectName(QStringLiteral("pullStart"));
    m_start->setDefault(true);
    m_save = buttons->addButton(tr("&Write CSV\u2026"), QDialogButtonBox::ActionRole);
    m_save->setObjectName(QStringLiteral("pullSave"));
    m_save->setToolTip(tr("Writes strain, force and size of every point as comma-separated values"));
    buttons->button(QDialogButtonBox::Close)->setToolTip(tr("Ends the test (Esc)"));
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(16, 16, 16, 12);
    rows->setSpacing(10);
    rows->addWidget(purpose);
    rows->addLayout(form);
    rows->addWidget(m_plot, 1);
    rows->addWidget(m_progress);
    rows->addWidget(m_state);
    rows->addWidget(buttons);
    connect(m_start, &QPushButton::clicked, this, &PullDialog::toggle);
    connect(m_save, &QPushButton::clicked, this, &PullDialog::chooseFile);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(this, &QDialog::finished, &m_run, &PullRun::stop);
}

void PullDialog::toggle() {
    if (m_run.running()) {
        m_run.stop();
        return;
    }
    const auto file = m_document.file();
    if (!file) {
        return;
    }
    using physics::CellLoadTerm;
    m_run.start(file->fabric, machine::yarnsOf(m_document.carriers()),
                {.side = m_sides->currentIndex() == 0 ? CellLoadTerm::Width : CellLoadTerm::Height,
                 .strain = m_strain->value() / 100,
                 .steps = m_steps->value()});
}

void PullDialog::takeRun() {
    const bool running = m_run.running();
    for (QWidget* input : std::initializer_list<QWidget*>{m_sides, m_strain, m_steps}) {
        input->setEnabled(!running);
    }
    m_start->setText(running ? tr("Sto&p") : tr("&Pull"));
    m_start->setToolTip(running ? tr("Ends the test and keeps its points") : tr("Starts the test"));
    m_save->setEnabled(!running && m_run.points().size() > 1);
    const document::PullSettings& settings = m_run.settings();
    m_progress->setRange(0, m_run.state() == State::Settling ? 0 : 2 * settings.steps);
    m_progress->setValue(m_run.state() == State::Done ? 2 * settings.steps
                                                      : static_cast<int>(m_run.points().size()));
    m_progress->setEnabled(running);
    m_state->setText(stateText());
    std::vector<QPointF> up;
    std::vector<QPointF> back;
    const double unit = simulation::stressUnit(m_run.units());
    for (const physics::PullPoint& point : m_run.points()) {
        if (point.back && back.empty()) {
            back.push_back(up.back());
        }
        (point.back ? back : up).emplace_back(100 * point.strain, unit * point.stress);
    }
    m_plot->setCurves(std::move(up), std::move(back), 100 * settings.strain);
}

QString PullDialog::stateText() const {
    const auto number = [](double value) { return QLocale().toString(value, 'g', 3); };
    const QString repeat = tr("A repeat of %1 \u00d7 %2 stitches").arg(m_run.wales()).arg(m_run.courses());
    switch (m_run.state()) {
    case State::Idle:
        return tr("Some seconds for a small repeat.");
    case State::Settling:
        return tr("The repeat comes to rest\u2026");
    case State::Pulling:
        return tr("%1, point %2 of at most %3")
            .arg(repeat)
            .arg(m_run.points().size())
            .arg(2 * m_run.settings().steps);
    case State::Done: {
        const auto most = std::ranges::max_element(m_run.points(), {}, &physics::PullPoint::stress);
        return tr("%1: %2 N/mm at %3 %")
            .arg(repeat, number(simulation::stressUnit(m_run.units()) * most->stress),
                 number(100 * most->strain));
    }
    case State::Stopped:
        return tr("Stopped");
    case State::NoRepeat:
        return tr("Most of the fabric would have to be knit and purl stitches of one yarn that repeat "
                  "themselves.");
    case State::NotAtRest:
        return tr("The repeat does not come to rest; the points up to there are kept.");
    }
    return {};
}

void PullDialog::chooseFile() {
    const QString path = QFileDialog::getSaveFileName(
        this, tr("Write the pull test"), QStringLiteral("pull.csv"), tr("Comma-separated values (*.csv)"));
    if (!path.isEmpty()) {
        m_state->setText(writeCsv(path) ? tr("Written to %1").arg(path)
                                        : tr("%1 cannot be written.").arg(path));
    }
}

bool PullDialog::writeCsv(const QString& path) const {
    const QByteArray text = m_run.csv();
    return writeFileAtomically(path.toStdString(), {text.constData(), static_cast<std::size_t>(text.size())})
        .hasValue();
}

} // namespace knittsim::ui
