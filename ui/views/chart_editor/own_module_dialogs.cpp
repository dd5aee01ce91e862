#include "ui/views/chart_editor/own_module_dialogs.h"

#include "core/pattern/own_modules.h"
#include "ui/document/message_text.h"

#include <QCoreApplication>
#include <QInputDialog>
#include <QMessageBox>

#include <functional>

namespace knittsim::ui {

namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("knittsim::ui", text);
}

bool askName(QWidget* parent, const QString& title, QString name,
             const std::function<Diagnostics(const std::string&)>& use) {
    QString question = tr("Name of the module");
    while (true) {
        bool ok = false;
        name = QInputDialog::getText(parent, title, question, QLineEdit::Normal, name, &ok).trimmed();
        if (!ok) {
            return false;
        }
        const Diagnostics problems = use(name.toStdString());
        if (problems.empty()) {
            return true;
        }
        question = document::causeText(problems.front()) + u' ' + document::cureText(problems.front());
    }
}

} // namespace

bool saveAsOwnModule(QWidget* parent, const pattern::Chart& part) {
    return askName(parent, tr("Save as a module"), {}, [&](const std::string& name) {
        return pattern::saveOwnModule(pattern::ownModuleFolder(), name, part);
    });
}

void renameOwnModule(QWidget* parent, const QString& name) {
    askName(parent, tr("Rename the module"), name, [&](const std::string& newName) {
        return newName == name.toStdString()
                   ? Diagnostics{}
                   : pattern::renameOwnModule(pattern::ownModuleFolder(), name.toStdString(), newName);
    });
}

void removeOwnModule(QWidget* parent, const QString& name) {
    if (QMessageBox::question(parent, tr("Delete the module"),
                              tr("Delete the module %1 for good?").arg(name)) != QMessageBox::Yes) {
        return;
    }
    const Diagnostics problems = pattern::removeOwnModule(pattern::ownModuleFolder(), name.toStdString());
    if (!problems.empty()) {
        QMessageBox::warning(parent, tr("Delete the module"), document::causeText(problems.front()));
    }
}

} // namespace knittsim::ui
