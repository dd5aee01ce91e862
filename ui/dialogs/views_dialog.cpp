#include "ui/dialogs/views_dialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace knittsim::ui {

ViewsDialog::ViewsDialog(document::NamedViews& views, QWidget* parent)
    : QDialog(parent), m_views(views), m_list(new QListWidget(this)),
      m_show(new QPushButton(tr("&Show"), this)), m_rename(new QPushButton(tr("&Rename"), this)),
      m_delete(new QPushButton(tr("&Delete"), this)) {
    setObjectName(QStringLiteral("viewsDialog"));
    setWindowTitle(tr("Named views"));
    m_list->setObjectName(QStringLiteral("viewList"));
    m_list->setAccessibleName(tr("Named views"));
    m_list->setToolTip(tr("Double click shows a view, F2 renames it"));
    m_list->setSpacing(3);
    m_list->setEditTriggers(QAbstractItemView::EditKeyPressed);
    m_show->setToolTip(tr("Puts the camera there (Enter)"));
    m_show->setDefault(true);
    m_rename->setToolTip(tr("Gives the view another name (F2)"));
    m_delete->setObjectName(QStringLiteral("viewDelete"));
    m_delete->setToolTip(tr("Forgets the view"));
    auto* close = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_show);
    buttons->addWidget(m_rename);
    buttons->addWidget(m_delete);
    buttons->addStretch();
    buttons->addWidget(close);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(20, 18, 20, 14);
    rows->setSpacing(12);
    auto* help = new QLabel(tr("Double click shows a view, F2 renames it."), this);
    help->setForegroundRole(QPalette::PlaceholderText);
    rows->addWidget(help);
    rows->addWidget(m_list, 1);
    rows->addLayout(buttons);
    setMinimumWidth(420);
    connect(m_list, &QListWidget::itemChanged, this, &ViewsDialog::takeName);
    connect(m_list, &QListWidget::currentRowChanged, this, &ViewsDialog::takeCurrent);
    connect(m_list, &QListWidget::itemDoubleClicked, this,
            [this](const QListWidgetItem* item) { emit viewWanted(item->text()); });
    connect(m_show, &QPushButton::clicked, this, [this] { emit viewWanted(m_list->currentItem()->text()); });
    connect(m_rename, &QPushButton::clicked, this, [this] { m_list->editItem(m_list->currentItem()); });
    connect(m_delete, &QPushButton::clicked, this, &ViewsDialog::removeCurrent);
    connect(close, &QDialogButtonBox::rejected, this, &QDialog::reject);
    fill();
    m_list->setCurrentRow(0);
    takeCurrent();
}

void ViewsDialog::fill() {
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    for (const document::NamedView& view : m_views.views()) {
        auto* item = new QListWidgetItem(view.name, m_list);
        item->setData(Qt::UserRole, view.name);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
    }
}

/// A name that is empty or taken falls back to what it was.
void ViewsDialog::takeName(QListWidgetItem* item) {
    const QString before = item->data(Qt::UserRole).toString();
    if (item->text() == before) {
        return;
    }
    const bool renamed = m_views.rename(before, item->text());
    const QSignalBlocker quiet(m_list);
    item->setText(renamed ? item->text().trimmed() : before);
    item->setData(Qt::UserRole, item->text());
    if (renamed) {
        emit viewsChanged();
    }
}

void ViewsDialog::removeCurrent() {
    const int row = m_list->currentRow();
    m_views.remove(m_list->currentItem()->text());
    fill();
    m_list->setCurrentRow(std::min(row, m_list->count() - 1));
    takeCurrent();
    emit viewsChanged();
}

void ViewsDialog::takeCurrent() {
    for (QPushButton* button : {m_show, m_rename, m_delete}) {
        button->setEnabled(m_list->currentItem() != nullptr);
    }
}

} // namespace knittsim::ui
