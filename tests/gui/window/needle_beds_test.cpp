#ifndef Q_MOC_RUN // moc 6.4 does not read all headers of C++20
#include "core/pattern/samples.h"
#endif

#include "tests/gui/window/window_fixture.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/views/needle_beds/needle_beds.h"
#include "ui/views/step_player/step_player.h"

#include <QDockWidget>
#include <QHelpEvent>
#include <QToolTip>
#include <QWheelEvent>

namespace knittsim::ui {

using document::Document;
using machine::Bed;
using machine::Needle;

class NeedleBedsTest : public WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }

    void init() {
        beginTest();
        openSample("transfer-demo");
        m_window->findChild<FabricView*>(QStringLiteral("fabricView"))->setFocus();
    }

    void cleanup() { endTest(); }

    void aKeyShowsAndHidesThem() {
        auto* dock = m_window->findChild<QDockWidget*>(QStringLiteral("bedDock"));
        QVERIFY(!dock->isVisible());
        press(Qt::Key_N);
        QVERIFY(beds().isVisible());
        QVERIFY(!beds().picture().needles.empty());
        press(Qt::Key_N);
        QVERIFY(!dock->isVisible());
    }

    void aStepIsShownMovingThereAndBack() {
        teach();
        document().setStep(200);
        press(Qt::Key_Right);
        QVERIFY(beds().clock().running());
        QTRY_VERIFY(beds().clock().phase() > 0.2);
        press(Qt::Key_Left);
        QCOMPARE(document().step(), 200);
        QCOMPARE(beds().clock().operation(), 200);
        QTRY_VERIFY(!beds().clock().moving());
        QCOMPARE(beds().clock().operation(), 199);
        press(Qt::Key_Right);
        QTRY_VERIFY(!beds().clock().moving());
        QCOMPARE(beds().clock().operation(), 200);
        QCOMPARE(beds().clock().phase(), 1.0);
    }

    void spaceStopsInTheMiddleOfAnOperation() {
        teach();
        document().setStep(200);
        QTRY_VERIFY(!beds().clock().moving());
        press(Qt::Key_Space);
        QTRY_VERIFY(beds().clock().running() && beds().clock().phase() > 0.3);
        press(Qt::Key_Space);
        QVERIFY(beds().clock().moving());
        QVERIFY(!beds().clock().running());
        const double held = beds().clock().phase();
        beds().grab();
        QCOMPARE(beds().clock().phase(), held);
        press(Qt::Key_Space);
        QTRY_VERIFY(!beds().clock().moving() || beds().clock().phase() > held);
        press(Qt::Key_Space);
    }

    void aClickSelectsTheLoopInAllViews() {
        teach();
        document().setStep(200);
        QTRY_VERIFY(!beds().clock().moving());
        QTRY_COMPARE(static_cast<int>(document().shownFabric()->loops.size()),
                     document().machineState().loopCount);
        const Needle needle = needleWithLoop();
        const machine::MachineState state = document().machineState();
        const machine::LoopIndex loop = state.loopsOn(needle).back();
        QTest::mouseClick(&beds(), Qt::LeftButton, {}, beds().placeOf(needle));
        QCOMPARE(document().selection().loop, loop);
        QCOMPARE(m_window->findChild<FabricView*>(QStringLiteral("fabricView"))->selection(), loop);
        QTest::mouseClick(&beds(), Qt::LeftButton, {}, beds().placeOf({Bed::Rear, 0}));
        QCOMPARE(document().selection().loop, -1);
    }

    void dragPansUntilADoubleClickFollowsAgain() {
        teach();
        const Needle needle{Bed::Front, 10};
        const QPoint before = beds().placeOf(needle);
        QTest::mousePress(&beds(), Qt::LeftButton, {}, before);
        QTest::mouseMove(&beds(), before + QPoint(30, 0));
        QTest::mouseMove(&beds(), before + QPoint(60, 0));
        QTest::mouseRelease(&beds(), Qt::LeftButton, {}, before + QPoint(60, 0));
        QVERIFY(!beds().isFollowing());
        QVERIFY(std::abs(beds().placeOf(needle).x() - before.x() - 60) <= 1);
        QVERIFY(document().selection().loop < 0);
        QTest::mouseDClick(&beds(), Qt::LeftButton, {}, before);
        QVERIFY(beds().isFollowing());
        QCOMPARE(beds().placeOf(needle), before);
    }

    void theWheelZoomsAtThePointer() {
        teach();
        const QPoint place = beds().placeOf({Bed::Front, 10});
        const double pitch = beds().pitchPixels();
        QWheelEvent turn(place, beds().mapToGlobal(place), {}, {0, 240}, Qt::NoButton, Qt::ControlModifier,
                         Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&beds(), &turn);
        QVERIFY(beds().pitchPixels() > 1.3 * pitch);
        QVERIFY(std::abs(beds().placeOf({Bed::Front, 10}).x() - place.x()) <= 1);
        press(Qt::Key_N, Qt::ShiftModifier);
        QCOMPARE(beds().pitchPixels(), pitch);
    }

    void arrowsStepAlsoWithTheBedsFocused() {
        teach();
        document().setStep(200);
        beds().setFocus();
        const double pitch = beds().pitchPixels();
        press(Qt::Key_Right);
        QCOMPARE(document().step(), 201);
        QTest::keyClick(&beds(), Qt::Key_Plus);
        QVERIFY(beds().pitchPixels() > pitch);
        QVERIFY(!beds().accessibleDescription().isEmpty());
    }

    void aTipTellsNeedleLoopsAndYarn() {
        teach();
        document().setStep(200);
        QTRY_VERIFY(!beds().clock().moving());
        const Needle needle = needleWithLoop();
        const QPoint place = beds().placeOf(needle);
        QHelpEvent help(QEvent::ToolTip, place, beds().mapToGlobal(place));
        QCoreApplication::sendEvent(&beds(), &help);
        QVERIFY2(QToolTip::text().startsWith(QString("Front needle %1: 1 loop").arg(needle.index)),
                 qPrintable(QToolTip::text()));
        QVERIFY2(QToolTip::text().contains(QString::fromStdString(document().carriers().at(6).yarn.name)),
                 qPrintable(QToolTip::text()));
    }

    void forwardsAndBackwardsShowTheSame_data() {
        QTest::addColumn<QString>("sample");
        for (const char* sample : {"transfer-demo", "cable-left", "racked-rib", "float-jacquard", "tube"}) {
            QTest::newRow(sample) << QString(sample);
        }
    }

    void forwardsAndBackwardsShowTheSame() {
        QFETCH(QString, sample);
        Document document;
        NeedleBeds view(document);
        view.resize(1200, 300);
        view.show();
        QSignalSpy opened(&document, &Document::opened);
        document.openText(sample, QString::fromStdString(pattern::sampleText(sample.toStdString())));
        QTRY_COMPARE(opened.count(), 1);
        view.setPlaying(true);
        view.setSpeed(5000); // states only
        document.setStep(0);
        std::vector<machine::BedPicture> forwards{view.picture()};
        while (document.step() < document.operationCount()) {
            document.moveStep(+1);
            forwards.push_back(view.picture());
        }
        QCOMPARE(static_cast<int>(forwards.size()), document.operationCount() + 1);
        QVERIFY(forwards.front() != forwards.at(forwards.size() / 2));
        while (document.step() > 0) {
            document.moveStep(-1);
            const auto step = static_cast<std::size_t>(document.step());
            QVERIFY2(view.picture() == forwards.at(step), qPrintable(QString::number(step)));
        }
    }

private:
    NeedleBeds& beds() { return *m_window->findChild<NeedleBeds*>(QStringLiteral("needleBeds")); }

    /// The first one of the front bed that holds exactly one loop.
    Needle needleWithLoop() {
        const machine::MachineState state = document().machineState();
        Needle needle{Bed::Front, 1};
        while (needle.index < 28 && state.loopsOn(needle).size() != 1) {
            ++needle.index;
        }
        return needle;
    }

    void teach() {
        press(Qt::Key_T, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(beds().isVisible());
        QTRY_VERIFY(beds().width() > 1000 && beds().height() > 200); // once it is laid out anew
        QCoreApplication::processEvents();
        beds().follow();
    }
};

} // namespace knittsim::ui

QTEST_MAIN(knittsim::ui::NeedleBedsTest)
#include "needle_beds_test.moc"
