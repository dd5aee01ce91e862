#ifndef Q_MOC_RUN // moc 6.4 does not read all headers of C++20
#include "core/formats/knitout/writer.h"
#include "core/pattern/swatch.h"
#endif

#include "ui/views/chart_editor/chart_canvas.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/views/pattern_editor/pattern_grid.h"
#include "ui/views/style/appearance.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QUndoStack>

#include <algorithm>
#include <ctime>
#include <numeric>
#include <vector>

namespace knittsim::ui {

namespace {

/// Processor time of this thread: what an event costs, however busy the machine is.
double threadMs() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

/// Remembers the event whose handling took the most processor time.
class MeasuringApplication : public QApplication {
public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override {
        const QByteArray name = receiver->metaObject()->className();
        const QEvent::Type type = event->type();
        const double before = threadMs();
        const bool handled = QApplication::notify(receiver, event);
        const double ms = threadMs() - before;
        // Events within events: the innermost slow one says most, and ends first.
        if (ms > 1.2 * m_longest) {
            m_longest = ms;
            m_what = QStringLiteral("%1 for %2").arg(static_cast<int>(type)).arg(QString::fromLatin1(name));
        }
        return handled;
    }

    QString slowest() const {
        return QStringLiteral("event %1, %2 ms of processor time").arg(m_what).arg(m_longest, 0, 'f', 1);
    }
    void reset() { m_longest = 0; }

private:
    double m_longest = 0;
    QString m_what;
};

MeasuringApplication& measuring() {
    return *static_cast<MeasuringApplication*>(qApp);
}

/// How long the event loop was away: a timer of no interval asks as often as it can.
class GapMeter : public QObject {
public:
    GapMeter() {
        m_clock.start();
        m_timer.setInterval(0);
        connect(&m_timer, &QTimer::timeout, this, [this] { note(); });
        m_timer.start();
    }

    void reset() {
        m_longest = 0;
        m_count = 0;
        m_over = 0;
        measuring().reset();
        m_clock.restart();
    }

    double longestMs() const { return m_longest; }
    int turns() const { return m_count; }
    int turnsOver50Ms() const { return m_over; }

private:
    void note() {
        const double gap = static_cast<double>(m_clock.nsecsElapsed()) * 1e-6;
        m_longest = std::max(m_longest, gap);
        m_over += gap > 50 ? 1 : 0;
        ++m_count;
        m_clock.restart();
    }

    QTimer m_timer;
    QElapsedTimer m_clock;
    double m_longest = 0;
    int m_count = 0;
    int m_over = 0;
};

} // namespace

/// Opens and settles 100 x 100 stitches and prints how long the window was away at most. Times are no
/// assertions: they say nothing on a busy machine.
class ResponsivenessTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        qputenv("KNITTSIM_CONFIG_DIR", m_folder.path().toUtf8());
        applyAppearance(*qApp, document::Appearance::Light);
    }

    void settling10000Stitches() {
        MainWindow window;
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        window.openSample("plain"); // the first picture sets OpenGL up
        QTRY_COMPARE_WITH_TIMEOUT(window.document().activity(), document::Activity::AtRest, 30000);

        GapMeter meter;
        const QString program = QString::fromStdString(formats::knitout::write(pattern::makePlain(100, 100)));
        const auto before = window.document().file();
        meter.reset();
        window.document().openText("100 x 100", program);
        QTRY_VERIFY_WITH_TIMEOUT(window.document().file() != before, 30000);
        report("opening", meter);
        meter.reset();
        QTRY_COMPARE_WITH_TIMEOUT(window.document().activity(), document::Activity::AtRest, 120000);
        report("settling", meter);
        QVERIFY(window.document().file()->grid->loopCount() >= 10000);
        meter.reset();
        for (int course = 0; course < 20; ++course) {
            window.document().moveCourse(-1);
            QCoreApplication::processEvents();
        }
        report("stepping", meter);
        window.document().setStitchHolder(false);
        meter.reset();
        window.document().removeLadders();
        QTRY_VERIFY_WITH_TIMEOUT(!window.document().laddersRun(), 30000);
        report("ravelling", meter);
        QVERIFY(meter.turns() > 0);
        const auto* view = window.findChild<FabricView*>("fabricView");
        qInfo("renderer %s, last paint %.1f ms", qPrintable(view->rendererName()), view->lastPaintMs());
    }

    void editingAChartOf60x60() {
        MainWindow window;
        window.resize(1280, 800);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        auto project = std::make_shared<pattern::Project>();
        project->chart = pattern::plainChart(60, 60);
        QSignalSpy opened(&window.document(), &document::Document::opened);
        window.document().openProject("60 x 60", project);
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, 60000);
        QTRY_COMPARE_WITH_TIMEOUT(window.document().activity(), document::Activity::AtRest, 60000);
        GapMeter meter;
        meter.reset();
        for (int i = 0; i < 5; ++i) {
            QSignalSpy shown(&window.document(), &document::Document::fabricShown);
            QElapsedTimer timer;
            timer.start();
            window.document().editChart(
                "purl", [i](pattern::Chart& chart) { chart.at(20 + i, 30).stitch = pattern::Stitch::Purl; });
            QTRY_COMPARE_WITH_TIMEOUT(shown.count(), 1, 10000);
            qInfo("the fabric of 60 x 60 follows after %lld ms", static_cast<long long>(timer.elapsed()));
        }
        report("editing 60 x 60", meter);
    }

    void painting150000Stitches() {
        MainWindow window;
        window.resize(1280, 800);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        GapMeter meter;
        meter.reset();
        window.document().openText(
            "300 x 500", QString::fromStdString(formats::knitout::write(pattern::makePlain(300, 500))));
        QTRY_VERIFY_WITH_TIMEOUT(window.document().file(), 60000);
        report("opening 150,000", meter);
        auto* grid = window.findChild<PatternGrid*>("patternGrid");
        grid->setParent(nullptr); // a window of its own, as large as a screen
        grid->resize(1280, 800);
        grid->show();
        for (int zoom = 0; zoom < 12; ++zoom) {
            grid->zoomOut();
        }
        while (grid->geometryOfChart().cellWidth < 24) {
            const double before = threadMs();
            const QImage picture = grid->grab().toImage();
            qInfo("pattern grid, cells of %d: %.1f ms of processor time", grid->geometryOfChart().cellWidth,
                  threadMs() - before);
            QVERIFY(!picture.isNull());
            grid->zoomIn();
        }
        delete grid;
    }

    /// What a paint, a move of the pencil and the end of its stroke cost the window.
    void drawingAChartOf500x500() {
        MainWindow window;
        window.resize(1280, 800);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        auto project = std::make_shared<pattern::Project>();
        project->chart = pattern::plainChart(500, 500);
        QSignalSpy opened(&window.document(), &document::Document::opened);
        window.document().openProject("500 x 500", project);
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, 120000);
        window.document().stop();
        auto* canvas = window.findChild<ChartCanvas*>("chartCanvas");
        canvas->setTool(ChartTool::Pencil);
        const auto cost = [](const auto& work) {
            const double before = threadMs();
            work();
            return threadMs() - before;
        };
        for (int zoom = 0; zoom < 4; ++zoom) {
            const double paint = cost([&] { canvas->viewport()->repaint(); });
            const auto place = [&](int i) {
                const ChartGeometry& at = canvas->geometryOfChart();
                const int course = at.visibleCourses().first + 3 + i;
                return at.cellRect(course, at.visibleColumns().first + 3 + i).center();
            };
            QTest::mousePress(canvas->viewport(), Qt::LeftButton, {}, place(0));
            double move = 0;
            for (int i = 1; i <= 10; ++i) {
                move = std::max(move, cost([&] {
                                    QTest::mouseMove(canvas->viewport(), place(i));
                                    canvas->viewport()->repaint();
                                }));
            }
            const double edit =
                cost([&] { QTest::mouseRelease(canvas->viewport(), Qt::LeftButton, {}, place(10)); });
            qInfo("chart of 500 x 500, cells of %d: ms of processor time a paint %.1f, a move of the pencil "
                  "%.1f at most, the edit at its end %.1f",
                  canvas->geometryOfChart().cellWidth, paint, move, edit);
            QCOMPARE(window.document().undoStack()->count(), zoom + 1);
            canvas->zoomIn();
            canvas->zoomIn();
        }
    }

    /// The slider is drawn over a long program: 33 ms a step are 30 pictures a second.
    void scrubbing100000Operations() {
        for (const Layout layout : {Layout::Standard, Layout::Teaching}) {
            MainWindow window;
            window.resize(1280, 800);
            window.applyLayout(layout);
            window.show();
            QVERIFY(QTest::qWaitForWindowExposed(&window));
            window.document().openText(
                "250 x 400", QString::fromStdString(formats::knitout::write(pattern::makePlain(250, 400))));
            QTRY_VERIFY_WITH_TIMEOUT(window.document().file(), 60000);
            const int count = window.document().operationCount();
            QVERIFY(count >= 100000);
            window.document().stop();
            std::vector<double> costs;
            double longestStep = 0; // of setStep() alone, without what its events cost
            QElapsedTimer wall;
            measuring().reset();
            wall.start();
            for (int i = 1; i <= 100; ++i) {
                const double before = threadMs();
                window.document().setStep(static_cast<int>(std::int64_t{i} * 7919 % 101 * count / 101));
                longestStep = std::max(longestStep, threadMs() - before);
                QCoreApplication::processEvents();
                costs.push_back(threadMs() - before);
            }
            const double wallMs = static_cast<double>(wall.elapsed()) / 100;
            const double mean = std::accumulate(costs.begin(), costs.end(), 0.0) / 100;
            std::ranges::sort(costs);
            qInfo("scrubbing %d operations, layout %d: %.0f steps in a second of processor time; ms a step: "
                  "50 %% %.1f, 90 %% %.1f, 99 %% %.1f, longest %.1f, wall %.1f; setStep() %.1f at most, "
                  "slowest %s",
                  count, static_cast<int>(layout), 1000 / mean, costs[49], costs[89], costs[98], costs.back(),
                  wallMs, longestStep, qPrintable(measuring().slowest()));
            QCOMPARE(window.document().step(),
                     static_cast<int>(std::int64_t{100} * 7919 % 101 * count / 101));
        }
    }

private:
    static void report(const char* what, const GapMeter& meter) {
        qInfo("%s: longest gap of the event loop %.1f ms; %d of %d turns over 50 ms; slowest: %s", what,
              meter.longestMs(), meter.turnsOver50Ms(), meter.turns(), qPrintable(measuring().slowest()));
    }

    QTemporaryDir m_folder;
};

} // namespace knittsim::ui

int main(int argc, char** argv) {
    knittsim::ui::MeasuringApplication application(argc, argv);
    knittsim::ui::ResponsivenessTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "responsiveness_test.moc"
