#include "ui/views/yarn_library/yarn_panel.h"

#include "ui/views/style/appearance.h"
#include "ui/views/style/icons.h"
#include "ui/views/yarn_library/colourway_bar.h"
#include "ui/views/yarn_library/yarn_delegate.h"
#include "ui/views/yarn_library/yarn_details.h"

#include <QColorDialog>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QPushButton>
#include <QSplitter>
#include <QTextBrowser>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace knittsim::ui {

namespace {

/// More carriers than this scroll.
constexpr int kCarriersShown = 3;

QListView* makeList(QWidget* parent, QAbstractItemModel& model, const char* name, const QString& accessible) {
    auto* list = new QListView(parent);
    list->setObjectName(QString::fromLatin1(name));
    list->setAccessibleName(accessible);
    list->setModel(&model);
    list->setItemDelegate(new YarnDelegate(list));
    list->setUniformItemSizes(true);
    list->setEditTriggers(QAbstractItemView::NoEditTriggers);
    list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list->setMinimumHeight(44);
    return list;
}

} // namespace

YarnPanel::YarnPanel(document::Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_carriers(document), m_yarns(document.sharedLibrary()) {
    setObjectName(QStringLiteral("yarnPanel"));
    build();
    connect(&m_carriers, &QAbstractItemModel::modelReset, this, &YarnPanel::fitCarriers);
    connect(&m_document, &document::Document::yarnsChanged, this, &YarnPanel::showDetails);
    connect(&m_document, &document::Document::libraryChanged, this, [this] { takeLibrary({}); });
    fitCarriers();
    m_yarnList->setCurrentIndex(m_yarns.index(0));
}

QLabel* YarnPanel::makeHeading(const QString& text) {
    auto* heading = new QLabel(text, this);
    QFont bold = heading->font();
    bold.setBold(true);
    heading->setFont(bold);
    return heading;
}

QWidget* YarnPanel::makeCarriers() {
    m_carrierList = makeList(this, m_carriers, "carrierList", tr("Carriers"));
    m_carrierList->setAcceptDrops(true);
    m_carrierList->setDropIndicatorShown(true);
    m_carrierList->setDragDropMode(QAbstractItemView::DropOnly);
    connect(m_carrierList, &QListView::activated, this, &YarnPanel::chooseColour);
    connect(m_carrierList->selectionModel(), &QItemSelectionModel::currentChanged, this, [this] {
        m_showsCarrier = true;
        showDetails();
    });
    return m_carrierList;
}

QWidget* YarnPanel::makeLibrary() {
    m_search = new QLineEdit(this);
    m_search->setObjectName(QStringLiteral("yarnSearch"));
    m_search->setPlaceholderText(tr("Search yarns"));
    m_search->setAccessibleName(tr("Search yarns"));
    m_search->setToolTip(tr("Name, fibre or count (Ctrl+F)"));
    m_search->setClearButtonEnabled(true);
    m_search->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    m_yarnList = makeList(this, m_yarns, "yarnList", tr("Yarn library"));
    m_yarnList->setDragEnabled(true);
    m_yarnList->setDragDropMode(QAbstractItemView::DragOnly);
    connect(m_search, &QLineEdit::textChanged, this, [this](const QString& text) {
        m_yarns.setSearch(text);
        m_yarnList->setCurrentIndex(m_yarns.index(0));
    });
    connect(m_yarnList, &QListView::activated, this, &YarnPanel::assign);
    const auto chosen = [this] {
        m_showsCarrier = false;
        showDetails();
    };
    connect(m_yarnList->selectionModel(), &QItemSelectionModel::currentChanged, this, chosen);
    connect(m_yarnList, &QListView::clicked, this, chosen);

    auto* library = new QWidget(this);
    auto* layout = new QVBoxLayout(library);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(5);
    m_filter = new QComboBox(this);
    m_filter->setObjectName(QStringLiteral("yarnFilter"));
    m_filter->setAccessibleName(tr("Which yarns"));
    m_filter->setToolTip(tr("Shows all yarns, your own, or those of one fibre"));
    m_filter->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    connect(m_filter, &QComboBox::activated, this, &YarnPanel::takeFilter);
    auto* own = new QToolButton(this);
    own->setObjectName(QStringLiteral("ownYarns"));
    own->setText(tr("Own"));
    own->setToolTip(tr("Add, change, import and export yarns of your own"));
    own->setPopupMode(QToolButton::InstantPopup);
    own->setMenu(makeOwnMenu());
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    row->addWidget(m_search, 4);
    row->addWidget(m_filter, 3);
    row->addWidget(own);
    layout->addLayout(row);
    layout->addWidget(m_yarnList, 1);
    takeLibrary({});
    return library;
}

void YarnPanel::build() {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 6, 8, 8);
    layout->setSpacing(5);
    layout->addWidget(makeHeading(tr("Carriers")));
    layout->addWidget(new ColourwayBar(m_document, this));
    layout->addWidget(makeCarriers());
    layout->addSpacing(2);
    layout->addWidget(makeHeading(tr("Library")));

    m_details = new QTextBrowser(this);
    m_details->setObjectName(QStringLiteral("yarnDetails"));
    m_details->setAccessibleName(tr("Details of the yarn"));
    m_details->setMinimumHeight(60);
    m_assign = new QPushButton(this);
    m_assign->setObjectName(QStringLiteral("assignYarn"));
    m_assign->setToolTip(
        tr("Replaces the carrier's yarn; the fabric goes on from its shape (double click or Enter)"));
    connect(m_assign, &QPushButton::clicked, this, [this] { assign(m_yarnList->currentIndex()); });

    auto* split = new QSplitter(Qt::Vertical, this);
    split->setObjectName(QStringLiteral("yarnSplit"));
    split->setChildrenCollapsible(false);
    split->addWidget(makeLibrary());
    split->addWidget(m_details);
    split->setStretchFactor(0, 3);
    split->setStretchFactor(1, 2);
    layout->addWidget(split, 1);
    layout->addWidget(m_assign);
}

void YarnPanel::fitCarriers() {
    const int rows = std::clamp(m_carriers.rowCount(), 1, kCarriersShown);
    const int height = YarnDelegate()
                           .sizeHint(
                               [this] {
                                   QStyleOptionViewItem option;
                                   option.fontMetrics = m_carrierList->fontMetrics();
                                   return option;
                               }(),
                               {})
                           .height();
    m_carrierList->setFixedHeight(rows * height + 2 * m_carrierList->frameWidth() + 2);
    m_carrierList->setCurrentIndex(m_carriers.index(0));
    m_showsCarrier = false;
    showDetails();
}

void YarnPanel::search() {
    m_search->setFocus(Qt::ShortcutFocusReason);
    m_search->selectAll();
}

void YarnPanel::showDetails() {
    const int carrier = m_carriers.carrierAt(m_carrierList->currentIndex());
    const yarn::Yarn* chosen = m_yarns.yarnAt(m_yarnList->currentIndex());
    const yarn::Yarn* shown = m_showsCarrier && carrier >= 0
                                  ? &m_document.carriers()[static_cast<std::size_t>(carrier)].yarn
                                  : chosen;
    m_details->setHtml(shown ? yarnDetails(*shown, palette()) : QString());
    m_assign->setEnabled(carrier >= 0 && chosen);
    m_assign->setText(carrier >= 0
                          ? tr("Put on carrier %1")
                                .arg(QString::fromStdString(
                                    m_document.carriers()[static_cast<std::size_t>(carrier)].carrier))
                          : tr("Put on the carrier"));
}

void YarnPanel::assign(const QModelIndex& index) {
    const yarn::Yarn* chosen = m_yarns.yarnAt(index);
    const int carrier = m_carriers.carrierAt(m_carrierList->currentIndex());
    if (chosen && carrier >= 0) {
        m_document.assignYarn(carrier, *chosen);
    }
}

void YarnPanel::chooseColour(const QModelIndex& index) {
    const int carrier = m_carriers.carrierAt(index);
    const QColor before = index.data(ColourRole).value<QColor>();
    const QColor after = QColorDialog::getColor(before, this, tr("Colour of the carrier's yarn"));
    if (carrier >= 0 && after.isValid()) {
        m_document.setCarrierColour(carrier, {static_cast<std::uint8_t>(after.red()),
                                              static_cast<std::uint8_t>(after.green()),
                                              static_cast<std::uint8_t>(after.blue())});
    }
}

void YarnPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && m_details) {
        showDetails();
    }
    QWidget::changeEvent(event);
}

} // namespace knittsim::ui
