#include "ui/views/chart_editor/palettes.h"

#include "core/pattern/own_modules.h"
#include "ui/document/message_text.h"
#include "ui/views/chart_editor/own_module_dialogs.h"
#include "ui/views/chart_editor/stitch_picture.h"
#include "ui/views/style/appearance.h"

#include <QButtonGroup>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidgetAction>

#include <algorithm>
#include <array>

namespace knittsim::ui {

using pattern::Stitch;

namespace {

constexpr int kSwatch = 22;
constexpr int kModuleWidth = 112;     ///< pixels, of a picture with its name
constexpr std::size_t kFewYarns = 4;  ///< so many leave room for words
constexpr std::size_t kMostYarns = 8; ///< that a chart made here has; machines have few carriers

QIcon stitchIcon(Stitch stitch, SymbolSet symbols, const QWidget& widget) {
    const double ratio = widget.devicePixelRatioF();
    QPixmap pixmap(QSize(20, 20) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    if (symbols == SymbolSet::Craft) { // there knit is an empty cell
        painter.setPen(accentsOf(widget.palette()).faintText);
        painter.drawRect(QRectF(0.5, 1.5, 19, 17));
    }
    paintStitch(painter, {1, 2, 18, 16}, stitch, symbols, widget.palette().color(QPalette::ButtonText));
    painter.end();
    return pixmap;
}

QIcon swatch(const QColor& colour, double ratio) {
    QPixmap pixmap(QSize(kSwatch, kSwatch) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(colour);
    painter.setPen(QPen(QColor(128, 128, 128), 1));
    painter.drawRoundedRect(QRectF(2.5, 2.5, kSwatch - 5, kSwatch - 5), 3, 3);
    painter.end();
    return pixmap;
}

QString groupName(pattern::ModuleGroup group) {
    switch (group) {
    case pattern::ModuleGroup::Texture:
        return CataloguePopup::tr("texture");
    case pattern::ModuleGroup::Cable:
        return CataloguePopup::tr("cable");
    case pattern::ModuleGroup::Lace:
        return CataloguePopup::tr("lace");
    case pattern::ModuleGroup::TuckAndSlip:
        return CataloguePopup::tr("tuck and slip");
    case pattern::ModuleGroup::Shaping:
        break;
    }
    return CataloguePopup::tr("shaping");
}

} // namespace

StitchPalette::StitchPalette(ChartLook& look, QWidget* parent)
    : QWidget(parent), m_look(look), m_buttons(new QButtonGroup(this)) {
    auto* rows = new QGridLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(1);
    m_buttons->setExclusive(false);
    std::array<int, 2> places{}; // stitches of two beds stand below
    for (const Stitch stitch : {Stitch::Knit, Stitch::Purl, Stitch::Tuck, Stitch::Miss, Stitch::Rest,
                                Stitch::Empty, Stitch::Drop, Stitch::Both, Stitch::KnitTuck, Stitch::TuckKnit,
                                Stitch::TuckBoth, Stitch::RearTuck, Stitch::RearMiss}) {
        auto* button = new QToolButton(this);
        button->setObjectName(QStringLiteral("stitch%1").arg(static_cast<int>(stitch)));
        button->setCheckable(true);
        button->setAutoRaise(true);
        button->setIconSize({20, 20});
        button->setToolTip(tr("%1 (E and Shift+E go through the stitches; with Shift the yarn stays chosen)")
                               .arg(stitchName(stitch)));
        button->setAccessibleName(stitchName(stitch));
        m_buttons->addButton(button, static_cast<int>(stitch));
        const int row = pattern::needsTwoBeds(stitch) ? 1 : 0;
        rows->addWidget(button, row, places[static_cast<std::size_t>(row)]++);
        connect(button, &QToolButton::clicked, this, [this, stitch](bool on) {
            choose(on ? std::optional(stitch) : std::nullopt);
            emit changed();
        });
    }
    rows->setColumnStretch(places[0], 1);
    connect(&m_look, &ChartLook::changed, this, &StitchPalette::takeLook);
    takeLook();
}

void StitchPalette::takeLook() {
    for (QAbstractButton* button : m_buttons->buttons()) {
        button->setIcon(stitchIcon(static_cast<Stitch>(m_buttons->id(button)), m_look.symbols(), *this));
    }
}

void StitchPalette::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        takeLook();
    }
    QWidget::changeEvent(event);
}

void StitchPalette::setTwoBeds(bool two) {
    bool gone = false;
    for (QAbstractButton* button : m_buttons->buttons()) {
        if (pattern::needsTwoBeds(static_cast<Stitch>(m_buttons->id(button)))) {
            button->setVisible(two);
            gone = gone || (!two && button->isChecked());
        }
    }
    if (gone) {
        choose(Stitch::Knit);
        emit changed();
    }
}

void StitchPalette::choose(std::optional<Stitch> stitch) {
    for (QAbstractButton* button : m_buttons->buttons()) {
        button->setChecked(stitch && m_buttons->id(button) == static_cast<int>(*stitch));
    }
}

std::optional<Stitch> StitchPalette::chosen() const {
    for (QAbstractButton* button : m_buttons->buttons()) {
        if (button->isChecked()) {
            return static_cast<Stitch>(m_buttons->id(button));
        }
    }
    return std::nullopt;
}

void StitchPalette::step(int direction) {
    QList<QAbstractButton*> offered;
    for (QAbstractButton* button : m_buttons->buttons()) {
        if (button->isVisibleTo(this)) {
            offered << button;
        }
    }
    const auto checked = std::ranges::find_if(offered, &QAbstractButton::isChecked);
    const auto count = offered.size();
    const auto at = checked == offered.end() ? (direction > 0 ? count - 1 : 0) : checked - offered.begin();
    choose(static_cast<Stitch>(m_buttons->id(offered[(at + direction + count) % count])));
    emit changed();
}

YarnPalette::YarnPalette(document::Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_row(new QHBoxLayout(this)) {
    m_row->setContentsMargins(0, 0, 0, 0);
    m_row->setSpacing(1);
    connect(&m_document, &document::Document::chartChanged, this, &YarnPalette::take);
    connect(&m_document, &document::Document::yarnsChanged, this, &YarnPalette::take);
    take();
}

void YarnPalette::take() {
    while (QLayoutItem* item = m_row->takeAt(0)) {
        if (QWidget* button = item->widget()) {
            button->hide();
            button->deleteLater(); // it may be the one that was clicked
        }
        delete item;
    }
    const auto project = m_document.project();
    if (!project) {
        return;
    }
    const auto& yarns = project->chart.yarns;
    if (m_chosen && *m_chosen >= yarns.size()) {
        m_chosen.reset();
        emit changed();
    }
    for (std::size_t i = 0; i < yarns.size(); ++i) {
        const auto index = static_cast<std::uint8_t>(i);
        QColor colour(yarns[i].colour.r, yarns[i].colour.g, yarns[i].colour.b);
        QString name;
        for (const document::CarrierYarn& carrier : m_document.carriers()) {
            if (carrier.carrier == yarns[i].carrier) {
                colour = QColor(carrier.yarn.colour.r, carrier.yarn.colour.g, carrier.yarn.colour.b);
                name = QString::fromStdString(carrier.yarn.name);
            }
        }
        auto* button = new QToolButton(this);
        button->setObjectName(QStringLiteral("yarn%1").arg(i));
        button->setCheckable(true);
        button->setAutoRaise(true);
        button->setChecked(m_chosen == index);
        button->setIconSize({kSwatch, kSwatch});
        button->setIcon(swatch(colour, devicePixelRatioF()));
        button->setAccessibleName(
            tr("Yarn of carrier %1: %2").arg(QString::fromStdString(yarns[i].carrier), name));
        button->setToolTip(tr("%1 (O and Shift+O go through the yarns; with Shift the stitch stays chosen)")
                               .arg(button->accessibleName()));
        m_row->addWidget(button);
        connect(button, &QToolButton::clicked, this, [this, index](bool on) {
            choose(on ? std::optional(index) : std::nullopt);
            emit changed();
        });
    }
    if (yarns.size() < std::min(kMostYarns, m_document.carriers().size())) {
        auto* add = new QToolButton(this);
        add->setObjectName(QStringLiteral("addYarn"));
        add->setText(yarns.size() < kFewYarns ? tr("+ Yarn") : QStringLiteral("+"));
        add->setAutoRaise(true);
        add->setToolTip(tr("Add a yarn on the next carrier"));
        m_row->addWidget(add);
        connect(add, &QToolButton::clicked, this, &YarnPalette::addYarn);
    }
    m_row->addStretch();
}

void YarnPalette::choose(std::optional<std::uint8_t> yarn) {
    m_chosen = yarn;
    take();
}

void YarnPalette::step(int direction) {
    const auto project = m_document.project();
    if (!project) {
        return;
    }
    const int count = static_cast<int>(project->chart.yarns.size());
    const int at = m_chosen ? *m_chosen : direction > 0 ? count - 1 : 0;
    choose(static_cast<std::uint8_t>((at + direction + count) % count));
    emit changed();
}

void YarnPalette::addYarn() {
    const auto file = m_document.file();
    const auto project = m_document.project();
    const auto& yarns = project->chart.yarns;
    for (const document::CarrierYarn& carrier : m_document.carriers()) {
        const bool taken = std::ranges::any_of(
            yarns, [&](const pattern::ChartYarn& yarn) { return yarn.carrier == carrier.carrier; });
        if (!taken) {
            m_chosen = static_cast<std::uint8_t>(yarns.size());
            const pattern::ChartYarn added{carrier.carrier, freshColour(yarns.size()),
                                           yarns.front().libraryId};
            m_document.editChart(tr("another yarn"),
                                 [&](pattern::Chart& chart) { chart.yarns.push_back(added); });
            emit changed();
            return;
        }
    }
}

yarn::Colour freshColour(std::size_t index) {
    static constexpr yarn::Colour kColours[] = {{0xe9, 0xdf, 0xc8}, {0x24, 0x3b, 0x5e}, {0xb5, 0x52, 0x33},
                                                {0xd9, 0xa6, 0x2e}, {0x3f, 0x6b, 0x4f}, {0x6d, 0x35, 0x5a},
                                                {0x1f, 0x6f, 0x78}, {0xcb, 0xb3, 0x96}};
    return kColours[index % std::size(kColours)];
}

CataloguePopup::CataloguePopup(ChartLook& look, QWidget* parent)
    : QMenu(parent), m_look(look), m_search(new QLineEdit(this)), m_list(new QListWidget(this)) {
    setObjectName(QStringLiteral("catalogue"));
    m_list->setObjectName(QStringLiteral("catalogueList"));
    m_list->setAccessibleName(tr("Stitch catalogue"));
    m_list->setViewMode(QListView::IconMode);
    m_list->setMovement(QListView::Static);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setIconSize({76, 60});
    const QSize grid(kModuleWidth, m_list->iconSize().height() + 3 * fontMetrics().lineSpacing() + 14);
    m_list->setGridSize(grid);
    m_list->setWordWrap(true);
    m_list->setUniformItemSizes(true);
    m_list->setFixedSize(grid.width() * 5 + 24, grid.height() * 4 + 12);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->verticalScrollBar()->setSingleStep(grid.height() / 3);
    m_search->setObjectName(QStringLiteral("catalogueSearch"));
    m_search->setPlaceholderText(tr("Search: cable, lace, rib\u2026"));
    m_search->setAccessibleName(tr("Search the stitch catalogue"));
    m_search->setToolTip(tr("Words of the name, or the kind: texture, cable, lace, tuck and slip, shaping"));
    m_search->setClearButtonEnabled(true);
    connect(m_search, &QLineEdit::textChanged, this, &CataloguePopup::find);
    auto* page = new QWidget(this);
    auto* rows = new QVBoxLayout(page);
    rows->setContentsMargins(6, 6, 6, 6);
    rows->addWidget(m_search);
    rows->addWidget(m_list);
    auto* action = new QWidgetAction(this);
    action->setDefaultWidget(page);
    addAction(action);
    const auto take = [this](const QListWidgetItem* item) {
        const std::string id = item->data(Qt::UserRole).toString().toStdString();
        const auto own = std::ranges::find(m_own, id, &pattern::Module::id);
        m_chosen = own != m_own.end() ? *own : *pattern::findModule(id);
        close();
        emit chosen(&m_chosen);
    };
    connect(m_list, &QListWidget::itemClicked, this, take);
    connect(m_list, &QListWidget::itemActivated, this, take);
    addOwnActions();
    connect(m_search, &QLineEdit::returnPressed, this, [this, take] {
        if (const QListWidgetItem* item = m_list->currentItem()) {
            take(item);
        }
    });
    connect(this, &QMenu::aboutToShow, this, [this] {
        fill();
        find(m_search->text());
        m_search->selectAll();
        m_search->setFocus();
    });
    m_search->installEventFilter(this);
}

/// From the search the arrow keys lead into the pictures.
bool CataloguePopup::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Down || key == Qt::Key_Up || key == Qt::Key_Tab) {
            m_list->setFocus();
            return true;
        }
    }
    return QMenu::eventFilter(watched, event);
}

/// Shows what has all the words in its name or kind.
void CataloguePopup::find(const QString& text) {
    const QStringList words = text.split(u' ', Qt::SkipEmptyParts);
    QListWidgetItem* first = nullptr;
    for (int i = 0; i < m_list->count(); ++i) {
        QListWidgetItem* item = m_list->item(i);
        const bool found = std::ranges::all_of(words, [item](const QString& word) {
            return item->toolTip().contains(word, Qt::CaseInsensitive);
        });
        item->setHidden(!found);
        first = first || !found ? first : item;
    }
    m_list->setCurrentItem(first);
    m_list->scrollToTop();
}

/// Anew each time: the pictures are in the colours of the appearance.
void CataloguePopup::fill() {
    m_list->clear();
    for (const pattern::Module& module : pattern::catalogue()) {
        addItem(module, groupName(module.group));
    }
    Diagnostics problems;
    m_own = pattern::readOwnModules(pattern::ownModuleFolder(), problems);
    for (const pattern::Module& module : m_own) {
        addItem(module, tr("your own"));
    }
    for (const Diagnostic& problem : problems) {
        emit problemFound(QString::fromStdString(problem.place.file) + QStringLiteral(": ") +
                          document::causeText(problem));
    }
}

void CataloguePopup::addItem(const pattern::Module& module, const QString& kind) {
    const QString name = QString::fromStdString(module.name);
    auto* item = new QListWidgetItem(
        QIcon(pictureOf(module.part, m_list->iconSize(), devicePixelRatioF(), palette(), m_look.symbols())),
        name, m_list);
    item->setData(Qt::UserRole, QString::fromStdString(module.id));
    item->setToolTip(tr("%1 (%2), %3 wales x %4 courses")
                         .arg(name, kind)
                         .arg(module.part.width)
                         .arg(module.part.height()));
}

void CataloguePopup::addOwnActions() {
    const auto add = [this](const QString& text, const QKeySequence& key,
                            void (*change)(QWidget*, const QString&)) {
        auto* action = new QAction(text, m_list);
        action->setShortcut(key);
        action->setShortcutContext(Qt::WidgetShortcut);
        connect(action, &QAction::triggered, this, [this, change] {
            const QListWidgetItem* item = m_list->currentItem();
            const std::string id = item ? item->data(Qt::UserRole).toString().toStdString() : std::string();
            if (std::ranges::find(m_own, id, &pattern::Module::id) != m_own.end()) {
                const QString name = item->text();
                close();
                change(parentWidget(), name);
            }
        });
        m_list->addAction(action);
    };
    add(tr("&Rename your module\u2026"), Qt::CTRL | Qt::Key_F2, renameOwnModule);
    add(tr("&Delete your module\u2026"), Qt::CTRL | Qt::Key_Delete, removeOwnModule);
    m_list->setContextMenuPolicy(Qt::ActionsContextMenu);
}

} // namespace knittsim::ui
