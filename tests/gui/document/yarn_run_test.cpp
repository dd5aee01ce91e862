#include "ui/document/document.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

namespace knittsim::document {

namespace {

constexpr int kWales = 8;
constexpr int kSeconds = 60'000;

QString swatch(int courses) {
    QString text = ";!knitout-2\n;;Carriers: 1\nin 1\n";
    for (int course = 0; course < courses; ++course) {
        for (int i = 0; i < kWales; ++i) {
            text += course % 2 == 0 ? QString("knit + f%1 1\n").arg(i)
                                    : QString("knit - f%1 1\n").arg(kWales - 1 - i);
        }
    }
    return text + "out 1\n";
}

yarn::Yarn thicker(double by) {
    yarn::Yarn yarn = yarn::defaultYarn();
    yarn.outerDiameterMm *= by;
    yarn.coreDiameterMm *= by;
    return yarn;
}

} // namespace

class YarnRunTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_document = std::make_unique<Document>(); }
    void cleanup() { m_document.reset(); }

    void nothingOpenIsNothingToSettle() {
        m_document->settleYarn();
        QVERIFY(!m_document->yarnRun().running());
        QVERIFY(!m_document->yarnRun().shape());
    }

    void tellsShapesAndEndsAtRestWithItsAudit() {
        open(swatch(8));
        int shapes = 0;
        connect(m_document.get(), &Document::yarnRunChanged, this,
                [&] { shapes += m_document->yarnRun().shape() ? 1 : 0; });
        m_document->settleYarn();
        QVERIFY(m_document->yarnRun().running());
        QTRY_VERIFY_WITH_TIMEOUT(!m_document->yarnRun().running(), kSeconds);
        const auto shape = m_document->yarnRun().shape();
        QVERIFY(shape && shape->finished);
        QVERIFY(physics::isAtRest(shape->verdict));
        QCOMPARE(shape->fabric, m_document->shownFabric());
        QVERIFY(shapes >= 1);
        QCOMPARE(shape->audit.coreOverlaps, 0);
        const double loop = shape->fabric->made.loops.front().lengthMm;
        QVERIFY(shape->measured.waleSpacingMm > 0.15 * loop && shape->measured.waleSpacingMm < 0.4 * loop);
        QCOMPARE(shape->picture->curves.nodes.size(), shape->picture->tension.size());
    }

    void stoppingKeepsWhatThereIs() {
        open(swatch(30));
        m_document->settleYarn();
        QTRY_VERIFY_WITH_TIMEOUT(m_document->yarnRun().shape(), kSeconds);
        if (!m_document->yarnRun().running()) {
            QSKIP("this machine is too quick to be stopped");
        }
        QElapsedTimer clock;
        clock.start();
        m_document->settleYarn();
        QVERIFY(clock.elapsed() < 50);
        QVERIFY(!m_document->yarnRun().running());
        const auto shape = m_document->yarnRun().shape();
        QVERIFY(shape && !shape->finished);
        QTest::qWait(300);
        QCOMPARE(m_document->yarnRun().shape(), shape);
    }

    void physicsThatGoesOnAndOtherStepsEndIt() {
        open(swatch(6));
        m_document->settleYarn();
        QTRY_VERIFY_WITH_TIMEOUT(m_document->yarnRun().shape(), kSeconds);
        m_document->start();
        QTRY_VERIFY_WITH_TIMEOUT(!m_document->yarnRun().shape(), kSeconds);
        QVERIFY(!m_document->yarnRun().exists());

        QTRY_COMPARE_WITH_TIMEOUT(m_document->activity(), Activity::AtRest, kSeconds);
        m_document->settleYarn();
        QTRY_VERIFY_WITH_TIMEOUT(m_document->yarnRun().shape(), kSeconds);
        m_document->moveStep(-1);
        QTRY_VERIFY_WITH_TIMEOUT(!m_document->yarnRun().shape(), kSeconds);
    }

    void beginsAtTheEndOfTheProgram() {
        open(swatch(6));
        m_document->setStep(10);
        m_document->settleYarn();
        QCOMPARE(m_document->step(), m_document->operationCount());
        QTRY_VERIFY_WITH_TIMEOUT(!m_document->yarnRun().running(), kSeconds);
    }

    void aStoppedRunGoesOnFromWhereItWas() {
        open(swatch(20));
        m_document->settleYarn();
        QTRY_VERIFY_WITH_TIMEOUT(m_document->yarnRun().shape(), kSeconds);
        const auto generation = m_document->yarnRun().generation();
        if (m_document->yarnRun().running()) {
            m_document->settleYarn();
            QVERIFY(!m_document->yarnRun().running());
            m_document->settleYarn();
        }
        QTRY_VERIFY_WITH_TIMEOUT(!m_document->yarnRun().running(), kSeconds);
        QVERIFY(m_document->yarnRun().shape()->finished);
        QCOMPARE(m_document->yarnRun().generation(), generation);
    }

    void anotherYarnGoesOnFromTheShape() {
        open(swatch(4));
        m_document->settleYarn();
        QTRY_VERIFY_WITH_TIMEOUT(!m_document->yarnRun().running(), kSeconds);
        const auto before = m_document->yarnRun().shape();
        m_document->assignYarn(0, thicker(1.3));
        QVERIFY(m_document->yarnRun().running());
        QTRY_VERIFY_WITH_TIMEOUT(!m_document->yarnRun().running(), kSeconds);
        const auto after = m_document->yarnRun().shape();
        QVERIFY(after != before);
        QVERIFY(after->finished);
        QCOMPARE(after->generation, before->generation);
        QCOMPARE(after->audit.coreOverlaps, 0);
        m_document->undoStack()->undo();
        QVERIFY(m_document->yarnRun().running());
    }

    void restartsFromTheMachine() {
        open(swatch(4));
        m_document->settleYarn();
        QTRY_VERIFY_WITH_TIMEOUT(!m_document->yarnRun().running(), kSeconds);
        const auto generation = m_document->yarnRun().generation();
        m_document->restart();
        QVERIFY(m_document->yarnRun().running());
        QCOMPARE(m_document->yarnRun().generation(), generation + 1);
        QTRY_VERIFY_WITH_TIMEOUT(!m_document->yarnRun().running(), kSeconds);
        QCOMPARE(m_document->yarnRun().shape()->generation, generation + 1);
    }

    /// Shapes of an earlier start never come, and nothing keeps a run that has ended.
    void swapsAndRestartsTwoHundredTimes() {
        open(swatch(2));
        const auto fabric = m_document->shownFabric();
        const std::vector<yarn::Yarn> yarns(10);
        const long owners = fabric.use_count();
        YarnRun run;
        int stale = 0;
        int shapes = 0;
        connect(&run, &YarnRun::changed, this, [&] {
            if (run.shape()) {
                ++shapes;
                stale += run.shape()->generation > run.generation() ? 1 : 0;
            }
        });
        std::uint64_t last = 0;
        for (int i = 0; i < 200; ++i) {
            run.start(fabric, yarns);
            QCOMPARE(run.generation(), last + 1);
            last = run.generation();
            run.setYarn(1, thicker(i % 2 == 0 ? 1.2 : 0.8));
            if (i % 10 == 0) { // most are restarted before they have come to anything
                QTRY_VERIFY_WITH_TIMEOUT(run.shape() && run.shape()->generation == last, kSeconds);
            }
            QCoreApplication::processEvents();
            if (run.shape()) {
                QVERIFY(run.shape()->generation <= last);
            }
        }
        for (int i = 0; i < 200; ++i) {
            run.setYarn(1, thicker(i % 2 == 0 ? 0.8 : 1.2));
            QCOMPARE(run.edits(), i + 2);
            if (i % 10 == 0) {
                QTRY_VERIFY_WITH_TIMEOUT(run.shape()->edits == i + 2, kSeconds);
            }
        }
        QTRY_VERIFY_WITH_TIMEOUT(!run.running(), kSeconds);
        QCOMPARE(run.shape()->generation, last);
        QCOMPARE(run.shape()->edits, 201);
        QVERIFY(run.shape()->finished);
        QCOMPARE(run.shape()->audit.coreOverlaps, 0);
        QCOMPARE(stale, 0);
        QVERIFY(shapes >= 40);
        run.clear();
        QTRY_COMPARE_WITH_TIMEOUT(fabric.use_count(), owners, kSeconds);
    }

    void pullsAndSurroundingsWakeWhatIsAtRest() {
        open(swatch(4));
        m_document->settleYarn();
        QTRY_VERIFY_WITH_TIMEOUT(!m_document->yarnRun().running(), kSeconds);
        const auto& points = m_document->shownFabric()->points;
        const auto point = static_cast<fabric::PointIndex>(points.size() / 2);
        const auto placeOf = [&](const YarnShape& shape) {
            const auto e = 3 * static_cast<std::size_t>(points[static_cast<std::size_t>(point)].entry);
            return Vec3(shape.picture->positions[e], shape.picture->positions[e + 1],
                        shape.picture->positions[e + 2]);
        };
        const auto rest = m_document->yarnRun().shape();
        const Vec3 target = placeOf(*rest) + Vec3(0, 0, 4);
        for (int i = 1; i <= 20; ++i) {
            m_document->drag(point, placeOf(*rest) + Vec3(0, 0, 0.2 * i));
        }
        QTRY_VERIFY_WITH_TIMEOUT(!m_document->yarnRun().running(), kSeconds);
        const auto pulled = m_document->yarnRun().shape();
        QVERIFY((placeOf(*pulled) - target).norm() < 3);
        QCOMPARE(pulled->audit.coreOverlaps, 0);
        m_document->releaseDrag();
        QVERIFY(m_document->yarnRun().running());
        QTRY_VERIFY_WITH_TIMEOUT(!m_document->yarnRun().running(), kSeconds);
        m_document->setSurroundings(simulation::Surroundings::Pinned);
        QVERIFY(m_document->yarnRun().running());
        QTRY_VERIFY_WITH_TIMEOUT(!m_document->yarnRun().running(), kSeconds);
    }

private:
    void open(const QString& text) {
        QSignalSpy opened(m_document.get(), &Document::opened);
        m_document->openText("swatch", text);
        QTRY_COMPARE(opened.count(), 1);
    }

    std::unique_ptr<Document> m_document;
};

} // namespace knittsim::document

QTEST_GUILESS_MAIN(knittsim::document::YarnRunTest)
#include "yarn_run_test.moc"
