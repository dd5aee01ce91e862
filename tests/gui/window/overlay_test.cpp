#ifndef Q_MOC_RUN // moc 6.4 does not read all headers of C++20
#include "core/pattern/samples.h"
#endif

#include "ui/views/fabric_view/annotation_painter.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/views/style/appearance.h"
#include "ui/window/key_guard.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QFile>
#include <QHelpEvent>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolTip>
#include <QWheelEvent>

namespace knittsim::ui {

using document::Activity;
using document::Document;

/// What is written over the fabric, driven by keys and mouse.
class OverlayTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        qputenv("KNITTSIM_CONFIG_DIR", m_folder.path().toUtf8());
        applyAppearance(*qApp, document::Appearance::Light);
        qApp->installEventFilter(&m_guard);
    }

    void init() {
        document::Session().clear();
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    }

    void cleanup() { m_window.reset(); }

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
        settle();
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

    void oneCourseAndOneYarnAlone() {
        openSample("float-jacquard");
        settle();
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
        settle();
        document().selectLoop(50);
        press(Qt::Key_I);
        QCOMPARE(fabric()->alone(), FabricView::Alone::Yarn);
        openSample("rib-1x1");
        QCOMPARE(fabric()->alone(), FabricView::Alone::Nothing);
    }

    void theTapeMeasuresWhatTheScaleBarSays() {
        openSample("plain");
        settle();
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
        settle();
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
        QFile file(m_folder.filePath("held.k"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write((text + "xfer f3 b5\nout 1\n").toUtf8());
        file.close();
        QSignalSpy opened(&document(), &Document::opened);
        m_window->openFile(file.fileName());
        QTRY_COMPARE(opened.count(), 1);
        settle();
        QVERIFY(!document().problems().empty());
        QVERIFY(fabric()->words().contains("\u00d7 error, ! warning"));
        const QImage with = grab();
        press(Qt::Key_6, Qt::AltModifier);
        QVERIFY(!fabric()->hasProblemMarks());
        QVERIFY(grab() != with);
    }

    void theToolTipNamesTheStitch() {
        openSample("plain");
        settle();
        clickYarn();
        QHelpEvent help(QEvent::ToolTip, m_hit, fabric()->mapToGlobal(m_hit));
        QCoreApplication::sendEvent(fabric(), &help);
        const QString text = QToolTip::text();
        QVERIFY2(text.contains("needle") && text.contains("course") && text.contains("carrier 1") &&
                     text.contains("mm of yarn in the loop"),
                 qPrintable(text));
    }

private:
    template<class T> T* child(const QString& name) {
        T* found = m_window->findChild<T*>(name);
        if (!found) {
            qFatal("no widget %s", qPrintable(name));
        }
        return found;
    }
    Document& document() { return m_window->document(); }
    FabricView* fabric() { return child<FabricView>("fabricView"); }
    QAction* action(const char* name) { return child<QAction>(name); }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(m_window.get(), key, modifiers);
    }

    /// At rest, drawn, and the mouse away.
    void settle() {
        QTRY_COMPARE_WITH_TIMEOUT(document().activity(), Activity::AtRest, 30000);
        QTRY_VERIFY(yarnPixels(fabric()->picture()) > 0);
    }

    void openSample(const char* id) {
        QSignalSpy opened(&document(), &Document::opened);
        m_window->openSample(id);
        QTRY_COMPARE(opened.count(), 1);
        QTRY_VERIFY(document().shownFabric());
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

    /// Clicks near the middle of the fabric until yarn is hit.
    void clickYarn() {
        QSignalSpy clicked(fabric(), &FabricView::pointClicked);
        const QPoint middle = fabric()->rect().center();
        const auto hit = [&] {
            for (int x = 0; x < 60; x += 3) {
                m_hit = middle + QPoint(x, x / 2);
                QTest::mouseClick(fabric(), Qt::LeftButton, {}, m_hit);
                if (clicked.last().front().toInt() >= 0) {
                    return true;
                }
            }
            return false;
        };
        QTRY_VERIFY(hit());
    }

    QTemporaryDir m_folder;
    KeyGuard m_guard;
    QPoint m_hit;
    std::unique_ptr<MainWindow> m_window;
};

} // namespace knittsim::ui

QTEST_MAIN(knittsim::ui::OverlayTest)
#include "overlay_test.moc"
