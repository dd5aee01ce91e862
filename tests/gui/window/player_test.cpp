#ifndef Q_MOC_RUN // moc 6.4 does not read all headers of C++20
#include "core/pattern/samples.h"
#endif

#include "tests/gui/window/window_fixture.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/views/needle_beds/needle_beds.h"
#include "ui/views/step_player/step_player.h"

#include <QComboBox>
#include <QInputDialog>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>

#include <set>

namespace knittsim::ui {

using document::Document;
using machine::OperationKind;

class PlayerTest : public WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }

    void init() {
        beginTest();
        openSample("transfer-demo");
        child<FabricView>("fabricView")->setFocus();
    }

    void cleanup() { endTest(); }

    void aRangeIsPlayedAgainAndAgain() {
        document().setStep(100);
        press(Qt::Key_Home, Qt::ShiftModifier);
        document().setStep(105);
        press(Qt::Key_End, Qt::ShiftModifier);
        QVERIFY(player().marks().loops());
        QVERIFY(child<QToolButton>("loopButton")->isChecked());
        player().setSpeed(250);
        QSignalSpy steps(&document(), &Document::stepChanged);
        press(Qt::Key_Space);
        QTRY_VERIFY(steps.count() > 8);
        QVERIFY(player().isPlaying());
        QVERIFY(document().step() >= 100 && document().step() <= 105);
        press(Qt::Key_Space);
        press(Qt::Key_Escape, Qt::ShiftModifier);
        QVERIFY(!player().marks().loops());
    }

    void bookmarksAreSetWalkedAndListed() {
        for (const int step : {50, 200}) {
            document().setStep(step);
            press(Qt::Key_B, Qt::ControlModifier);
        }
        document().setStep(0);
        press(Qt::Key_F2);
        QCOMPARE(document().step(), 50);
        press(Qt::Key_F2);
        QCOMPARE(document().step(), 200);
        press(Qt::Key_F2);
        QCOMPARE(document().step(), 200);
        press(Qt::Key_F2, Qt::ShiftModifier);
        QCOMPARE(document().step(), 50);
        const QList<QAction*> listed = child<QToolButton>("bookmarkButton")->menu()->actions();
        QVERIFY(listed.at(listed.size() - 1)->text().startsWith("200: "));
        listed.last()->trigger();
        QCOMPARE(document().step(), 200);
    }

    void itStopsAtATransferAlsoAtFullSpeed() {
        document().setStep(0);
        document::StopRules rules;
        rules.set(OperationKind::Xfer, true);
        player().marks().setRules(rules);
        QVERIFY(child<QToolButton>("stopButton")->isChecked());
        player().setSpeed(5000);
        for (int i = 0; i < 3; ++i) {
            press(Qt::Key_Space);
            QTRY_VERIFY(!player().isPlaying());
            const auto& operations = document().file()->timeline->program().operations;
            QVERIFY(operations.at(static_cast<std::size_t>(document().step()) - 1).kind ==
                    OperationKind::Xfer);
        }
        const auto& ops = document().file()->timeline->program().operations;
        int transfers = 0;
        for (int i = 0; i < document().step(); ++i) {
            transfers += ops.at(static_cast<std::size_t>(i)).kind == OperationKind::Xfer ? 1 : 0;
        }
        QCOMPARE(transfers, 3);
    }

    void aLineIsJumpedTo() {
        press(Qt::Key_G, Qt::ControlModifier);
        auto* dialog = m_window->findChild<QInputDialog*>(QStringLiteral("lineDialog"));
        QVERIFY(dialog);
        dialog->setIntValue(40);
        QTest::keyClick(dialog, Qt::Key_Return);
        const auto& operations = document().file()->timeline->program().operations;
        const int step = document().step();
        QVERIFY(operations.at(static_cast<std::size_t>(step) - 1).line >= 40);
        QVERIFY(step == 1 || operations.at(static_cast<std::size_t>(step) - 2).line < 40);
    }

    void stepsThereAndBackGiveTheSameState_data() {
        QTest::addColumn<QString>("sample");
        for (const char* sample : {"transfer-demo", "cable-left", "lace", "float-jacquard", "tube"}) {
            QTest::newRow(sample) << QString(sample);
        }
    }

    /// k steps on and k back: for every k, with the keys' own functions.
    void stepsThereAndBackGiveTheSameState() {
        QFETCH(QString, sample);
        Document alone;
        QSignalSpy opened(&alone, &Document::opened);
        alone.openText(sample, QString::fromStdString(pattern::sampleText(sample.toStdString())));
        QTRY_COMPARE(opened.count(), 1);
        alone.setStep(0);
        std::vector<std::uint64_t> forwards{machine::digest(alone.machineState())};
        while (alone.step() < alone.operationCount()) {
            alone.moveStep(+1);
            forwards.push_back(machine::digest(alone.machineState()));
        }
        QVERIFY(std::set<std::uint64_t>(forwards.begin(), forwards.end()).size() > forwards.size() / 2);
        while (alone.step() > 0) {
            alone.moveStep(-1);
            QVERIFY(machine::digest(alone.machineState()) ==
                    forwards.at(static_cast<std::size_t>(alone.step())));
        }
        const int middle = alone.operationCount() / 2;
        for (int k = 0; k <= middle; k += 7) {
            alone.setStep(middle);
            alone.moveStep(+k);
            alone.moveStep(-k);
            QVERIFY(machine::digest(alone.machineState()) == forwards.at(static_cast<std::size_t>(middle)));
        }
    }

private:
    StepPlayer& player() { return *child<StepPlayer>("stepPlayer"); }
};

} // namespace knittsim::ui

QTEST_MAIN(knittsim::ui::PlayerTest)
#include "player_test.moc"
