#include "ui/dialogs/yarn_choice_dialog.h"
#include "ui/window/comparison.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QFileDialog>
#include <QMenu>

namespace knittsim::ui {

void MainWindow::buildCompareMenu(QMenu* view) {
    QMenu* menu = view->addMenu(tr("Compare side b&y side"));
    menu->setObjectName(QStringLiteral("compareMenu"));
    menu->setToolTipsVisible(true);
    QAction* keep = addAction(menu, "actionKeepState", tr("&Keep this state beside"), Qt::CTRL | Qt::Key_K,
                              {}, [this] { m_comparison->keepState(); });
    keep->setToolTip(tr("Keeps the fabric as it is now beside the one that goes on (Ctrl+K)"));
    addAction(menu, "actionCompareFile", tr("With another &file\u2026"), Qt::CTRL | Qt::SHIFT | Qt::Key_K, {},
              [this] { compareWithFile(); });
    addAction(menu, "actionCompareYarn", tr("With another &yarn\u2026"), Qt::CTRL | Qt::Key_Y, {},
              [this] { compareWithYarn(); });
    menu->addSeparator();
    QAction* link =
        addChoice(menu, nullptr, "actionLinkCameras", tr("&Link the cameras"), Qt::Key_J, {}, [] {});
    connect(link, &QAction::toggled, m_comparison, &Comparison::setLinked);
    addAction(menu, "actionCloseComparison", tr("&Close the comparison"), Qt::CTRL | Qt::ALT | Qt::Key_K, {},
              [this] { m_comparison->close(); });
}

void MainWindow::takeCompareActions() {
    const bool open = m_document.file() != nullptr;
    for (const char* name : {"actionKeepState", "actionCompareFile", "actionCompareYarn"}) {
        findChild<QAction*>(QString::fromLatin1(name))->setEnabled(open);
    }
    QAction* link = findChild<QAction*>(QStringLiteral("actionLinkCameras"));
    link->setChecked(m_comparison->isLinked());
    link->setEnabled(m_comparison->isOpen());
    findChild<QAction*>(QStringLiteral("actionCloseComparison"))->setEnabled(m_comparison->isOpen());
}

void MainWindow::compareWithFile() {
    const QString path = QFileDialog::getOpenFileName(this, tr("Compare with a chart or a machine program"),
                                                      m_session.lastFolder(), openFilter());
    if (!path.isEmpty()) {
        m_comparison->openFile(path);
    }
}

void MainWindow::compareWithYarn() {
    auto* dialog = new YarnChoiceDialog(m_document, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &YarnChoiceDialog::chosen, m_comparison, &Comparison::openYarn);
    dialog->open();
}

} // namespace knittsim::ui
