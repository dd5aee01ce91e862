#include "ui/window/gallery.h"

#include "core/pattern/samples.h"
#include "ui/views/style/icons.h"
#include "ui/window/sample_card.h"
#include "ui/window/sample_thumbnail.h"

#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLayoutItem>
#include <QPushButton>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace knittsim::ui {

namespace {

constexpr int kSpacing = 14;
constexpr int kMargin = 28;
constexpr int kMostColumns = 6;
constexpr int kMostRecent = 5;
constexpr QSize kRecentPicture(60, 36);

QLabel* makeText(QWidget* parent, const QString& text, double scale, bool bold) {
    auto* label = new QLabel(text, parent);
    QFont face = label->font();
    face.setPointSizeF(face.pointSizeF() * scale);
    face.setBold(bold);
    label->setFont(face);
    return label;
}

} // namespace

Gallery::Gallery(QWidget* parent) : QScrollArea(parent) {
    setObjectName(QStringLiteral("gallery"));
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    build();
}

void Gallery::build() {
    auto* page = new QWidget(this);
    auto* rows = new QVBoxLayout(page);
    rows->setContentsMargins(kMargin, 22, kMargin, 22);
    rows->setSpacing(8);

    auto* head = new QHBoxLayout;
    auto* picture = new QLabel(page);
    picture->setPixmap(applicationIcon().pixmap(QSize(48, 48), devicePixelRatioF()));
    auto* words = new QVBoxLayout;
    words->setSpacing(1);
    words->addWidget(makeText(page, tr("KnittSim"), 1.55, true));
    words->addWidget(
        makeText(page, tr("Draw a new chart, open a chart or a machine program, or begin with a sample."),
                 1.0, false));
    const auto addButton = [&](const char* name, const QString& image, const QString& text,
                               const QString& tip, void (Gallery::*wanted)()) {
        auto* button = new QPushButton(icon(image), text, page);
        button->setObjectName(QLatin1String(name));
        button->setToolTip(tip);
        button->setMinimumHeight(34);
        button->setAutoDefault(true); // Enter is as good as Space
        connect(button, &QPushButton::clicked, this, wanted);
        return button;
    };
    auto* fresh = addButton("galleryNew", QStringLiteral("new"), tr("New chart\u2026"),
                            tr("Draw a chart of your own (Ctrl+N)"), &Gallery::newWanted);
    fresh->setDefault(true);
    auto* photo =
        addButton("galleryPicture", QStringLiteral("picture"), tr("From a picture\u2026"),
                  tr("Turn a photograph or drawing into a chart (Ctrl+Alt+I)"), &Gallery::pictureWanted);
    auto* open = addButton("galleryOpen", QStringLiteral("open"), tr("Open\u2026"),
                           tr("Open a chart or a machine program (Ctrl+O)"), &Gallery::openWanted);
    head->addWidget(picture);
    head->addSpacing(8);
    head->addLayout(words, 1);
    setFocusProxy(fresh);
    for (QPushButton* button : {fresh, photo, open}) {
        head->addWidget(button);
    }
    rows->addLayout(head);

    m_recentBox = new QWidget(page);
    m_recent = new QVBoxLayout(m_recentBox);
    m_recent->setContentsMargins(0, 8, 0, 0);
    m_recent->setSpacing(2);
    rows->addWidget(m_recentBox);

    rows->addSpacing(8);
    rows->addWidget(makeText(page, tr("Samples"), 1.1, true));
    m_grid = new QGridLayout;
    m_grid->setSpacing(kSpacing);
    rows->addLayout(m_grid);
    rows->addStretch(1);
    setWidget(page);

    for (const pattern::Sample& sample : pattern::samples()) {
        auto* card = new SampleCard(sample, page);
        connect(card, &QAbstractButton::clicked, this, [this, card] { emit sampleChosen(card->sampleId()); });
        m_cards.push_back(card);
    }
    setRecentFiles({});
}

void Gallery::setRecentFiles(const QStringList& files) {
    while (QLayoutItem* item = m_recent->takeAt(0)) {
        if (item->widget()) {
            item->widget()->deleteLater();
        }
        delete item;
    }
    m_recentBox->setVisible(!files.isEmpty());
    if (files.isEmpty()) {
        return;
    }
    m_recent->addWidget(makeText(m_recentBox, tr("Used last"), 1.1, true));
    for (const QString& path : files.mid(0, kMostRecent)) {
        auto* row = new QPushButton(QFileInfo(path).fileName(), m_recentBox);
        row->setFlat(true);
        if (const QPixmap picture = thumbnailOf(path); !picture.isNull()) {
            row->setIcon(picture);
            row->setIconSize(kRecentPicture);
        }
        row->setToolTip(path);
        row->setCursor(Qt::PointingHandCursor);
        QPalette link = row->palette();
        link.setColor(QPalette::ButtonText, palette().color(QPalette::Link));
        row->setPalette(link);
        connect(row, &QPushButton::clicked, this, [this, path] { emit fileChosen(path); });
        m_recent->addWidget(row, 0, Qt::AlignLeft);
    }
}

void Gallery::placeCards() {
    const int room = viewport()->width() - 2 * kMargin + kSpacing;
    const int columns = std::clamp(room / (SampleCard::kLeastWidth + kSpacing), 1, kMostColumns);
    if (columns == m_columns) {
        return;
    }
    for (int column = 0; column <= std::max(columns, m_columns); ++column) {
        m_grid->setColumnStretch(column, column < columns ? 1 : 0);
    }
    m_columns = columns;
    for (std::size_t i = 0; i < m_cards.size(); ++i) {
        const int index = static_cast<int>(i);
        m_grid->addWidget(m_cards[i], index / columns, index % columns);
    }
}

void Gallery::resizeEvent(QResizeEvent* event) {
    QScrollArea::resizeEvent(event);
    placeCards();
}

} // namespace knittsim::ui
