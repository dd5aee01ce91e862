#include "tests/gui/window/window_fixture.h"

#include "ui/document/session.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/views/style/appearance.h"

#include <QAction>
#include <QApplication>
#include <QFile>
#include <QUndoStack>

namespace knittsim::ui {

void WindowFixture::prepare() {
    qputenv("KNITTSIM_CONFIG_DIR", m_folder.path().toUtf8());
    applyAppearance(*qApp, document::Appearance::Light);
    qApp->installEventFilter(&m_guard);
}

void WindowFixture::beginTest() {
    document::Session().clear();
    openWindow();
}

void WindowFixture::openWindow() {
    m_window.reset();
    m_window = std::make_unique<MainWindow>();
    m_window->show();
    m_window->activateWindow(); // keys go to the active window only
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
}

void WindowFixture::adoptWindow() {
    auto next = std::make_unique<MainWindow>(m_window->releaseDocument());
    m_window = std::move(next);
    m_window->show();
}

void WindowFixture::endTest() {
    if (m_window) {
        document().undoStack()->setClean();
    }
    m_window.reset();
}

FabricView* WindowFixture::fabric() {
    return child<FabricView>("fabricView");
}

QAction* WindowFixture::action(const QString& name) {
    return child<QAction>(name);
}

void WindowFixture::openSample(const QString& id) {
    open([&] { m_window->openSample(id); });
    QTRY_VERIFY(!fabric()->bounds().empty());
}

void WindowFixture::settle() {
    QTRY_COMPARE_WITH_TIMEOUT(document().activity(), document::Activity::AtRest, 30000);
}

QPoint WindowFixture::clickYarn() {
    QSignalSpy clicked(fabric(), &FabricView::pointClicked);
    const QPoint middle = fabric()->rect().center();
    QPoint place;
    const auto hit = [&] {
        for (int x = 0; x < 60; x += 3) {
            place = middle + QPoint(x, x / 2);
            QTest::mouseClick(fabric(), Qt::LeftButton, {}, place);
            if (clicked.last().front().toInt() >= 0) {
                return true;
            }
        }
        return false;
    };
    if (!QTest::qWaitFor(hit)) { // the first picture may still be under way
        qFatal("no yarn near the middle of the fabric");
    }
    return place;
}

QString WindowFixture::write(const QString& name, const QByteArray& text) {
    QFile file(m_folder.filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) {
        qFatal("cannot write %s", qPrintable(name));
    }
    return file.fileName();
}

} // namespace knittsim::ui
