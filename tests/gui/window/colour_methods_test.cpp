#ifndef Q_MOC_RUN // moc 6.4 does not read all headers of C++20
#include "core/pattern/chart_edit.h"
#include "core/pattern/swatch.h"
#endif

#include "tests/gui/window/chart_fixture.h"
#include "ui/dialogs/picture_reading.h"
#include "ui/views/fabric_view/fabric_view.h"

#include <QAction>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QUndoStack>

namespace knittsim::ui {

using pattern::BedUse;
using pattern::ColourMethod;

/// How colours are knitted, on which beds, and how the fabric follows.
class ColourMethodsTest : public ChartFixture {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }
    void init() { beginTest(); }
    void cleanup() { endTest(); }

    void aBackIsChosenInTheMenuAndKnittedOnTheRearBed() {
        newChart(8, 6);
        QVERIFY(rearStitches() == 0);
        choose(ColourMethod::Birdseye);
        QCOMPARE(chart().beds, BedUse::Double);
        for (const pattern::Course& course : chart().courses) {
            QCOMPARE(course.colours, ColourMethod::Birdseye);
        }
        QTRY_VERIFY(document().fabricFollowsChart());
        QCOMPARE(rearStitches(), 8 / 2 * 6);
        QVERIFY(action("actionChartBeds")->isChecked());
        QVERIFY(child<QToolButton>("stitch7")->isVisible()); // a stitch of both beds
        document().undoStack()->undo();
        QCOMPARE(chart().beds, BedUse::Single);
        QVERIFY(!child<QToolButton>("stitch7")->isVisible());
    }

    void onlyTheSelectedCoursesAreChanged() {
        newChart(6, 6);
        action("actionChartBeds")->trigger();
        canvas()->select({0, 2, 6, 3});
        choose(ColourMethod::LadderBack);
        for (int c = 0; c < 6; ++c) {
            QCOMPARE(chart().course(c).colours,
                     c >= 2 && c < 5 ? ColourMethod::LadderBack : ColourMethod::Float);
        }
    }

    void aChartWithCablesTellsWhyItHasNoBack() {
        newChart(8, 6);
        document().editChart("cable", [](pattern::Chart& chart) {
            chart.course(2).moves = pattern::cross(2, 2, 2, pattern::Front::Left);
        });
        const pattern::Chart before = chart();
        choose(ColourMethod::Birdseye);
        QCOMPARE(chart(), before);
        QVERIFY(child<QLabel>("chartHint")->text().contains("cables"));
        action("actionChartBeds")->trigger();
        QCOMPARE(chart(), before);
        QVERIFY(!action("actionChartBeds")->isChecked());
    }

    void theYarnModelFollowsAnEdit() {
        newChart(6, 6);
        settle();
        document().settleYarn();
        QTRY_VERIFY_WITH_TIMEOUT(document().showsYarn(), 60000);
        stroke({2, 2}, {3, 2});
        QTRY_VERIFY(document().fabricFollowsChart());
        QTRY_VERIFY_WITH_TIMEOUT(document().showsYarn(), 60000); // nothing was pressed
    }

    void aSavedChartIsSeenAsItWasSaved() {
        newChart(6, 6);
        settle();
        QTRY_VERIFY(!fabric()->bounds().empty());
        render::CameraState camera = fabric()->cameraState();
        camera.halfHeight *= 0.5F;
        fabric()->setCameraState(camera);
        const QByteArray view = fabric()->saveCamera();
        const QString path = m_folder.filePath("seen.knitt");
        QVERIFY(!hasErrors(document().save(path, {.view = view.toBase64().toStdString()})));
        QCOMPARE(pattern::readLook(path.toStdString()).view, view.toBase64().toStdString());
        newChart(3, 3);
        camera.halfHeight *= 3;
        fabric()->setCameraState(camera);
        QVERIFY(fabric()->saveCamera() != view);
        open([&] { document().open(path); });
        QTRY_COMPARE(fabric()->saveCamera(), view);
    }

    void bindingOffLeavesOneLoop() {
        newChart(5, 4);
        action("actionChartBindOff")->trigger();
        QCOMPARE(chart().height(), 4 + 4);
        QTRY_VERIFY(document().fabricFollowsChart());
        document().undoStack()->undo();
        QCOMPARE(chart().height(), 4);
    }

    void readingAPictureEndsWhenItIsToldTo() {
        QImage image(900, 700, QImage::Format_RGB32);
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                image.setPixel(x, y, qRgb(x * y % 251, x % 241, y % 239)); // not small when packed
            }
        }
        const QString path = m_folder.filePath("noise.png");
        QVERIFY(image.save(path));
        double most = 0;
        const auto whole = readPictureFile(path, [&](double share) {
            most = std::max(most, share);
            return true;
        });
        QVERIFY(whole.first);
        QCOMPARE(whole.first->width, 900);
        QVERIFY(most > 0.9);
        int asked = 0;
        const auto ended = readPictureFile(path, [&](double) { return ++asked < 4; });
        QVERIFY(!ended.first);
        QVERIFY(asked < 10); // nothing more is read
    }

private:
    void choose(ColourMethod method) {
        action("actionChartColours")->trigger();
        child<QAction>(QStringLiteral("colourMethod%1").arg(static_cast<int>(method)))->trigger();
        delete child<QMenu>("colourMethods");
    }

    int rearStitches() {
        const auto& operations = document().file()->timeline->program().operations;
        return static_cast<int>(std::ranges::count_if(operations, [](const machine::Operation& op) {
            return op.kind == machine::OperationKind::Knit && op.needle.bed == machine::Bed::Rear;
        }));
    }
};

} // namespace knittsim::ui

QTEST_MAIN(knittsim::ui::ColourMethodsTest)
#include "colour_methods_test.moc"
