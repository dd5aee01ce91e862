#ifndef Q_MOC_RUN // moc 6.4 does not read all headers of C++20
#include "core/pattern/samples.h"
#endif

#include "tests/gui/window/window_fixture.h"
#include "ui/views/fabric_view/annotation_painter.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/views/fabric_view/overlay.h"

#include <QAction>
#include <QFile>
#include <QHelpEvent>
#include <QToolTip>
#include <QWheelEvent>

namespace knittsim::ui {

using document::Activity;
using document::Document;

/// What is written over the fabric, driven by keys and mouse.
class OverlayTest : public WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }

    void init() { beginTest(); }

    void cleanup() { endTest(); }

    void guidesAreAsFarApartAsThereIsRoom() {
        QCOMPARE(guideStep(1, 0.01), 1);
        QCOMPARE(guideStep(1, 0.04), 2);
        QCOMPARE(guideStep(1, 0.1), 5);
        QCOMPARE(guideStep(1, 1), 50);
        QCOMPARE(guideStep(0, 1), 1);
        QCOMPARE(guideStep(1, 0), 1);
    }

    void lengthsAreInBothUnits() { QVERIFY(lengthText(25.4).contains("1.00")); }

    void theGaugeFollowsTheFabricWhileItSettles() {
        openSample("plain");
        QVERIFY(fabric()->measurement());
        const auto machine = *fabric()->measurement();
        QTRY_COMPARE_WITH_TIMEOUT(document().activity(), Activity::AtRest, 30000);
        const auto rest = *fabric()->measurement();
        QCOMPARE(rest.loops, machine.loops);
        QVERIFY2(rest.waleSpacingMm < 0.95 * machine.waleSpacingMm, "plain knit draws in");
        const auto shown = document().shownFrame();
        const auto wanted = geometry::measure(*document().shownFabric(), shown->positions);
        QCOMPARE(rest.waleSpacingMm, wanted.waleSpacingMm);
        QCOMPARE(rest.courseSpacingMm, wanted.courseSpacingMm);
    }

    void theBadgeIsAlwaysThere() {
        openSample("plain");
        QCOMPARE(fabric()->words().first(), QString("technical face"));
        press(Qt::Key_1, Qt::ControlModifier);
        QCOMPARE(fabric()->words().first(), QString("technical back"));
        press(Qt::Key_7);
        QCOMPARE(fabric()->words().first(), QString("seen from its edge"));
    }

    void switchesChangeThePictureAndTheMenu() {
        openSample("plain");
        settleInView();
        waitForTheLastPicture();
        QVERIFY(action("actionDimensions")->isChecked());
        const QImage with = grab();
        press(Qt::Key_5, Qt::AltModifier);
        QVERIFY(!fabric()->hasDimensions());
        const QImage without = grab();
        QVERIFY(with != without);
        press(Qt::Key_G);
        QVERIFY(fabric()->hasGuides());
        QVERIFY(fabric()->words().contains("courses, numbered"));
        QVERIFY(grab() != without);
        press(Qt::Key_G);
        press(Qt::Key_5, Qt::AltModifier);
        QCOMPARE(grab(), with);
    }

    /// Unless the person has chosen the camera.
    void legendsLieAboveAFittedFabric() {
        openSample("plain");
        settleInView();
        press(Qt::Key_F);
        auto* overlay = fabric()->findChild<Overlay*>();
        QVERIFY(overlay);
        const auto freeAbove = [&] {
            render::Camera camera;
            camera.setViewport(fabric()->width(), fabric()->height());
            camera.setScene(fabric()->bounds());
            camera.setState(fabric()->cameraState());
            const geometry::Bounds box = fabric()->bounds();
            return camera.project({box.centre().x(), box.high.y(), box.centre().z()}).y();
        };
        const int badge = overlay->headHeight();
        QVERIFY(freeAbove() >= static_cast<float>(badge));
        press(Qt::Key_3, Qt::AltModifier);
        waitForTheLastPicture();
        press(Qt::Key_G);
        QVERIFY(overlay->headHeight() > badge + 30);
        QVERIFY(freeAbove() >= static_cast<float>(overlay->headHeight()));
        press(Qt::Key_Plus, Qt::ControlModifier);
        const float chosen = fabric()->cameraState().halfHeight;
        press(Qt::Key_4, Qt::AltModifier);
        QVERIFY(overlay->headHeight() < badge + 30);
        QCOMPARE(fabric()->cameraState().halfHeight, chosen);
    }

    void oneCourseAndOneYarnAlone() {
        openSample("float-jacquard");
        settleInView();
        const QImage all = fabric()->picture();
        clickYarn();
        const int loop = document().selection().loop;
        QVERIFY(loop >= 0);
        press(Qt::Key_I, Qt::ShiftModifier);
        const int course = document().shownFabric()->loops[static_cast<std::size_t>(loop)].course;
        QVERIFY(fabric()->words().contains(QString("only course %1").arg(course + 1)));
        QVERIFY(action("actionCourseAlone")->isChecked());
        const int one = yarnPixels(fabric()->picture());
        press(Qt::Key_I);
        QVERIFY(action("actionYarnAlone")->isChecked());
        QVERIFY(!action("actionCourseAlone")->isChecked());
        const int yarn = yarnPixels(fabric()->picture());
        QVERIFY2(one > 0 && one < yarn && yarn < yarnPixels(all),
                 qPrintable(QString("%1 %2 %3").arg(one).arg(yarn).arg(yarnPixels(all))));
        press(Qt::Key_I);
        QCOMPARE(fabric()->alone(), FabricView::Alone::Nothing);
        QVERIFY2(fabric()->words().filter("only").isEmpty(), qPrintable(fabric()->words().join('|')));
    }

    void nothingIsHiddenWithoutAStitch() {
        openSample("plain");
        press(Qt::Key_I);
        QCOMPARE(fabric()->alone(), FabricView::Alone::Nothing);
        QVERIFY(!action("actionYarnAlone")->isChecked());
    }

    void anotherFileIsShownWhole() {
        openSample("plain");
        settleInView();
        document().selectLoop(50);
        press(Qt::Key_I);
        QCOMPARE(fabric()->alone(), FabricView::Alone::Yarn);
        openSample("rib-1x1");
        QCOMPARE(fabric()->alone(), FabricView::Alone::Nothing);
    }

    void theTapeMeasuresWhatTheScaleBarSays() {
        openSample("plain");
        settleInView();
        press(Qt::Key_F);
        press(Qt::Key_M);
        QVERIFY(fabric()->isTaping());
        QSignalSpy measured(fabric(), &FabricView::measured);
        QSignalSpy clicked(fabric(), &FabricView::loopClicked);
        // Beside the yarn both ends lie in one plane.
        const QPoint from(6, 60);
        const QPoint to(6, fabric()->height() - 60);
        QTest::mouseClick(fabric(), Qt::LeftButton, {}, from);
        QCOMPARE(measured.count(), 0);
        QVERIFY(fabric()->words().contains("tape: click the second point"));
        QTest::mouseClick(fabric(), Qt::LeftButton, {}, to);
        QCOMPARE(measured.count(), 1);
        const double perPixel =
            2.0 * static_cast<double>(fabric()->cameraState().halfHeight) / fabric()->height();
        const double wanted = perPixel * (to - from).y();
        QVERIFY(std::abs(measured.first().first().toDouble() - wanted) < 0.01 * wanted);
        QCOMPARE(clicked.count(), 0); // it measures instead of selecting
        press(Qt::Key_M);
        QTest::mouseClick(fabric(), Qt::LeftButton, {}, from);
        QCOMPARE(clicked.count(), 1);
    }

    void aSectionCutsAwayWhatLiesInFront() {
        openSample("rib-1x1");
        settleInView();
        const int all = yarnPixels(fabric()->picture());
        press(Qt::Key_X);
        QVERIFY(fabric()->section());
        QVERIFY(fabric()->words().contains("section: Alt and wheel move it"));
        QVERIFY(fabric()->picture() != QImage());
        const float before = fabric()->section()->point.z();
        const QPointF at(40, 40);
        // Far behind the fabric: all of it is cut away.
        QWheelEvent wheel(at, fabric()->mapToGlobal(at), {}, QPoint(-100 * 120, 0), Qt::NoButton,
                          Qt::AltModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(fabric(), &wheel);
        QVERIFY(fabric()->section()->point.z() < before - 10);
        QCOMPARE(yarnPixels(fabric()->picture()), 0);
        QSignalSpy clicked(fabric(), &FabricView::loopClicked);
        QTest::mouseClick(fabric(), Qt::LeftButton, {}, fabric()->rect().center());
        QCOMPARE(clicked.last().front().toInt(), -1); // what is cut away cannot be clicked
        press(Qt::Key_X);
        QVERIFY(!fabric()->section());
        QVERIFY2(yarnPixels(fabric()->picture()) > 0.9 * all,
                 "whole again, up to the highlight under the mouse");
    }

    void aProblemHasItsSignAtTheLoop() {
        // Needle 3 does not face the one that its loop is to go to.
        QString text = ";!knitout-2\n;;Carriers: 1\nin 1\n";
        for (int course = 0; course < 20; ++course) {
            for (int i = 0; i < 8; ++i) {
                const int needle = course % 2 == 0 ? i : 7 - i;
                text += QString("knit %1 f%2 1\n").arg(course % 2 == 0 ? '+' : '-').arg(needle);
            }
        }
        const QString path = write("held.k", (text + "xfer f3 b5\nout 1\n").toUtf8());
        open([&] { m_window->openFile(path); });
        settleInView();
        QVERIFY(!document().problems().empty());
        QVERIFY(fabric()->words().contains("\u00d7 error, ! warning"));
        const QImage with = grab();
        press(Qt::Key_6, Qt::AltModifier);
        QVERIFY(!fabric()->hasProblemMarks());
        QVERIFY(grab() != with);
    }

    void theToolTipNamesTheStitch() {
        openSample("plain");
        settleInView();
        const QPoint place = clickYarn();
        QHelpEvent help(QEvent::ToolTip, place, fabric()->mapToGlobal(place));
        QCoreApplication::sendEvent(fabric(), &help);
        const QString text = QToolTip::text();
        QVERIFY2(text.contains("needle") && text.contains("course") && text.contains("carrier 1") &&
                     text.contains("mm of yarn in the loop"),
                 qPrintable(text));
    }

private:
    /// At rest and drawn.
    void settleInView() {
        settle();
        QTRY_VERIFY(yarnPixels(fabric()->picture()) > 0);
    }

    /// Until the strands that touched are drawn apart, which goes on for a while at rest.
    void waitForTheLastPicture() {
        const auto stays = [&] {
            const QImage before = grab();
            QTest::qWait(300);
            return grab() == before;
        };
        QVERIFY(QTest::qWaitFor(stays, 60000));
    }

    QImage grab() {
        QCoreApplication::processEvents();
        return fabric()->grab().toImage();
    }

    /// Pixels that differ from the grey ground.
    static int yarnPixels(const QImage& image) {
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const QRgb c = image.pixel(x, y);
                const int spread =
                    std::max({qRed(c), qGreen(c), qBlue(c)}) - std::min({qRed(c), qGreen(c), qBlue(c)});
                count += spread > 16 ? 1 : 0;
            }
        }
        return count;
    }
};

} // namespace knittsim::ui

QTEST_MAIN(knittsim::ui::OverlayTest)
#include "overlay_test.moc"
