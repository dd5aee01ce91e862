#include "ui/window/machine_choice.h"

#include "core/machine/profile_library.h"

#include <QSignalBlocker>

namespace knittsim::ui {

namespace {

const QString kAdd = QStringLiteral("*"); // no id

} // namespace

MachineChoice::MachineChoice(document::Document& document, QWidget* parent)
    : QComboBox(parent), m_document(document) {
    setObjectName(QStringLiteral("machineChoice"));
    setAccessibleName(tr("Machine"));
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(34);
    setFocusPolicy(Qt::StrongFocus);
    reload();
    connect(this, &QComboBox::activated, this, &MachineChoice::choose);
    connect(&m_document, &document::Document::fileChanged, this, &MachineChoice::show);
    connect(&m_document, &document::Document::machineChanged, this, &MachineChoice::show);
}

Diagnostics MachineChoice::reload() {
    Diagnostics problems;
    const auto library = machine::ProfileLibrary::read(machine::profileFolders(), problems);
    const QSignalBlocker quiet(this);
    clear();
    addItem(QString(), QString());
    for (const machine::MachineProfile& profile : library.profiles()) {
        addItem(QString::fromStdString(profile.name), QString::fromStdString(profile.id));
        setItemData(count() - 1, QString::fromStdString(profile.id), Qt::ToolTipRole);
    }
    insertSeparator(count());
    addItem(tr("Add machine\u2026"), kAdd);
    show();
    return problems;
}

void MachineChoice::choose(int index) {
    const QString id = itemData(index).toString();
    if (id == kAdd) {
        show();
        emit addWanted();
    } else if (id != m_document.chosenMachine()) {
        m_document.setMachine(id);
    }
}

void MachineChoice::show() {
    const auto file = m_document.file();
    setItemText(0, file ? tr("As the file says: %1").arg(file->machineOfFile) : tr("As the file says"));
    const int index = findData(m_document.chosenMachine());
    setCurrentIndex(index < 0 ? 0 : index);
    setToolTip(tr("Machine: %1. Another one checks the program again and feeds its own loop lengths.")
                   .arg(currentText()));
}

} // namespace knittsim::ui
