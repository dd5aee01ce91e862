#include "tests/gui/window/window_fixture.h"
#include "ui/views/fabric_view/fabric_view.h"

namespace knittsim::ui {

/// Pulling the fabric with the mouse.
class PullTest : public WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }
    void init() { beginTest(); }
    void cleanup() { endTest(); }

    /// Otherwise a fitted picture runs away from the mouse, and the mouse pulls ever farther.
    void whileItIsPulledThePictureStandsStill() {
        openSample("plain");
        settle();
        fabric()->fit();
        const QPoint from = clickYarn();
        QSignalSpy pulled(fabric(), &FabricView::dragMoved);
        QSignalSpy shown(fabric(), &FabricView::sceneChanged);
        const render::CameraState before = fabric()->cameraState();
        QTest::mousePress(fabric(), Qt::LeftButton, Qt::ControlModifier, from);
        QTest::mouseMove(fabric(), from + QPoint(60, -60));
        QVERIFY(!pulled.isEmpty());
        const int point = pulled.back().front().toInt();
        QVERIFY(point >= 0);
        // The yarn follows, which moves all of this free fabric.
        QTRY_VERIFY_WITH_TIMEOUT(shown.count() >= 2, 20000);
        QVERIFY(fabric()->cameraState() == before);
        QTest::mouseMove(fabric(), from + QPoint(61, -60));
        QCOMPARE(pulled.back().front().toInt(), point);
        QTest::mouseRelease(fabric(), Qt::LeftButton, Qt::ControlModifier, from + QPoint(61, -60));
    }
};

} // namespace knittsim::ui

QTEST_MAIN(knittsim::ui::PullTest)
#include "pull_test.moc"
