#include "ui/dialogs/picture_dialog.h"

#include "ui/dialogs/picture_reading.h"
#include "ui/document/mailbox.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QThreadPool>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace knittsim::ui {

namespace {

constexpr int kMostWales = 500;
constexpr int kMostCourses = 1000;
constexpr int kFirstWales = 60;
constexpr int kMostColours = 8;

} // namespace

PictureDialog::PictureDialog(const QString& path, std::vector<pattern::ChartYarn> yarns,
                             std::vector<std::string> carriers, QWidget* parent)
    : QDialog(parent), m_yarns(std::move(yarns)), m_carriers(std::move(carriers)),
      m_mailbox(std::make_shared<document::Mailbox>(this)), m_round(std::make_shared<std::atomic<int>>(0)),
      m_view(new QLabel(this)), m_words(new QLabel(this)), m_progress(new QProgressBar(this)),
      m_wales(new QSpinBox(this)), m_courses(new QSpinBox(this)), m_keep(new QCheckBox(this)),
      m_walesPer10(new QDoubleSpinBox(this)), m_coursesPer10(new QDoubleSpinBox(this)),
      m_source(new QComboBox(this)), m_count(new QSpinBox(this)), m_dither(new QCheckBox(this)),
      m_method(new QComboBox(this)), m_make(nullptr) {
    setObjectName(QStringLiteral("picture"));
    setWindowTitle(tr("Import %1").arg(QFileInfo(path).fileName()));
    build();
    readPicture(path);
}

PictureDialog::~PictureDialog() {
    ++*m_round;
    m_mailbox->close();
}

void PictureDialog::build() {
    const int colours = std::min(kMostColours, static_cast<int>(m_carriers.size()));
    m_view->setObjectName(QStringLiteral("picturePreview"));
    m_view->setAccessibleName(tr("Preview of the chart"));
    m_view->setMinimumSize(380, 380);
    m_view->setAlignment(Qt::AlignCenter);
    m_words->setObjectName(QStringLiteral("pictureWords"));
    m_words->setWordWrap(true);
    m_progress->setRange(0, 100);
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(6);
    m_wales->setRange(1, kMostWales);
    m_wales->setValue(kFirstWales);
    m_wales->setObjectName(QStringLiteral("pictureWales"));
    m_wales->setToolTip(tr("Stitches across"));
    m_courses->setRange(1, kMostCourses);
    m_courses->setObjectName(QStringLiteral("pictureCourses"));
    m_courses->setToolTip(tr("Stitches up"));
    m_keep->setText(tr("&Keep the proportions"));
    m_keep->setObjectName(QStringLiteral("pictureKeep"));
    m_keep->setToolTip(tr("Circles stay round: the courses follow from the wales and the gauge"));
    m_keep->setChecked(true);
    for (QDoubleSpinBox* box : {m_walesPer10, m_coursesPer10}) {
        box->setRange(5, 400);
        box->setDecimals(1);
        box->setToolTip(tr("Gauge of the knitted fabric: how high a stitch is for its width"));
    }
    m_walesPer10->setValue(60);
    m_coursesPer10->setValue(80);
    m_walesPer10->setObjectName(QStringLiteral("pictureWalesPer10"));
    m_coursesPer10->setObjectName(QStringLiteral("pictureCoursesPer10"));
    m_source->setObjectName(QStringLiteral("pictureColours"));
    m_source->setToolTip(tr("Where the colours come from"));
    m_source->addItem(tr("Found in the picture"));
    if (m_yarns.size() > 1) {
        m_source->addItem(tr("Yarns of the open chart"));
    }
    m_count->setRange(1, colours);
    m_count->setValue(std::min(2, colours));
    m_count->setObjectName(QStringLiteral("pictureCount"));
    m_count->setToolTip(tr("Each colour needs a carrier"));
    m_dither->setText(tr("&Mix colours by dots"));
    m_dither->setObjectName(QStringLiteral("pictureDither"));
    m_dither->setToolTip(tr("Dithering: shades between the yarns from afar, single stitches from near"));
    m_method->setObjectName(QStringLiteral("pictureMethod"));
    m_method->setToolTip(tr("How the colours are knitted"));
    for (const auto& [name, help] : // by ColourMethod
         {std::pair{tr("Float jacquard"), tr("Yarns that do not show float behind the stitches")},
          {tr("Intarsia"), tr("Every yarn stays in its own zone")},
          {tr("Birdseye back"), tr("Both beds: yarns that do not show knit every second needle behind")},
          {tr("Ladder back"), tr("Both beds: yarns that do not show knit every fourth needle behind")}}) {
        m_method->addItem(name);
        m_method->setItemData(m_method->count() - 1, help, Qt::ToolTipRole);
    }

    auto* form = new QFormLayout;
    form->addRow(tr("&Wales"), m_wales);
    form->addRow(tr("&Courses"), m_courses);
    form->addRow(QString(), m_keep);
    form->addRow(tr("Wales in 10 cm"), m_walesPer10);
    form->addRow(tr("Courses in 10 cm"), m_coursesPer10);
    form->addRow(tr("C&olours"), m_source);
    form->addRow(tr("&Number of colours"), m_count);
    form->addRow(QString(), m_dither);
    form->addRow(tr("Knitted &as"), m_method);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_make = buttons->button(QDialogButtonBox::Ok);
    m_make->setText(tr("Make the chart"));
    m_make->setObjectName(QStringLiteral("pictureMake"));
    m_make->setEnabled(false);
    auto* left = new QVBoxLayout;
    left->addWidget(m_view, 1);
    left->addWidget(m_progress);
    auto* right = new QVBoxLayout;
    right->addLayout(form);
    right->addWidget(m_words);
    right->addStretch();
    auto* columns = new QHBoxLayout;
    columns->addLayout(left, 1);
    columns->addLayout(right);
    auto* rows = new QVBoxLayout(this);
    rows->addLayout(columns, 1);
    rows->addWidget(buttons);

    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    for (QSpinBox* box : {m_wales, m_count}) {
        connect(box, &QSpinBox::valueChanged, this, &PictureDialog::keepProportions);
    }
    for (QDoubleSpinBox* box : {m_walesPer10, m_coursesPer10}) {
        connect(box, &QDoubleSpinBox::valueChanged, this, &PictureDialog::keepProportions);
    }
    connect(m_keep, &QCheckBox::toggled, this, &PictureDialog::keepProportions);
    connect(m_courses, &QSpinBox::valueChanged, this, &PictureDialog::work);
    connect(m_dither, &QCheckBox::toggled, this, &PictureDialog::work);
    connect(m_source, &QComboBox::currentIndexChanged, this, [this] {
        m_count->setEnabled(!usesOwnYarns());
        work();
    });
}

double PictureDialog::stitchAspect() const {
    return m_walesPer10->value() / m_coursesPer10->value();
}

bool PictureDialog::usesOwnYarns() const {
    return m_source->currentIndex() == 1;
}

void PictureDialog::readPicture(const QString& path) {
    m_words->setText(tr("Reading the picture"));
    const int round = m_round->load();
    QThreadPool::globalInstance()->start([this, path, round, newest = m_round, mailbox = m_mailbox] {
        int told = 0;
        const auto tell = [&](double share) {
            if (const int percent = static_cast<int>(100 * share); percent > told) {
                told = percent;
                mailbox->post([this, percent] { m_progress->setValue(percent); });
            }
            return newest->load() == round; // closing the window ends it
        };
        mailbox->post([this, read = readPictureFile(path, tell)] { takePicture(read.first, read.second); });
    });
}

void PictureDialog::takePicture(std::shared_ptr<const pattern::Picture> picture, const QString& problem) {
    m_picture = std::move(picture);
    if (!m_picture) {
        m_words->setText(tr("The picture cannot be read: %1.").arg(problem));
        return;
    }
    keepProportions();
}

void PictureDialog::keepProportions() {
    m_courses->setEnabled(!m_keep->isChecked());
    if (m_picture && m_keep->isChecked()) {
        const QSignalBlocker blocker(m_courses);
        m_courses->setValue(pattern::coursesFor(*m_picture, m_wales->value(), stitchAspect()));
    }
    work();
}

/// In the background; the newest wins.
void PictureDialog::work() {
    if (!m_picture) {
        return;
    }
    pattern::PictureOptions options{.wales = m_wales->value(),
                                    .courses = m_courses->value(),
                                    .colours = {},
                                    .count = m_count->value(),
                                    .dither = m_dither->isChecked()};
    for (const pattern::ChartYarn& yarn : m_yarns) {
        if (usesOwnYarns()) {
            options.colours.push_back(yarn.colour);
        }
    }
    showWords();
    showPreview();
    if (options == m_options && *m_round > 0) {
        return; // another gauge, or Return in a box
    }
    m_options = options;
    m_cells.reset();
    m_make->setEnabled(false);
    const int round = ++*m_round;
    QThreadPool::globalInstance()->start(
        [this, round, newest = m_round, options, picture = m_picture, mailbox = m_mailbox] {
            const auto tell = [&](double share) {
                mailbox->post([this, share] { m_progress->setValue(static_cast<int>(100 * share)); });
                return newest->load() == round;
            };
            auto cells = pattern::reducePicture(*picture, options, tell);
            mailbox->post([this, round, newest, cells = std::move(cells)]() mutable {
                if (newest->load() == round) {
                    takeCells(std::move(cells));
                }
            });
        });
}

void PictureDialog::takeCells(std::optional<pattern::PictureCells> cells) {
    m_cells = std::move(cells);
    m_progress->setValue(0);
    m_make->setEnabled(m_cells.has_value());
    if (!m_cells) {
        return;
    }
    m_preview = QImage(m_cells->wales, m_cells->courses, QImage::Format_RGB32);
    for (int c = 0; c < m_cells->courses; ++c) {
        for (int w = 0; w < m_cells->wales; ++w) {
            const std::size_t cell = std::size_t(c) * std::size_t(m_cells->wales) + std::size_t(w);
            const yarn::Colour colour = m_cells->colours[m_cells->yarns[cell]];
            m_preview.setPixel(w, m_cells->courses - 1 - c, qRgb(colour.r, colour.g, colour.b));
        }
    }
    showWords();
    showPreview();
}

void PictureDialog::showWords() {
    const int wales = m_wales->value();
    const int courses = m_courses->value();
    const auto centimetres = [](double value) { return QLocale().toString(value, 'f', 1); };
    const QString size = tr("%1 x %2 stitches, about %3 x %4 cm.")
                             .arg(wales)
                             .arg(courses)
                             .arg(centimetres(10 * wales / m_walesPer10->value()),
                                  centimetres(10 * courses / m_coursesPer10->value()));
    const bool fewer =
        m_cells && !usesOwnYarns() && static_cast<int>(m_cells->colours.size()) < m_count->value();
    m_words->setText(fewer ? size + u' ' +
                                 tr("The picture has no more colours than %1.").arg(m_cells->colours.size())
                           : size);
}

/// In the proportions of the fabric.
void PictureDialog::showPreview() {
    if (m_preview.isNull()) {
        return;
    }
    const QSizeF natural(m_preview.width(), m_preview.height() * stitchAspect());
    const QSize size = natural.scaled(m_view->contentsRect().size(), Qt::KeepAspectRatio).toSize();
    m_view->setPixmap(QPixmap::fromImage(m_preview.scaled(size.expandedTo({1, 1}))));
}

void PictureDialog::resizeEvent(QResizeEvent* event) {
    QDialog::resizeEvent(event);
    showPreview();
}

pattern::Chart PictureDialog::chart() const {
    const auto method = static_cast<pattern::ColourMethod>(std::max(0, m_method->currentIndex()));
    std::vector<std::string> carriers = m_carriers;
    if (usesOwnYarns()) {
        carriers.clear();
        std::ranges::transform(m_yarns, std::back_inserter(carriers), &pattern::ChartYarn::carrier);
    }
    pattern::Chart chart = pattern::chartOf(*m_cells, carriers, method);
    for (std::size_t i = 0; usesOwnYarns() && i < m_yarns.size(); ++i) {
        chart.yarns[i] = m_yarns[i];
    }
    return chart;
}

} // namespace knittsim::ui
