#ifndef Q_MOC_RUN // moc 6.4 does not read all headers of C++20
#include "core/pattern/samples.h"
#endif

#include "tests/gui/window/window_fixture.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/window/comparison.h"

#include <QAction>
#include <QFile>
#include <QToolButton>

namespace knittsim::ui {

using document::Activity;
using document::Document;

/// Two fabrics side by side, driven by keys.
class ComparisonTest : public WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }

    void init() { beginTest(); }

    void cleanup() { endTest(); }

    void aKeptStateStaysWhileTheFabricSettles() {
        openSample("plain");
        press(Qt::Key_K, Qt::ControlModifier);
        QVERIFY(comparison()->isOpen());
        QTRY_VERIFY(!other()->bounds().empty());
        const Vec3f kept = other()->bounds().size();
        settle();
        QTRY_VERIFY(fabric()->bounds().size().x() < 0.95F * kept.x());
        QCOMPARE(other()->bounds().size().x(), kept.x());
        // It is told how much wider the kept one is.
        QTRY_VERIFY2(comparison()->sizes(true).contains('+'), qPrintable(comparison()->sizes(true)));
        QVERIFY(!comparison()->sizes(false).contains('%'));
        QVERIFY(comparison()->otherTitle().startsWith("Kept"));
    }

    void bothAreShownInOneScaleAndNothingIsCutOff() {
        openSample("plain");
        press(Qt::Key_K, Qt::ControlModifier);
        settle();
        QTRY_VERIFY(!other()->bounds().empty());
        press(Qt::Key_F);
        QCOMPARE(other()->cameraState().halfHeight, fabric()->cameraState().halfHeight);
        QVERIFY(2 * fabric()->cameraState().halfHeight >= other()->bounds().size().y());
    }

    void linkedCamerasMoveTogetherUntilTheLinkIsCut() {
        openSample("plain");
        press(Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(!other()->bounds().empty());
        press(Qt::Key_1, Qt::ControlModifier);
        QCOMPARE(other()->cameraState().yaw, fabric()->cameraState().yaw);
        other()->zoomBy(2); // and the other way round
        QCOMPARE(fabric()->cameraState().halfHeight, other()->cameraState().halfHeight);
        press(Qt::Key_J);
        QVERIFY(!comparison()->isLinked());
        const float yaw = other()->cameraState().yaw;
        press(Qt::Key_1);
        QCOMPARE(other()->cameraState().yaw, yaw);
        QVERIFY(fabric()->cameraState().yaw != yaw);
        press(Qt::Key_J);
        QCOMPARE(other()->cameraState().yaw, fabric()->cameraState().yaw);
    }

    void anotherYarnMakesAnotherWidth() {
        openSample("plain");
        settle();
        const auto& yarns = document().library().yarns();
        const auto& present = document().carriers().front().yarn;
        const auto thick = std::ranges::max_element(yarns, {}, &yarn::Yarn::outerDiameterMm);
        QVERIFY(thick->outerDiameterMm > present.outerDiameterMm);
        comparison()->openYarn(-1, *thick);
        QVERIFY(comparison()->otherTitle().contains(QString::fromStdString(thick->name)));
        QTRY_VERIFY_WITH_TIMEOUT(comparison()->otherTitle().contains("At rest", Qt::CaseInsensitive), 30000);
        QTRY_VERIFY(!other()->bounds().empty());
        QVERIFY(other()->bounds().size().z() > fabric()->bounds().size().z());
        QCOMPARE(document().carriers().front().yarn, present); // this side stays
        QVERIFY(!document().isModified());
    }

    void anotherFileAndEscape() {
        openSample("plain");
        comparison()->openFile(write("other.k",
                                     ";!knitout-2\n;;Carriers: 1\nin 1\nknit - f3 1\nknit - f2 1\n"
                                     "knit - f1 1\nknit + f1 1\nknit + f2 1\nknit + f3 1\nout 1\n"));
        QTRY_VERIFY(!other()->bounds().empty());
        QVERIFY(comparison()->otherTitle().startsWith("other.k"));
        QVERIFY(other()->bounds().size().x() < fabric()->bounds().size().x());
        press(Qt::Key_Escape);
        QVERIFY(!comparison()->isOpen());
        QVERIFY(!action("actionCloseComparison")->isEnabled());
    }

    void aFileThatCannotBeReadLeavesNoEmptySide() {
        openSample("plain");
        QSignalSpy failed(comparison(), &Comparison::failed);
        comparison()->openFile(m_folder.filePath("missing.k"));
        QTRY_COMPARE(failed.count(), 1);
        QVERIFY(failed.first().first().toString().contains("missing.k"));
        QTRY_VERIFY(!comparison()->isOpen());
    }

    void theOtherSideIsShownInTheSameStyle() {
        openSample("plain");
        press(Qt::Key_K, Qt::ControlModifier);
        press(Qt::Key_3, Qt::AltModifier);
        QCOMPARE(fabric()->style(), render::DrawStyle::Mesh);
        QCOMPARE(other()->style(), render::DrawStyle::Mesh);
    }

private:
    Comparison* comparison() { return m_window->findChild<Comparison*>("comparison"); }
    FabricView* other() { return comparison()->other(); }
};

} // namespace knittsim::ui

QTEST_MAIN(knittsim::ui::ComparisonTest)
#include "comparison_test.moc"
