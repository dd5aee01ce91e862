#include "ui/document/document.h"
#include "ui/document/pull_run.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

#include <cmath>

namespace knittsim::document {

namespace {
constexpr int kSeconds = 60'000;
}

class PullRunTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        QString text = ";!knitout-2\n;;Carriers: 1\nin 1\n";
        for (int course = 0; course < 8; ++course) {
            for (int i = 0; i < 8; ++i) {
                text +=
                    course % 2 == 0 ? QString("knit + f%1 1\n").arg(i) : QString("knit - f%1 1\n").arg(7 - i);
            }
        }
        m_document = std::make_unique<Document>();
        QSignalSpy opened(m_document.get(), &Document::opened);
        m_document->openText("swatch", text + "out 1\n");
        QTRY_COMPARE(opened.count(), 1);
    }
    void cleanup() { m_document.reset(); }

    void pointsComeOneByOneAndForceRises() {
        PullRun run;
        std::size_t most = 0;
        connect(&run, &PullRun::changed, this, [&] {
            QVERIFY(run.points().size() <= most + 1);
            most = run.points().size();
        });
        run.start(m_document->shownFabric(), {}, {.strain = 0.1, .steps = 4});
        QVERIFY(run.running());
        QTRY_VERIFY_WITH_TIMEOUT(!run.running(), kSeconds);
        QCOMPARE(run.state(), PullRun::State::Done);
        const auto& points = run.points();
        QVERIFY(points.size() > 5);
        QVERIFY(std::abs(points[4].strain - 0.1) < 1e-4);
        QVERIFY(points[4].stress > points[1].stress && points[1].stress > points[0].stress);
        QVERIFY(points.back().back);
        QCOMPARE(run.csv().count('\n'), static_cast<int>(points.size()) + 1);
        QVERIFY(run.csv().startsWith("strain,stress_n_per_mm,"));
    }

    void stopsAtOnceAndKeepsItsPoints() {
        PullRun run;
        run.start(m_document->shownFabric(), {}, {.strain = 2, .steps = 200});
        QTRY_VERIFY_WITH_TIMEOUT(run.points().size() > 1 || !run.running(), kSeconds);
        QElapsedTimer clock;
        clock.start();
        run.stop();
        QVERIFY(clock.elapsed() < 50);
        QCOMPARE(run.state(), PullRun::State::Stopped);
        const std::size_t kept = run.points().size();
        QTest::qWait(200);
        QCOMPARE(run.points().size(), kept);
    }

    void aFabricWithoutARepeatSaysSo() {
        PullRun run;
        run.start(std::make_shared<fabric::Fabric>(), {}, {});
        QTRY_COMPARE_WITH_TIMEOUT(run.state(), PullRun::State::NoRepeat, kSeconds);
        QVERIFY(run.points().empty());
    }

private:
    std::unique_ptr<Document> m_document;
};

} // namespace knittsim::document

QTEST_GUILESS_MAIN(knittsim::document::PullRunTest)
#include "pull_run_test.moc"
