#include "ui/views/fabric_view/fabric_view.h"
#include "ui/window/banner.h"
#include "ui/window/main_window.h"
#include "ui/window/photograph_card.h"

#include <QAction>
#include <QFileInfo>
#include <QImageReader>
#include <QMenu>
#include <QPointer>
#include <QThreadPool>

namespace knittsim::ui {

namespace {

constexpr int kMostPixels = 4096; ///< of a side; larger photographs are made smaller

/// Any thread. Null, and why, when it cannot be read.
QImage readPhotograph(const QString& path, QString& reason) {
    QImageReader reader(path);
    reader.setAutoTransform(true);
    if (const QSize size = reader.size();
        size.isValid() && std::max(size.width(), size.height()) > kMostPixels) {
        reader.setScaledSize(size.scaled(kMostPixels, kMostPixels, Qt::KeepAspectRatio));
    }
    QImage image = reader.read();
    if (image.isNull()) {
        reason = reader.errorString();
    }
    return image.isNull() ? image : image.convertToFormat(QImage::Format_ARGB32_Premultiplied);
}

const QString kGroup = QStringLiteral("photographs");

} // namespace

void MainWindow::buildPhotographMenu(QMenu* view) {
    QMenu* menu = view->addMenu(tr("Photo&graph"));
    menu->setObjectName(QStringLiteral("photographMenu"));
    addAction(menu, "actionPhotographOpen", tr("&Open a photograph\u2026"), Qt::CTRL | Qt::ALT | Qt::Key_P,
              {}, [this] { choosePhotograph(); });
    QAction* shown =
        addChoice(menu, nullptr, "actionPhotograph", tr("&Show the photograph"), Qt::Key_W, {}, [] {});
    connect(shown, &QAction::toggled, this, [this](bool on) {
        if (on != m_fabric->photograph().shown) {
            Photograph photograph = m_fabric->photograph();
            photograph.shown = on;
            m_fabric->setPhotograph(std::move(photograph));
        }
    });
    addAction(menu, "actionPhotographAlign", tr("&Align by two points"), Qt::SHIFT | Qt::Key_W, {},
              [this] { alignPhotograph(); });
    connect(m_photograph, &PhotographCard::openWanted, this, &MainWindow::choosePhotograph);
    connect(m_photograph, &PhotographCard::alignWanted, this, &MainWindow::alignPhotograph);
    connect(m_fabric, &FabricView::photographChanged, this, [this] {
        rememberPhotograph();
        takePhotographActions();
    });
}

void MainWindow::takePhotographActions() {
    const Photograph& photograph = m_fabric->photograph();
    findChild<QAction*>(QStringLiteral("actionPhotographOpen"))->setEnabled(m_document.file() != nullptr);
    QAction* shown = findChild<QAction*>(QStringLiteral("actionPhotograph"));
    shown->setEnabled(!photograph.image.isNull());
    shown->setChecked(photograph.visible());
    findChild<QAction*>(QStringLiteral("actionPhotographAlign"))->setEnabled(photograph.visible());
}

void MainWindow::choosePhotograph() {
    const QString path =
        askWhich(tr("Open a photograph"), tr("Photographs (*.png *.jpg *.jpeg);;All files (*)"));
    if (!path.isEmpty()) {
        Photograph wanted;
        wanted.path = path;
        openPhotograph(std::move(wanted));
    }
}

/// In the background. One whose place is not known yet is laid on the fabric.
void MainWindow::openPhotograph(Photograph wanted) {
    QThreadPool::globalInstance()->start(
        [guard = QPointer<MainWindow>(this), turn = m_photographTurn, wanted = std::move(wanted)]() mutable {
            QString reason;
            wanted.image = readPhotograph(wanted.path, reason);
            QMetaObject::invokeMethod(qApp, [guard, turn, wanted = std::move(wanted), reason]() mutable {
                if (!guard || guard->m_photographTurn != turn) {
                    return; // gone, or of another file
                }
                if (wanted.image.isNull()) {
                    guard->m_banner->showMessage(Banner::Kind::Error,
                                                 tr("The photograph %1 cannot be opened: %2.")
                                                     .arg(QFileInfo(wanted.path).fileName(), reason));
                    return;
                }
                const geometry::Bounds box = guard->m_fabric->bounds();
                if (wanted.toFabric.isIdentity() && !box.empty()) {
                    wanted.toFabric = laidOn(wanted.image.size(), box, guard->m_fabric->seesBack());
                }
                guard->m_fabric->setPhotograph(std::move(wanted));
            });
        });
}

void MainWindow::alignPhotograph() {
    m_fabric->startAlignment();
    m_fabric->setFocus();
}

/// Each file has its own; what is not in a file has one only while it is open.
void MainWindow::recallPhotograph() {
    ++m_photographTurn;
    m_photographKey.clear(); // the next line is not to be remembered
    m_fabric->cancelAlignment();
    m_fabric->setPhotograph({});
    m_photographKey = document::Session::keyOf(kGroup, m_document.path());
    if (m_photographKey.isEmpty()) {
        return;
    }
    if (const auto known = photographFromBytes(m_session.value(m_photographKey));
        known && QFileInfo::exists(known->path)) {
        openPhotograph(*known);
    }
}

void MainWindow::rememberPhotograph() {
    if (!m_photographKey.isEmpty()) {
        const Photograph& photograph = m_fabric->photograph();
        m_session.setValue(m_photographKey, photograph.image.isNull() ? QByteArray() : toBytes(photograph));
    }
}

/// What was saved under another name takes its photograph along; the other file keeps its own.
void MainWindow::movePhotograph() {
    const QString key = document::Session::keyOf(kGroup, m_document.path());
    if (key != m_photographKey) {
        m_photographKey = key;
        rememberPhotograph();
    }
}

} // namespace knittsim::ui
