#include "ui/dialogs/views_dialog.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/window/main_window.h"

#include <QInputDialog>
#include <QMenu>
#include <QStatusBar>

namespace knittsim::ui {

void MainWindow::buildViewsMenu(QMenu* view) {
    m_viewsMenu = view->addMenu(tr("Na&med views"));
    m_viewsMenu->setObjectName(QStringLiteral("viewsMenu"));
    addAction(m_viewsMenu, "actionSaveView", tr("&Save this view\u2026"), Qt::Key_V, {},
              [this] { saveView(); });
    addAction(m_viewsMenu, "actionManageViews", tr("&Rename or delete\u2026"), Qt::SHIFT | Qt::Key_V, {},
              [this] { manageViews(); });
    m_viewsMenu->addSeparator();
    takeViews();
}

void MainWindow::recallViews() {
    m_views.setFile(m_document.path());
    takeViews();
}

/// A chart is seen as it was when it was saved.
void MainWindow::recallLook() {
    const std::filesystem::path path(m_document.path().toStdString());
    if (!m_document.project() || !pattern::isProjectFile(path)) {
        return;
    }
    const auto view = QByteArray::fromBase64(QByteArray::fromStdString(pattern::readLook(path).view));
    connect(
        &m_document, &document::Document::fabricShown, this,
        [this, view] {
            if (m_fabric->restoreCamera(view)) {
                takeActions(); // orthographic or not
            }
        },
        Qt::SingleShotConnection);
}

/// The menu has a line for each view.
void MainWindow::takeViews() {
    const QString kName = QStringLiteral("actionView_");
    for (QAction* action : m_viewsMenu->actions()) {
        if (action->objectName().startsWith(kName)) {
            delete action;
        }
    }
    for (const document::NamedView& view : m_views.views()) {
        QAction* action = m_viewsMenu->addAction(QString(view.name).replace(u'&', QStringLiteral("&&")), this,
                                                 [this, name = view.name] { recallView(name); });
        action->setObjectName(kName + view.name);
    }
    const bool open = m_document.file() != nullptr;
    findChild<QAction*>(QStringLiteral("actionSaveView"))->setEnabled(open);
    findChild<QAction*>(QStringLiteral("actionManageViews"))->setEnabled(!m_views.views().empty());
}

void MainWindow::saveView() {
    auto* dialog = new QInputDialog(this);
    dialog->setObjectName(QStringLiteral("saveViewDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Save this view"));
    dialog->setLabelText(tr("Name of the view; one of the same name is replaced:"));
    dialog->setOkButtonText(tr("&Save"));
    dialog->setTextValue(tr("View %1").arg(m_views.views().size() + 1));
    connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& name) {
        if (m_views.save(name, m_fabric->saveCamera())) {
            statusBar()->showMessage(tr("View \u201c%1\u201d saved").arg(name.trimmed()), 5000);
            takeViews();
        }
    });
    dialog->open();
}

void MainWindow::recallView(const QString& name) {
    const document::NamedView* view = m_views.find(name);
    if (view && m_fabric->restoreCamera(view->camera)) {
        takeActions(); // orthographic or not
    }
}

void MainWindow::manageViews() {
    auto* dialog = new ViewsDialog(m_views, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &ViewsDialog::viewWanted, this, &MainWindow::recallView);
    connect(dialog, &ViewsDialog::viewsChanged, this, &MainWindow::takeViews);
    dialog->open();
}

} // namespace knittsim::ui
