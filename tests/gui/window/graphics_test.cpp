#ifndef Q_MOC_RUN // moc 6.4 does not read all headers of C++20
#include "core/fabric/fabric_builder.h"
#include "core/machine/timeline.h"
#include "core/pattern/samples.h"
#endif

#include "ui/views/fabric_view/fabric_view.h"

#include <QSignalSpy>
#include <QTest>

#include <cmath>
#include <cstdlib>
#include <memory>

namespace knittsim::ui {

/// The fabric view where graphics are poor: ctest runs this program with the present OpenGL, with one that is
/// too old, with the window system's and with none (KNITTSIM_OPENGL and Mesa's own variable in the
/// environment).
class GraphicsTest : public QObject {
    Q_OBJECT

private slots:
    void theFabricIsSeenWhateverDrawsIt() {
        FabricView view;
        view.resize(320, 240);
        show(view);
        QTRY_VERIFY(!view.bounds().empty());
        QTRY_VERIFY(coloured(view.picture()) > 2000);
    }

    void poorGraphicsAreExplained() {
        FabricView view;
        QSignalSpy failed(&view, &FabricView::glFailed);
        show(view);
        if (!poor()) {
            QTRY_VERIFY(!view.rendererName().isEmpty());
            QCOMPARE(failed.count(), 0);
            return;
        }
        QTRY_COMPARE(failed.count(), 1);
        QVERIFY(!view.hasOpenGl());
        const QString reason = failed.first().first().toString();
        QVERIFY2(reason.contains("OpenGL") && reason.contains("flat"), qPrintable(reason));
    }

    /// Its OpenGL context goes with the first window and is made anew in the second one.
    void inAnotherWindowThePictureIsTheSame() {
        auto first = std::make_unique<QWidget>();
        QWidget second;
        for (QWidget* window : {first.get(), &second}) {
            window->resize(320, 240);
            window->show();
            QVERIFY(QTest::qWaitForWindowExposed(window));
        }
        FabricView view(first.get());
        view.resize(300, 200);
        show(view);
        QTRY_VERIFY(coloured(view.picture()) > 2000);
        const QImage before = view.picture();
        view.setParent(&second);
        first.reset();
        view.show();
        // Meanwhile strands may have been put in order at a few crossings.
        const int most = coloured(before) / 50;
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(coloured(view.picture()) - coloured(before)) < most, 30000);
        QCOMPARE(view.picture().size(), before.size());
    }

    void aViewWithoutAnySizeIsNoTrouble() {
        FabricView view;
        view.setMinimumSize(0, 0);
        show(view);
        QTRY_VERIFY(!view.bounds().empty());
        for (const QSize& size : {QSize(0, 0), QSize(1, 0), QSize(0, 300), QSize(1, 1), QSize(3, 200)}) {
            view.resize(size);
            view.fit();
            view.zoomBy(2);
            QTest::mouseMove(&view, {0, 0});
            QTest::mouseClick(&view, Qt::LeftButton, {}, {0, 0});
            view.picture();
            view.grab();
            QCoreApplication::processEvents();
        }
        view.resize(320, 240);
        view.fit();
        QTRY_VERIFY(coloured(view.picture()) > 2000);
        QVERIFY(std::isfinite(view.cameraState().halfHeight));
    }

    void anEmptyFabricIsNoTrouble() {
        FabricView view;
        view.resize(320, 240);
        view.setFabric(std::make_shared<fabric::Fabric>(), {});
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        view.fit();
        view.setSection(true);
        view.setGuides(true);
        view.startAlignment();
        view.grab();
        QVERIFY(view.bounds().empty());
    }

private:
    static bool poor() {
        return qgetenv("KNITTSIM_OPENGL") == "none" || qEnvironmentVariableIsSet("MESA_GL_VERSION_OVERRIDE");
    }

    static void show(FabricView& view) {
        render::YarnLook look;
        look.colour = {200, 60, 40};
        view.setFabric(std::make_shared<fabric::Fabric>(fabric::buildFabric(
                           machine::Timeline(pattern::makeSample("plain"), machine::genericProfile()))),
                       {look, look, look});
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
    }

    /// Pixels that are not grey.
    static int coloured(const QImage& image) {
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const QRgb c = image.pixel(x, y);
                count += qRed(c) > qBlue(c) + 16 ? 1 : 0;
            }
        }
        return count;
    }
};

} // namespace knittsim::ui

QTEST_MAIN(knittsim::ui::GraphicsTest)
#include "graphics_test.moc"
