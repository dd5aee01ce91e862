#include "ui/dialogs/key_dialog.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace knittsim::ui {

namespace {

QString plain(QString text) {
    return text.remove(u'&').remove(QChar(0x2026));
}

QTreeWidgetItem* addGroup(QTreeWidget* list, const QString& title) {
    auto* group = new QTreeWidgetItem(list, {title});
    QFont bold = list->font();
    bold.setBold(true);
    group->setFont(0, bold);
    group->setFlags(Qt::ItemIsEnabled);
    return group;
}

/// Of a menu and the menus in it.
QList<QAction*> actionsWithKeys(const QMenu* menu) {
    QList<QAction*> found;
    for (QAction* action : menu ? menu->actions() : QList<QAction*>()) {
        if (action->menu()) {
            found += actionsWithKeys(action->menu());
        } else if (!action->shortcut().isEmpty()) {
            found << action;
        }
    }
    return found;
}

void addMouse(QTreeWidget* list) {
    QTreeWidgetItem* group = addGroup(list, KeyDialog::tr("Mouse"));
    const std::initializer_list<std::pair<QString, QString>> uses{
        {KeyDialog::tr("Turn the fabric"), KeyDialog::tr("left drag")},
        {KeyDialog::tr("Move the fabric"), KeyDialog::tr("middle drag, or Shift and left drag")},
        {KeyDialog::tr("Zoom at the cursor"), KeyDialog::tr("wheel; in the pattern grid Ctrl and wheel")},
        {KeyDialog::tr("Move the section"), KeyDialog::tr("Alt and wheel")},
        {KeyDialog::tr("Select a stitch"), KeyDialog::tr("click in fabric, grid or source")},
        {KeyDialog::tr("Pull the yarn"), KeyDialog::tr("Ctrl and left drag on yarn")},
        {KeyDialog::tr("Pick stitch and yarn"), KeyDialog::tr("right click in the chart")},
        {KeyDialog::tr("Move or repeat a selection"), KeyDialog::tr("drag it, or its edge")},
        {KeyDialog::tr("Draw stitch and yarn at once"), KeyDialog::tr("Shift and click the second of them")},
        {KeyDialog::tr("Put a yarn on a carrier"), KeyDialog::tr("drag, or double click in the library")}};
    for (const auto& [what, how] : uses) {
        new QTreeWidgetItem(group, {what, how});
    }
}

void addFocus(QTreeWidget* list) {
    QTreeWidgetItem* group = addGroup(list, KeyDialog::tr("Wherever the focus is"));
    const std::initializer_list<std::pair<QString, QString>> uses{
        {KeyDialog::tr("Step the machine"), KeyDialog::tr("Space, arrows, Home, End")},
        {KeyDialog::tr("Walk a list, move a slider, choose"), KeyDialog::tr("Ctrl and these keys")},
        {KeyDialog::tr("Press a button"), KeyDialog::tr("Enter, or Ctrl and Space")},
        {KeyDialog::tr("Kept in the layouts Designer and Quality"),
         KeyDialog::tr("all of them where text is written, arrows in charts")}};
    for (const auto& [what, how] : uses) {
        new QTreeWidgetItem(group, {what, how});
    }
}

/// Shows what has `words` in it or lies in a group that has; a group without any is hidden.
void showOnly(const QTreeWidget* list, const QString& words) {
    const auto has = [&words](const QTreeWidgetItem* item) {
        return item->text(0).contains(words, Qt::CaseInsensitive) ||
               item->text(1).contains(words, Qt::CaseInsensitive);
    };
    for (int g = 0; g < list->topLevelItemCount(); ++g) {
        QTreeWidgetItem* group = list->topLevelItem(g);
        bool any = false;
        for (int i = 0; i < group->childCount(); ++i) {
            const bool shown = has(group) || has(group->child(i));
            group->child(i)->setHidden(!shown);
            any = any || shown;
        }
        group->setHidden(!any);
    }
}

} // namespace

KeyDialog::KeyDialog(const QMenuBar* menus, QWidget* parent) : QDialog(parent) {
    setObjectName(QStringLiteral("keyDialog"));
    setWindowTitle(tr("Keys"));
    auto* list = new QTreeWidget(this);
    list->setObjectName(QStringLiteral("keyList"));
    list->setColumnCount(2);
    list->setHeaderLabels({tr("What"), tr("Key")});
    list->setRootIsDecorated(false);
    list->setAlternatingRowColors(true);
    list->setStyleSheet(QStringLiteral("QTreeView::item { padding: 2px 0 }")); // dots on capitals have room
    for (const QAction* entry : menus->actions()) {
        QTreeWidgetItem* group = nullptr;
        for (const QAction* action : actionsWithKeys(entry->menu())) {
            group = group ? group : addGroup(list, plain(entry->text()));
            new QTreeWidgetItem(
                group, {plain(action->text()), action->shortcut().toString(QKeySequence::NativeText)});
        }
    }
    addFocus(list);
    addMouse(list);
    list->expandAll();
    list->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* search = new QLineEdit(this);
    search->setObjectName(QStringLiteral("keySearch"));
    search->setPlaceholderText(tr("Search what is done, or a key"));
    search->setToolTip(search->placeholderText());
    search->setClearButtonEnabled(true);
    connect(search, &QLineEdit::textChanged, list, [list](const QString& words) { showOnly(list, words); });
    auto* rows = new QVBoxLayout(this);
    rows->addWidget(search);
    rows->addWidget(list, 1);
    rows->addWidget(buttons);
    resize(520, 560);
}

} // namespace knittsim::ui
