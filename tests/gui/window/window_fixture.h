#pragma once

#include "ui/window/key_guard.h"
#include "ui/window/main_window.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

class QAction;

namespace knittsim::ui {

class FabricView;

/// What the tests of the window share: a window that remembers nothing, driven by keys and mouse, whose
/// parts are found by objectName. A test class calls prepare() in initTestCase(), beginTest() in init() and
/// endTest() in cleanup().
class WindowFixture : public QObject {
protected:
    void prepare();     ///< configuration in a folder of its own, light appearance
    void beginTest();   ///< nothing is remembered; a new window
    void openWindow();  ///< a new one instead of the present one, active
    void adoptWindow(); ///< a new one with the document of the present one, as when the language changes
    void endTest();     ///< closes the window without a question

    document::Document& document() { return m_window->document(); }
    FabricView* fabric();

    /// The test ends where there is none.
    template<class T> T* child(const QString& name) {
        T* found = m_window->findChild<T*>(name);
        if (!found) {
            qFatal("no %s", qPrintable(name));
        }
        return found;
    }
    QAction* action(const QString& name);

    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(m_window.get(), key, modifiers);
    }

    /// Does what opens something, and waits until it is open.
    template<class F> void open(const F& how) {
        QSignalSpy opened(&document(), &document::Document::opened);
        how();
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, 60000);
    }
    void openSample(const QString& id); ///< open and drawn
    void settle();                      ///< until the bonding points are at rest

    /// Clicks near the middle of the fabric until yarn is hit; the place.
    QPoint clickYarn();

    /// A file in the folder of the test; its path.
    QString write(const QString& name, const QByteArray& text);

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;

private:
    KeyGuard m_guard;
};

} // namespace knittsim::ui
