// The part of the panel that keeps a person's own yarns.

#include "core/base/file.h"
#include "core/yarn/own_yarns.h"
#include "ui/document/message_text.h"
#include "ui/views/yarn_library/yarn_dialog.h"
#include "ui/views/yarn_library/yarn_panel.h"

#include <QComboBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMessageBox>

#include <algorithm>
#include <iterator>

namespace knittsim::ui {

namespace {

constexpr int kAll = 0;
constexpr int kOwn = 1;
constexpr std::size_t kMostTold = 6; ///< problems in one message

std::filesystem::path ownFolder() {
    return document::Document::ownYarnFolder().toStdString();
}

} // namespace

QMenu* YarnPanel::makeOwnMenu() {
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("ownYarnMenu"));
    menu->setToolTipsVisible(true);
    const auto chosen = [this] { return m_yarns.yarnAt(m_yarnList->currentIndex()); };
    QAction* add = menu->addAction(tr("&New yarn like this one\u2026"), this, [this, chosen] {
        yarn::Yarn yarn = chosen() ? *chosen() : yarn::defaultYarn();
        yarn.id.clear();
        yarn.name = tr("My %1").arg(QString::fromStdString(yarn.name)).toStdString();
        editYarn(yarn);
    });
    add->setToolTip(tr("A copy that is yours"));
    QAction* edit = menu->addAction(tr("&Change\u2026"), this, [this, chosen] { editYarn(*chosen()); });
    QAction* forget = menu->addAction(tr("&Delete"), this, &YarnPanel::forgetYarn);
    menu->addSeparator();
    menu->addAction(tr("&Import\u2026"), this, &YarnPanel::importYarns);
    QAction* out = menu->addAction(tr("&Export this yarn\u2026"), this, &YarnPanel::exportYarn);
    QAction* all = menu->addAction(tr("Export all &own yarns\u2026"), this, &YarnPanel::exportOwnYarns);
    all->setToolTip(tr("One file, for other people or a version control"));
    connect(menu, &QMenu::aboutToShow, this, [this, chosen, edit, forget, out, all] {
        all->setEnabled(!ownYarns().empty());
        const bool own = chosen() && yarn::isOwn(ownFolder(), chosen()->id);
        edit->setEnabled(own);
        forget->setEnabled(own);
        out->setEnabled(chosen() != nullptr);
    });
    return menu;
}

void YarnPanel::editYarn(const yarn::Yarn& yarn) {
    auto* dialog = new YarnDialog(yarn, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, fresh = yarn.id.empty()] {
        yarn::Yarn made = dialog->yarn();
        // Another yarn of this name is not overwritten.
        const std::string id = made.id;
        for (int i = 2; fresh && m_document.library().find(made.id); ++i) {
            made.id = id + '-' + std::to_string(i);
        }
        const Diagnostics problems = yarn::keepYarn(ownFolder(), made);
        if (hasErrors(problems)) {
            tellProblem(tr("The yarn could not be saved"), problems);
            return;
        }
        m_document.reloadLibrary();
        takeLibrary(made.id);
    });
    dialog->open();
}

/// Empty: nowhere.
QString YarnPanel::askWhere(const QString& title, const QString& name) {
    QFileDialog dialog(this, title, name, tr("Yarns (*.json)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("json"));
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

void YarnPanel::importYarns() {
    const QStringList paths = QFileDialog::getOpenFileNames(this, tr("Import yarns"), QString(),
                                                            tr("Yarns (*.json);;All files (*)"));
    std::string first;
    for (const QString& path : paths) {
        const auto imported = yarn::importYarns(path.toStdString(), ownFolder());
        if (!imported) {
            tellProblem(tr("%1 holds no yarns that can be read").arg(path), imported.diagnostics());
        } else if (first.empty() && !imported.value().empty()) {
            first = imported.value().front().id;
        }
    }
    if (!first.empty()) { // all of them are seen, whatever was searched before
        m_search->clear();
        m_filter->setCurrentIndex(kOwn);
        m_document.reloadLibrary();
        takeLibrary(first);
    }
}

void YarnPanel::exportYarn() {
    const yarn::Yarn* chosen = m_yarns.yarnAt(m_yarnList->currentIndex());
    if (!chosen) {
        return;
    }
    const yarn::Yarn yarn = *chosen; // the library may change while the dialog is open
    writeYarns(askWhere(tr("Export the yarn"), QString::fromStdString(yarn.id + ".json")),
               yarn::toJson(yarn));
}

void YarnPanel::exportOwnYarns() {
    writeYarns(askWhere(tr("Export all own yarns"), QStringLiteral("yarns.json")), yarn::toJson(ownYarns()));
}

std::vector<yarn::Yarn> YarnPanel::ownYarns() const {
    std::vector<yarn::Yarn> own;
    std::ranges::copy_if(m_document.library().yarns(), std::back_inserter(own),
                         [](const yarn::Yarn& yarn) { return yarn::isOwn(ownFolder(), yarn.id); });
    return own;
}

/// Nothing where there is no path.
void YarnPanel::writeYarns(const QString& path, const std::string& json) {
    if (path.isEmpty()) {
        return;
    }
    const auto written = writeFileAtomically(path.toStdString(), json);
    if (!written) {
        tellProblem(tr("The yarns could not be written"), written.diagnostics());
    }
}

void YarnPanel::forgetYarn() {
    const yarn::Yarn* chosen = m_yarns.yarnAt(m_yarnList->currentIndex());
    if (chosen && QMessageBox::question(this, tr("Delete the yarn"),
                                        tr("Delete %1 from your yarns? Fabrics that use it keep it.")
                                            .arg(QString::fromStdString(chosen->name))) == QMessageBox::Yes) {
        yarn::forgetYarn(ownFolder(), chosen->id);
        m_document.reloadLibrary();
    }
}

void YarnPanel::tellProblem(const QString& title, const Diagnostics& problems) {
    QString text = title + QStringLiteral(".");
    for (std::size_t i = 0; i < std::min(problems.size(), kMostTold); ++i) {
        text += u'\n' + document::causeText(problems[i]);
    }
    QMessageBox::warning(this, title, text);
}

/// `select`: id of the yarn to show; empty: the first.
void YarnPanel::takeLibrary(const std::string& select) {
    m_yarns.setLibrary(m_document.sharedLibrary());
    const QString before = m_filter->currentText();
    m_filter->clear();
    m_filter->addItems({tr("All yarns"), tr("Your own")});
    m_filter->addItems(m_yarns.fibres());
    m_filter->setCurrentIndex(std::max(0, m_filter->findText(before)));
    takeFilter();
    QModelIndex found = select.empty() ? QModelIndex() : m_yarns.indexOf(select);
    if (!select.empty() && !found.isValid()) { // a search hides it
        m_search->clear();
        m_filter->setCurrentIndex(kAll);
        takeFilter();
        found = m_yarns.indexOf(select);
    }
    m_yarnList->setCurrentIndex(found.isValid() ? found : m_yarns.index(0));
    m_yarnList->scrollTo(m_yarnList->currentIndex());
}

void YarnPanel::takeFilter() {
    const int index = m_filter->currentIndex();
    m_yarns.setOnlyOwn(index == kOwn);
    m_yarns.setFibre(index == kAll || index == kOwn ? QString() : m_filter->currentText());
    m_yarnList->setCurrentIndex(m_yarns.index(0));
}

} // namespace knittsim::ui
