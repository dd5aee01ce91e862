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
        QCOMPARE(shape->curves->nodes.size(), shape->curves->normal.size());
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
        m_document->restart();
        QTRY_VERIFY_WITH_TIMEOUT(!m_document->yarnRun().shape(), kSeconds);
        QVERIFY(!m_document->yarnRun().running());

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
