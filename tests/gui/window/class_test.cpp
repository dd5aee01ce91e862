#include "ui/views/step_player/step_player.h"
#include "ui/views/style/appearance.h"
#include "ui/views/style/language.h"
#include "ui/window/key_guard.h"
#include "ui/window/main_window.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace knittsim::ui {

using document::Document;

/// What a teacher finds again: marks of a file, keys wherever the focus is, beds that fit.
class ClassTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        qputenv("KNITTSIM_CONFIG_DIR", m_folder.path().toUtf8());
        applyAppearance(*qApp, document::Appearance::Light);
        applyLanguage(*qApp, QStringLiteral("en"));
        qApp->installEventFilter(&m_guard);
        write("long.k", 40);
        write("short.k", 8);
    }

    void init() {
        document::Session().clear();
        openWindow();
    }

    void cleanup() { m_window.reset(); }

    void marksComeBackWithTheirFile() {
        open("long.k");
        for (const int step : {12, 30}) {
            document().setStep(step);
            key(Qt::Key_B, Qt::ControlModifier);
        }
        marks().setLoopFrom(5);
        marks().setLoopTo(20);
        document::StopRules rules;
        rules.set(machine::OperationKind::Xfer, true);
        marks().setRules(rules);
        open("short.k");
        QVERIFY(marks().bookmarks().empty());
        QVERIFY(!marks().loops());
        marks().setRules({});
        document().setStep(3);
        key(Qt::Key_B, Qt::ControlModifier);
        m_window->close();
        openWindow();
        open("long.k");
        QCOMPARE(marks().bookmarks(), (std::set<int>{12, 30}));
        QCOMPARE(marks().loopFrom(), 5);
        QCOMPARE(marks().loopTo(), 20);
        QVERIFY(marks().rules() == rules);
        open("short.k");
        QCOMPARE(marks().bookmarks(), (std::set<int>{3}));
        QVERIFY(!marks().loops());
        QVERIFY(marks().rules().empty());
    }

    void marksBehindTheEndOfAFileThatBecameShorterAreForgotten() {
        open("long.k");
        document().setStep(30);
        key(Qt::Key_B, Qt::ControlModifier);
        document().setStep(4);
        key(Qt::Key_B, Qt::ControlModifier);
        open("short.k");
        write("long.k", 8);
        open("long.k");
        write("long.k", 40);
        QCOMPARE(marks().bookmarks(), (std::set<int>{4}));
    }

    /// Outside of a class lists are walked with Up, Down, Home and End; all else steps the machine.
    void listsLeaveSpaceAndTheSidewaysKeysToThePlayer() {
        open("long.k");
        key(Qt::Key_F3);
        int tried = 0;
        for (auto* list : m_window->findChildren<QAbstractItemView*>()) {
            if (!list->isVisible() || list->focusPolicy() == Qt::NoFocus) {
                continue;
            }
            list->setFocus();
            if (QApplication::focusWidget() != list) {
                continue;
            }
            ++tried;
            document().setStep(10);
            QTest::keyClick(list, Qt::Key_Right);
            QVERIFY2(document().step() == 11, qPrintable(list->objectName()));
            QTest::keyClick(list, Qt::Key_Left);
            QTest::keyClick(list, Qt::Key_Down);
            QTest::keyClick(list, Qt::Key_Home);
            QVERIFY2(document().step() == 10, qPrintable(list->objectName()));
            QTest::keyClick(list, Qt::Key_Space);
            QVERIFY2(player().isPlaying(), qPrintable(list->objectName()));
            QTest::keyClick(list, Qt::Key_Space);
        }
        QVERIFY(tried >= 2);
    }

private:
    StepPlayer& player() { return *m_window->findChild<StepPlayer*>(); }
    Document& document() { return m_window->document(); }
    document::StepMarks& marks() { return player().marks(); }
    void key(Qt::Key which, Qt::KeyboardModifiers with = {}) { QTest::keyClick(m_window.get(), which, with); }

    void openWindow() {
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        m_window->activateWindow(); // keys go to the active window only
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    }

    void open(const char* name) {
        QSignalSpy opened(&document(), &Document::opened);
        m_window->openFile(m_folder.filePath(name));
        QTRY_COMPARE(opened.count(), 1);
    }

    void write(const char* name, int operations) {
        QByteArray text = ";!knitout-2\n;;Carriers: 1\nin 1\n";
        for (int i = 1; i < operations; ++i) {
            text += "knit + f" + QByteArray::number(i) + " 1\n";
        }
        QFile file(m_folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text + "out 1\n");
    }

    QTemporaryDir m_folder;
    KeyGuard m_guard;
    std::unique_ptr<MainWindow> m_window;
};

} // namespace knittsim::ui

QTEST_MAIN(knittsim::ui::ClassTest)
#include "class_test.moc"
