#include "tests/gui/window/window_fixture.h"
#include "ui/views/pattern_editor/chart_area.h"
#include "ui/views/step_player/step_player.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QListView>
#include <QToolButton>

namespace knittsim::ui {

/// Space, the arrows, Home and End step the machine wherever the focus is.
class FocusKeysTest : public WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }

    void init() {
        beginTest();
        openSample("transfer-demo");
    }

    void cleanup() { endTest(); }

    void keysStepWhereverTheFocusIs_data() {
        QTest::addColumn<int>("layout");
        QTest::newRow("Designer") << int{Qt::Key_F3};
        QTest::newRow("Teacher") << int{Qt::Key_F4};
        QTest::newRow("Quality assurance") << int{Qt::Key_F7};
    }

    void keysStepWhereverTheFocusIs() {
        QFETCH(int, layout);
        press(static_cast<Qt::Key>(layout));
        int tried = 0;
        for (auto* dock : m_window->findChildren<QDockWidget*>()) {
            dock->show();
            dock->raise();
            QTest::qWait(20);
            tried += tryAll(layout == Qt::Key_F4);
        }
        QVERIFY2(tried > 40, qPrintable(QString::number(tried)));
    }

    void theyStepFromAPanelThatFloats() {
        auto* dock = child<QDockWidget>("problemDock");
        dock->show();
        dock->setFloating(true);
        auto* list = dock->findChild<QAbstractItemView*>();
        QApplication::setActiveWindow(dock);
        list->setFocus();
        QCOMPARE(QApplication::focusWidget(), list);
        QTest::keyClick(list, Qt::Key_Home);
        QCOMPARE(document().step(), 0);
        QTest::keyClick(list, Qt::Key_Right);
        QCOMPARE(document().step(), 1);
    }

    void withCtrlTheyAreForTheControl() {
        auto* yarns = child<QListView>("yarnList");
        yarns->setFocus();
        yarns->setCurrentIndex(yarns->model()->index(0, 0));
        document().setStep(10);
        QTest::keyClick(yarns, Qt::Key_Down, Qt::ControlModifier);
        QCOMPARE(yarns->currentIndex().row(), 1);
        QTest::keyClick(yarns, Qt::Key_End, Qt::ControlModifier);
        QCOMPARE(yarns->currentIndex().row(), yarns->model()->rowCount() - 1);
        auto* speed = child<QComboBox>("stepSpeed");
        speed->setFocus();
        speed->setCurrentIndex(2);
        QTest::keyClick(speed, Qt::Key_Down, Qt::ControlModifier);
        QCOMPARE(speed->currentIndex(), 3);
        QCOMPARE(document().step(), 10);
    }

    void enterPressesAButton() {
        auto* button = child<QToolButton>("stepBack");
        button->setFocus();
        document().setStep(10);
        QTest::keyClick(button, Qt::Key_Return);
        QCOMPARE(document().step(), 9);
        QTest::keyClick(button, Qt::Key_Space, Qt::ControlModifier);
        QCOMPARE(document().step(), 8);
        QVERIFY(!player().isPlaying());
    }

    void outsideOfAClassTextIsWritten() {
        press(Qt::Key_F3);
        auto* search = child<QLineEdit>("yarnSearch");
        search->setFocus();
        const int step = document().step();
        QTest::keyClicks(search, "a b");
        QTest::keyClick(search, Qt::Key_Home);
        QTest::keyClicks(search, "c");
        QCOMPARE(search->text(), QStringLiteral("ca b"));
        QCOMPARE(document().step(), step);
    }

private:
    StepPlayer& player() { return *child<StepPlayer>("stepPlayer"); }

    /// How many of the window's controls took the focus; each of them lets the keys step the machine.
    int tryAll(bool everywhere) {
        int tried = 0;
        for (auto* widget : m_window->findChildren<QWidget*>()) {
            const bool writes =
                widget->testAttribute(Qt::WA_InputMethodEnabled) && !qobject_cast<QAbstractItemView*>(widget);
            if (widget->focusPolicy() == Qt::NoFocus || !widget->isVisible() || !widget->isEnabled() ||
                (writes && !everywhere)) {
                continue;
            }
            widget->setFocus();
            if (QApplication::focusWidget() != widget) {
                continue;
            }
            ++tried;
            const bool chart = qobject_cast<ChartArea*>(widget) != nullptr;
            tryKeys(widget, everywhere || !chart);
            if (QTest::currentTestFailed()) {
                return 0;
            }
        }
        return tried;
    }

    void tryKeys(QWidget* widget, bool arrows) {
        const QByteArray name = widget->metaObject()->className() + (' ' + widget->objectName().toUtf8());
        const auto stepsTo = [&](Qt::Key key, int step) {
            QTest::keyClick(widget, key);
            QVERIFY2(document().step() == step, name + ' ' + QKeySequence(key).toString().toUtf8() + ": " +
                                                    QByteArray::number(document().step()));
        };
        stepsTo(Qt::Key_Home, 0);
        if (arrows) {
            stepsTo(Qt::Key_Right, 1);
            stepsTo(Qt::Key_Left, 0);
            stepsTo(Qt::Key_Up, document().file()->courseEnds.front());
            stepsTo(Qt::Key_Down, 0);
        }
        QTest::keyClick(widget, Qt::Key_Space);
        QVERIFY2(player().isPlaying(), name);
        QTest::keyClick(widget, Qt::Key_Space);
        QVERIFY2(!player().isPlaying(), name);
        stepsTo(Qt::Key_End, document().operationCount());
    }
};

} // namespace knittsim::ui

QTEST_MAIN(knittsim::ui::FocusKeysTest)
#include "focus_keys_test.moc"
