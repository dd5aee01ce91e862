#include "tests/gui/window/window_fixture.h"
#include "ui/document/operation_text.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/views/needle_beds/needle_beds.h"
#include "ui/views/step_player/skimming.h"
#include "ui/views/step_player/step_player.h"
#include "ui/views/style/language.h"
#include "ui/window/banner.h"

#include <QProgressDialog>

#include <algorithm>

namespace knittsim::ui {

/// What a teacher finds again and a class sees: marks of a file, beds that fit, the needles in the picture.
class ClassTest : public WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        prepare();
        applyLanguage(*qApp, QStringLiteral("en"));
        program("long.k", 40);
        program("short.k", 8);
    }

    void init() { beginTest(); }

    void cleanup() { endTest(); }

    void marksComeBackWithTheirFile() {
        openFile("long.k");
        for (const int step : {12, 30}) {
            document().setStep(step);
            press(Qt::Key_B, Qt::ControlModifier);
        }
        marks().setLoopFrom(5);
        marks().setLoopTo(20);
        document::StopRules rules;
        rules.set(machine::OperationKind::Xfer, true);
        marks().setRules(rules);
        openFile("short.k");
        QVERIFY(marks().bookmarks().empty());
        QVERIFY(!marks().loops());
        marks().setRules({});
        document().setStep(3);
        press(Qt::Key_B, Qt::ControlModifier);
        m_window->close();
        openWindow();
        openFile("long.k");
        QCOMPARE(marks().bookmarks(), (std::set<int>{12, 30}));
        QCOMPARE(marks().loopFrom(), 5);
        QCOMPARE(marks().loopTo(), 20);
        QVERIFY(marks().rules() == rules);
        openFile("short.k");
        QCOMPARE(marks().bookmarks(), (std::set<int>{3}));
        QVERIFY(!marks().loops());
        QVERIFY(marks().rules().empty());
    }

    void marksBehindTheEndOfAFileThatBecameShorterAreForgotten() {
        openFile("long.k");
        document().setStep(30);
        press(Qt::Key_B, Qt::ControlModifier);
        document().setStep(4);
        press(Qt::Key_B, Qt::ControlModifier);
        openFile("short.k");
        program("long.k", 8);
        openFile("long.k");
        program("long.k", 40);
        QCOMPARE(marks().bookmarks(), (std::set<int>{4}));
    }

    /// Twenty needles fit, though only just: the page is not turned to where there is no fabric.
    void theBedsShowAllOfTheFabricWhereItFits() {
        program("twenty.k", 21);
        openFile("twenty.k");
        NeedleBeds beds(document());
        beds.resize(760, 330);
        beds.show();
        QVERIFY(QTest::qWaitForWindowExposed(&beds));
        for (int step = 1; step <= document().operationCount(); ++step) {
            document().setStep(step);
            QVERIFY2(beds.placeOf({machine::Bed::Front, 1}).x() > 60, qPrintable(QString::number(step)));
            QVERIFY2(beds.placeOf({machine::Bed::Front, 20}).x() < 490, qPrintable(QString::number(step)));
        }
        beds.resize(620, 330); // not all of them, but the one that works
        for (int step = 2; step < document().operationCount(); ++step) {
            document().setStep(step);
            const int x = beds.placeOf({machine::Bed::Front, step - 1}).x();
            QVERIFY2(x > 60 && x < 400, qPrintable(QString::number(step)));
        }
    }

    /// However far the fabric has grown, what hangs on the needles is in the picture.
    void thePictureFollowsTheNeedlesInClass() {
        openSample("cable-left");
        press(Qt::Key_F4);
        for (const int step : {12, 190, 1100}) {
            document().setStep(step);
            QTRY_COMPARE(document().shownStep(), step);
            QTRY_VERIFY(fabric()->isUpToDate());
            QTRY_VERIFY2(needlesAreInThePicture(), qPrintable(QString::number(step)));
        }
        const float near = fabric()->cameraState().halfHeight;
        document().setStep(document().operationCount()); // no needles: all of the fabric
        QTRY_VERIFY(fabric()->cameraState().halfHeight > 1.5F * near);
    }

    void whatIsKnownGoesFasterInClass() {
        openSample("cable-left");
        press(Qt::Key_F4);
        player().setSpeed(2.5);
        QSignalSpy tempo(&player(), &StepPlayer::tempoChanged);
        document().setStep(150); // in the middle of a course
        press(Qt::Key_Space);
        QTRY_VERIFY(!tempo.empty());
        QCOMPARE(tempo.back().front().toDouble(), kSkimmingSpeed);
        press(Qt::Key_Space);
        const auto& operations = document().file()->timeline->program().operations;
        const auto transfer =
            std::ranges::find(operations, machine::OperationKind::Xfer, &machine::Operation::kind);
        document().setStep(static_cast<int>(transfer - operations.begin()));
        tempo.clear();
        press(Qt::Key_Space);
        QTRY_VERIFY(!tempo.empty());
        QCOMPARE(tempo.front().front().toDouble(), 2.5);
        press(Qt::Key_Space);
        press(Qt::Key_F3);
        document().setStep(150);
        tempo.clear();
        press(Qt::Key_Space);
        QTRY_VERIFY(!tempo.empty());
        QCOMPARE(tempo.front().front().toDouble(), 2.5);
        press(Qt::Key_Space);
    }

    void aFirstLoopIsSaidToComeThroughNothing() {
        openSample("plain");
        const machine::Timeline& timeline = *document().file()->timeline;
        const auto& operations = timeline.program().operations;
        const auto sentenceOf = [&](machine::OperationKind kind) {
            const auto found = std::ranges::find(operations, kind, &machine::Operation::kind);
            return document::operationSentence(timeline, static_cast<int>(found - operations.begin()));
        };
        QCOMPARE(
            sentenceOf(machine::OperationKind::Tuck),
            QStringLiteral("Tuck: front needle 28 is empty and takes yarn of carrier 1 as its first loop."));
        QCOMPARE(sentenceOf(machine::OperationKind::Knit),
                 QStringLiteral("Knit: front needle 28 draws yarn of carrier 1 through its loop."));
    }

    void anySpeedIsTheNearestThatCanBeChosen() {
        player().setSpeed(20);
        QCOMPARE(player().speed(), 25.0);
        player().setSpeed(0.001);
        QCOMPARE(player().speed(), Playback::speeds().front());
    }

    void anAnimationThatWouldBeTooLongIsRefused() {
        QByteArray text = ";!knitout-2\n;;Carriers: 1\nin 1\nknit + f1 1\n";
        for (int i = 0; i < 2100; ++i) {
            text += "miss + f1 1\n";
        }
        write("film.k", text);
        openFile("film.k");
        document().setStep(document().operationCount());
        marks().setLoopFrom(0);
        marks().setLoopTo(document().operationCount());
        const QString path = m_folder.filePath("film.webp");
        m_window->record(path);
        QVERIFY2(child<Banner>("banner")->text().contains("2000"),
                 qPrintable(child<Banner>("banner")->text()));
        QVERIFY(!m_window->findChild<QProgressDialog*>());
        QVERIFY(!QFile::exists(path));
    }

private:
    bool needlesAreInThePicture() {
        const auto& hooks = document().needleHooks();
        const render::CameraState camera = fabric()->cameraState();
        const float halfWidth = camera.halfHeight * static_cast<float>(fabric()->width()) /
                                static_cast<float>(fabric()->height());
        return !hooks.empty() && std::ranges::all_of(hooks, [&](const fabric::NeedleHook& hook) {
            const Vec3f way = hook.place - camera.target;
            return std::abs(way.x()) < halfWidth && std::abs(way.y()) < camera.halfHeight;
        });
    }

    StepPlayer& player() { return *m_window->findChild<StepPlayer*>(); }
    document::StepMarks& marks() { return player().marks(); }

    void openFile(const char* name) {
        open([&] { m_window->openFile(m_folder.filePath(name)); });
    }

    void program(const char* name, int operations) {
        QByteArray text = ";!knitout-2\n;;Carriers: 1\nin 1\n";
        for (int i = 1; i < operations; ++i) {
            text += "knit + f" + QByteArray::number(i) + " 1\n";
        }
        write(name, text + "out 1\n");
    }
};

} // namespace knittsim::ui

QTEST_MAIN(knittsim::ui::ClassTest)
#include "class_test.moc"
