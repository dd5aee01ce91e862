#include "ui/dialogs/export_dialog.h"

#include "ui/document/message_text.h"
#include "ui/views/style/appearance.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

namespace knittsim::ui {

namespace {

struct Choice {
    const char* extension;
    const char* text;
    const char* hint;
    bool sized; ///< has pixels and a background
    bool sided; ///< shows one side
};

constexpr std::array kChoices{
    Choice{"png", QT_TRANSLATE_NOOP("knittsim::ui::ExportDialog", "Picture (PNG)"),
           QT_TRANSLATE_NOOP("knittsim::ui::ExportDialog", "What you see, at any size."), true, true},
    Choice{"svg", QT_TRANSLATE_NOOP("knittsim::ui::ExportDialog", "Drawing in three strokes (SVG)"),
           QT_TRANSLATE_NOOP("knittsim::ui::ExportDialog",
                             "Lines in millimetres; at every crossing the front yarn lies on top."),
           false, true},
    Choice{"glb", QT_TRANSLATE_NOOP("knittsim::ui::ExportDialog", "Geometry, glTF binary (GLB)"),
           QT_TRANSLATE_NOOP("knittsim::ui::ExportDialog",
                             "A closed tube for each yarn, in metres, with its colour. One file."),
           false, false},
    Choice{"gltf", QT_TRANSLATE_NOOP("knittsim::ui::ExportDialog", "Geometry, glTF text (GLTF)"),
           QT_TRANSLATE_NOOP("knittsim::ui::ExportDialog", "As the binary form, a third larger."), false,
           false},
    Choice{
        "obj", QT_TRANSLATE_NOOP("knittsim::ui::ExportDialog", "Geometry, Wavefront (OBJ)"),
        QT_TRANSLATE_NOOP("knittsim::ui::ExportDialog",
                          "A closed tube for each yarn, in millimetres; colours in an MTL file beside it."),
        false, false},
    Choice{"bcc", QT_TRANSLATE_NOOP("knittsim::ui::ExportDialog", "Yarn curves (BCC)"),
           QT_TRANSLATE_NOOP("knittsim::ui::ExportDialog",
                             "The middle of each yarn as a curve, in millimetres."),
           false, false},
    Choice{"csv", QT_TRANSLATE_NOOP("knittsim::ui::ExportDialog", "Bonding points (CSV)"),
           QT_TRANSLATE_NOOP("knittsim::ui::ExportDialog",
                             "A line for each bonding point: yarn, role, needle, place in millimetres."),
           false, false},
    Choice{"frames",
           QT_TRANSLATE_NOOP("knittsim::ui::ExportDialog", "Pictures of the settling (folder of PNG)"),
           QT_TRANSLATE_NOOP("knittsim::ui::ExportDialog",
                             "From the machine to rest, seen from one place: 0001.png, 0002.png, ..."),
           true, true}};

/// Of a row with more than one field.
QLabel* labelFor(QWidget* field, const QString& text) {
    auto* label = new QLabel(text, field->parentWidget());
    label->setBuddy(field);
    return label;
}

QSpinBox* pixelBox(const QString& name, const QString& tip, QWidget* parent) {
    auto* box = new QSpinBox(parent);
    box->setObjectName(name);
    box->setRange(16, kMostExportPixels);
    box->setSuffix(ExportDialog::tr(" px"));
    box->setToolTip(tip);
    box->setAccessibleName(tip);
    return box;
}

} // namespace

ExportDialog::ExportDialog(ExportSource source, const QString& path, QSize view, QWidget* parent)
    : QDialog(parent), m_source(std::move(source)), m_format(new QComboBox(this)),
      m_path(new QLineEdit(path, this)), m_browse(new QPushButton(tr("&Browse\u2026"), this)),
      m_side(new QComboBox(this)),
      m_width(pixelBox(QStringLiteral("exportWidth"), tr("Width of the picture"), this)),
      m_height(pixelBox(QStringLiteral("exportHeight"), tr("Height of the picture"), this)),
      m_transparent(new QCheckBox(tr("&Transparent background"), this)), m_hint(new QLabel(this)),
      m_problem(new QLabel(this)), m_progress(new QProgressBar(this)) {
    setObjectName(QStringLiteral("exportDialog"));
    setWindowTitle(tr("Export"));
    m_format->setObjectName(QStringLiteral("exportFormat"));
    m_format->setToolTip(tr("What is written"));
    m_path->setObjectName(QStringLiteral("exportPath"));
    m_path->setToolTip(tr("File to write; one that is there is replaced when you export twice"));
    m_browse->setToolTip(tr("Choose a folder and a name"));
    m_side->setObjectName(QStringLiteral("exportSide"));
    m_side->setToolTip(tr("From where the fabric is shown"));
    m_transparent->setObjectName(QStringLiteral("exportTransparent"));
    m_transparent->setToolTip(tr("Leaves out the background, for laying the picture over others"));
    m_progress->setObjectName(QStringLiteral("exportProgress"));
    m_progress->setRange(0, 1000);
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(8);
    m_problem->setObjectName(QStringLiteral("exportProblem"));
    QPalette colours = palette();
    colours.setColor(QPalette::WindowText, accentsOf(colours).error);
    m_problem->setPalette(colours);
    for (QLabel* label : {m_hint, m_problem}) {
        label->setWordWrap(true);
        // Room for two lines, so that nothing moves when the words change.
        label->setMinimumHeight(2 * fontMetrics().lineSpacing());
        label->setAlignment(Qt::AlignTop);
    }
    for (const Choice& choice : kChoices) {
        m_format->addItem(tr(choice.text));
    }
    m_side->addItems({tr("As seen now"), tr("Technical face"), tr("Technical back")});

    auto* size = new QHBoxLayout;
    size->addWidget(m_width);
    size->addWidget(new QLabel(QStringLiteral("\u00d7"), this));
    size->addWidget(m_height);
    size->addStretch();
    auto* file = new QHBoxLayout;
    file->addWidget(m_path, 1);
    file->addWidget(m_browse);
    auto* form = new QFormLayout;
    form->addRow(tr("&Format:"), m_format);
    form->addRow(QString(), m_hint);
    form->addRow(tr("&Side:"), m_side);
    form->addRow(labelFor(m_width, tr("Si&ze:")), size);
    form->addRow(QString(), m_transparent);
    form->addRow(labelFor(m_path, tr("Fi&le:")), file);
    auto* buttons = new QDialogButtonBox(this);
    m_export = buttons->addButton(tr("&Export"), QDialogButtonBox::AcceptRole);
    m_export->setObjectName(QStringLiteral("exportStart"));
    m_export->setToolTip(tr("Writes the file (Enter)"));
    m_export->setDefault(true);
    m_close = buttons->addButton(QDialogButtonBox::Cancel);
    m_close->setObjectName(QStringLiteral("exportCancel"));
    m_close->setToolTip(tr("Stops writing; nothing is left of the file (Esc)"));
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(20, 18, 20, 14);
    rows->setSpacing(12);
    rows->addLayout(form);
    rows->addWidget(m_problem);
    rows->addWidget(m_progress);
    rows->addWidget(buttons);
    setMinimumWidth(560);

    const double shape = static_cast<double>(view.height()) / std::max(1, view.width());
    m_width->setValue(std::max(1920, view.width()));
    m_height->setValue(static_cast<int>(std::lround(m_width->value() * shape)));
    connect(m_format, &QComboBox::currentIndexChanged, this, [this] { takeFormat(); });
    connect(m_path, &QLineEdit::textChanged, this, [this] { enableControls(); });
    connect(m_browse, &QPushButton::clicked, this, [this] { browse(); });
    connect(m_export, &QPushButton::clicked, this, [this] { start(); });
    connect(m_close, &QPushButton::clicked, this, [this] { reject(); });
    takeFormat();
    setWorking(false);
}

ExportDialog::~ExportDialog() {
    m_cancelled = true;
    m_pool.waitForDone();
}

void ExportDialog::takeFormat() {
    const Choice& choice = kChoices[static_cast<std::size_t>(m_format->currentIndex())];
    m_hint->setText(hintFor(choice.hint, choice.sized));
    enableControls();
    const QFileInfo before(m_path->text());
    const bool known = std::ranges::any_of(
        kChoices, [&](const Choice& c) { return before.suffix().toLower() == QLatin1String(c.extension); });
    const QString stem = known ? m_path->text().chopped(before.suffix().size() + 1) : m_path->text();
    m_path->setText(stem + u'.' + QLatin1String(choice.extension));
    m_problem->clear();
}

/// Says also what of the fabric is written.
QString ExportDialog::hintFor(const char* hint, bool picture) const {
    QString text = tr(hint);
    if (!m_source.keep.empty()) {
        text += u' ' + tr("As shown: %1.").arg(m_source.parts);
    }
    if (m_source.section && !picture) {
        text += u' ' + tr("What the section cuts away is written too.");
    }
    return text;
}

void ExportDialog::browse() {
    const Choice& choice = kChoices[static_cast<std::size_t>(m_format->currentIndex())];
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Export as"), m_path->text(),
                                     QStringLiteral("%1 (*.%2)").arg(tr(choice.text), choice.extension),
                                     nullptr, QFileDialog::DontConfirmOverwrite);
    if (!path.isEmpty()) {
        m_path->setText(QFileInfo(path).suffix().isEmpty() ? path + u'.' + choice.extension : path);
    }
}

void ExportDialog::start() {
    ExportJob job{m_source,
                  m_path->text().toStdString(),
                  static_cast<ExportJob::Side>(m_side->currentIndex()),
                  m_width->value(),
                  m_height->value(),
                  m_transparent->isChecked()};
    if (QFileInfo::exists(m_path->text()) && !isSequence(job.path) && m_replaced != m_path->text()) {
        m_replaced = m_path->text();
        m_problem->setText(tr("This file exists. Export once more to replace it, or choose another name."));
        m_problem->setAccessibleDescription(m_problem->text());
        return;
    }
    m_cancelled = false;
    m_progress->setValue(0);
    setWorking(true);
    m_pool.start([this, job = std::move(job)] {
        const auto result = writeExport(job, [this](double share) {
            QMetaObject::invokeMethod(m_progress, [bar = m_progress, share] {
                bar->setValue(static_cast<int>(share * bar->maximum()));
            });
            return !m_cancelled.load();
        });
        QMetaObject::invokeMethod(
            this, [this, problems = result ? Diagnostics() : result.diagnostics()] { finish(problems); },
            Qt::QueuedConnection);
    });
}

void ExportDialog::finish(const Diagnostics& problems) {
    setWorking(false);
    if (m_cancelled) {
        QDialog::reject();
    } else if (problems.empty()) {
        emit written(m_path->text());
        accept();
    } else {
        m_problem->setText(document::causeText(problems.front()) + u' ' +
                           document::cureText(problems.front()));
        m_problem->setAccessibleDescription(m_problem->text());
    }
}

void ExportDialog::reject() {
    if (m_working) {
        m_cancelled = true; // finish() closes
        m_close->setEnabled(false);
    } else {
        QDialog::reject();
    }
}

void ExportDialog::setWorking(bool working) {
    m_working = working;
    m_progress->setVisible(working);
    m_problem->clear();
    enableControls();
}

void ExportDialog::enableControls() {
    const Choice& choice = kChoices[static_cast<std::size_t>(m_format->currentIndex())];
    for (QWidget* widget : std::initializer_list<QWidget*>{m_width, m_height, m_transparent}) {
        widget->setEnabled(choice.sized && !m_working);
    }
    m_side->setEnabled(choice.sided && !m_working);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_format, m_path, m_browse}) {
        widget->setEnabled(!m_working);
    }
    m_export->setEnabled(!m_working && !m_path->text().isEmpty());
    m_close->setEnabled(true);
}

} // namespace knittsim::ui
