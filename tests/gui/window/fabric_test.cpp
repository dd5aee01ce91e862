#ifndef Q_MOC_RUN // moc 6.4 does not read all headers of C++20
#include "core/pattern/samples.h"
#endif

#include "tests/gui/window/window_fixture.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/views/history/history_card.h"
#include "ui/views/pattern_editor/pattern_grid.h"
#include "ui/views/source/source_view.h"
#include "ui/window/banner.h"

#include <QAction>
#include <QCheckBox>
#include <QFile>
#include <QLabel>
#include <QRegularExpression>
#include <QToolButton>

namespace knittsim::ui {

using document::Activity;
using document::Document;

/// Ladders and histories in the window, driven by keys and mouse.
class FabricTest : public WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }

    void init() { beginTest(); }

    void cleanup() { endTest(); }

    void aLadderRunsOnItsKeyAndComesBackOnUndo() {
        openWithDrops();
        settle();
        QCOMPARE(status(), QString("12 loops would run"));
        press(Qt::Key_L, Qt::ControlModifier);
        QVERIFY(document().laddersRun());
        QCOMPARE(child<QToolButton>("removeLadders")->text(), QString("Skip to the end"));
        QTRY_VERIFY(QRegularExpression("^\\d+ of 12 loops have run$").match(status()).hasMatch());
        QVERIFY(!child<QCheckBox>("stitchHolder")->isEnabled());
        QTRY_COMPARE_WITH_TIMEOUT(status(), QString("12 loops have run"), 8000);
        press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(status(), QString("12 loops would run"));
        QVERIFY(document().shownFabric() == document().file()->fabric);
    }

    void escapeCancelsARunAndTheButtonSkipsIt() {
        openWithDrops();
        settle();
        auto* button = child<QToolButton>("removeLadders");
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(document().laddersRun());
        press(Qt::Key_Escape);
        QVERIFY(!document().laddersRun());
        QCOMPARE(status(), QString("12 loops would run"));
        QTest::mouseClick(button, Qt::LeftButton);
        QTest::mouseClick(button, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(status(), QString("12 loops have run"), 1000);
        QCOMPARE(button->text(), QString("Remove ladders"));
    }

    void theCommandSaysWhenNothingRuns() {
        openSample("plain");
        QVERIFY(!child<QLabel>("statusLadders")->isVisible());
        press(Qt::Key_L, Qt::ControlModifier);
        auto* banner = child<Banner>("banner");
        QVERIFY(banner->isVisible());
        QVERIFY2(banner->text().startsWith("Nothing runs"), qPrintable(banner->text()));
        QVERIFY(!document().undoStack()->canUndo());
        press(Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(!document().stitchHolder());
        QVERIFY(!child<QCheckBox>("stitchHolder")->isChecked());
        QVERIFY(!child<QAction>("actionStitchHolder")->isChecked());
        QVERIFY2(!banner->isVisible(), "it is no longer true");
        QVERIFY2(status().endsWith("loops would run"), qPrintable(status()));
        QTest::mouseClick(child<QCheckBox>("stitchHolder"), Qt::LeftButton, {}, {8, 8});
        QVERIFY(document().stitchHolder());
        QVERIFY(!child<QLabel>("statusLadders")->isVisible());
    }

    void aClickOnTheYarnTellsItsHistory() {
        openWithDrops();
        settle();
        auto* card = child<HistoryCard>("historyCard");
        QVERIFY(!card->isVisible());
        clickYarn();
        QVERIFY(card->isVisible());
        const auto history = document().pointHistory();
        QVERIFY(history.has_value());
        QCOMPARE(history->loop, document().selection().loop);
        const QString events = child<QLabel>("historyEvents")->text();
        for (const auto& event : history->events) {
            QVERIFY2(event.line < 0 || events.contains(QString(">%1</a>").arg(event.line)),
                     qPrintable(events));
        }
        QVERIFY(events.contains("Made: "));
        // The line leads to the source and leaves the selection alone.
        const auto selection = document().selection();
        emit child<QLabel>("historyEvents")->linkActivated(QString::number(history->events[1].line));
        QCOMPARE(child<SourceView>("sourceView")->currentLine(), history->events[1].line);
        QCOMPARE(document().selection(), selection);
        QVERIFY(card->isVisible());
        press(Qt::Key_Escape);
        QVERIFY(!card->isVisible());
    }

    void theCardFollowsTheGridAndStaysOutOfTheWayOfSteps() {
        open(
            [&] { document().openText("cable", QString::fromStdString(pattern::sampleText("cable-left"))); });
        auto* card = child<HistoryCard>("historyCard");
        auto* grid = child<PatternGrid>("patternGrid");
        QTest::mouseClick(grid->viewport(), Qt::LeftButton, {}, grid->showLoop(75));
        QVERIFY(card->isVisible());
        QCOMPARE(document().pointHistory()->loop, 75);
        child<FabricView>("fabricView")->setFocus();
        press(Qt::Key_Left);
        QVERIFY(document().selection().loop >= 0 || document().selection().operation >= 0);
        QVERIFY2(!card->isVisible(), "stepping says in words what happens already");
    }

    void anotherFileClosesTheCard() {
        openSample("plain");
        document().selectLoop(75);
        QVERIFY(child<HistoryCard>("historyCard")->isVisible());
        openSample("garter");
        QVERIFY(!child<HistoryCard>("historyCard")->isVisible());
    }

    void theCardIsSwitchedOff() {
        openSample("plain");
        auto* card = child<HistoryCard>("historyCard");
        document().selectLoop(75);
        QVERIFY(card->isVisible());
        QTest::mouseClick(child<QToolButton>("historyClose"), Qt::LeftButton);
        QVERIFY(!card->isVisible());
        QVERIFY(!child<QAction>("actionHistory")->isChecked());
        document().selectLoop(76);
        QVERIFY(!card->isVisible());
        press(Qt::Key_H);
        QVERIFY(card->isVisible());
        QCOMPARE(document().pointHistory()->loop, 76);
    }

    void theHistoryEndsWithTheOperationShown() {
        openSample("plain");
        const auto made = document().file()->timeline->loops().loops[75].operation;
        document().setStep(made + 1);
        QTRY_COMPARE(static_cast<int>(document().shownFabric()->loops.size()), 76);
        document().selectLoop(75);
        QCOMPARE(document().pointHistory()->events.back().kind, fabric::HistoryEvent::Kind::Held);
        document().setStep(document().operationCount());
        document().selectLoop(75);
        QCOMPARE(document().pointHistory()->events.back().kind, fabric::HistoryEvent::Kind::Bound);
    }

    void aLadderUnderTheCardClosesIt() {
        openWithDrops();
        settle();
        document().selectLoop(4); // it will have run
        QVERIFY(child<HistoryCard>("historyCard")->isVisible());
        press(Qt::Key_L, Qt::ControlModifier);
        press(Qt::Key_L, Qt::ControlModifier);
        QTRY_VERIFY(!document().laddersRun());
        QVERIFY(!child<HistoryCard>("historyCard")->isVisible());
        QVERIFY(!document().pointHistory());
    }

    void nothingLeftCannotBeClicked() {
        openWithDrops();
        settle();
        document().setStitchHolder(false);
        press(Qt::Key_L, Qt::ControlModifier);
        press(Qt::Key_L, Qt::ControlModifier);
        QTRY_COMPARE(document().removedLoops(), std::size_t{120});
        auto* fabric = child<FabricView>("fabricView");
        QTRY_VERIFY(fabric->isUpToDate());
        QSignalSpy clicked(fabric, &FabricView::pointClicked);
        const QPoint middle = fabric->rect().center();
        QTest::mouseClick(fabric, Qt::LeftButton, {}, middle);
        QCOMPARE(clicked.last().front().toInt(), -1);
    }

    void theLegendIsSwitchedWithItsKey() {
        openSample("plain");
        auto* fabric = child<FabricView>("fabricView");
        child<QAction>("actionStyleMesh")->trigger();
        QVERIFY(fabric->hasLegend());
        settle();
        const auto corner = [&] { return fabric->grab(QRect(0, 0, 260, 130)).toImage(); };
        QTRY_COMPARE(corner(), corner());
        const QImage with = corner();
        press(Qt::Key_4, Qt::AltModifier);
        QVERIFY(!fabric->hasLegend());
        QVERIFY(corner() != with);
    }

    void tensionIsToldByColoursWithALegend() {
        openSample("plain");
        auto* fabric = child<FabricView>("fabricView");
        settle();
        const auto corner = [&] { return fabric->grab(QRect(0, 0, 260, 130)).toImage(); };
        QTRY_COMPARE(corner(), corner());
        const QImage without = corner();
        press(Qt::Key_T);
        QCOMPARE(fabric->colourBy(), render::ColourBy::Tension);
        QVERIFY(corner() != without);
        press(Qt::Key_T, Qt::ShiftModifier);
        QCOMPARE(fabric->colourBy(), render::ColourBy::Contact);
        press(Qt::Key_T, Qt::ShiftModifier);
        QCOMPARE(fabric->colourBy(), render::ColourBy::Yarn);
        QTRY_COMPARE(corner(), without);
    }

    void theSelectedBondingPointIsPinnedAndFreed() {
        openSample("plain");
        settle();
        press(Qt::Key_P);
        QVERIFY(document().pins().empty()); // nothing is selected
        clickYarn();
        press(Qt::Key_P);
        QCOMPARE(document().pins(), std::vector{document().selectedPoint()});
        press(Qt::Key_P);
        QVERIFY(document().pins().empty());
        press(Qt::Key_P);
        press(Qt::Key_P, Qt::ShiftModifier);
        QVERIFY(document().pins().empty());
    }

    void anotherYarnKeepsTheYarnThatIsShown() {
        openSample("plain");
        settle();
        press(Qt::Key_Y);
        QTRY_VERIFY_WITH_TIMEOUT(document().yarnRun().shape(), 60000);
        const auto generation = document().yarnRun().generation();
        document().assignYarn(carrierInUse(), document().library().yarns().back());
        QTest::qWait(300);
        QVERIFY(document().yarnRun().exists());
        QCOMPARE(document().yarnRun().generation(), generation);
        QTRY_VERIFY_WITH_TIMEOUT(document().yarnRun().shape()->edits == 1, 60000);
        press(Qt::Key_R);
        QCOMPARE(document().yarnRun().generation(), generation + 1);
        press(Qt::Key_F5); // the net of bonding points goes on
        QTRY_VERIFY(!document().yarnRun().exists());
    }

private:
    int carrierInUse() { return document().shownFabric()->yarns.front().carrier; }

    QString status() { return child<QLabel>("statusLadders")->text(); }

    /// Ten wales of plain knit, twelve courses; at the end needle 5 lets its loop go.
    void openWithDrops() {
        QString text = ";!knitout-2\n;;Carriers: 1\nin 1\n";
        for (int course = 0; course < 12; ++course) {
            for (int i = 0; i < 10; ++i) {
                text +=
                    course % 2 == 0 ? QString("knit + f%1 1\n").arg(i) : QString("knit - f%1 1\n").arg(9 - i);
            }
        }
        const QString path = write("drops.k", (text + "drop f4\nout 1\n").toUtf8());
        open([&] { m_window->openFile(path); });
    }
};

} // namespace knittsim::ui

QTEST_MAIN(knittsim::ui::FabricTest)
#include "fabric_test.moc"
