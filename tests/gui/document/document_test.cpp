#ifndef Q_MOC_RUN // moc 6.4 does not read all headers of C++20
#include "core/pattern/samples.h"
#endif

#include "ui/document/document.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace knittsim::document {

namespace {

QString sampleText(const char* id) {
    return QString::fromStdString(pattern::sampleText(id));
}

double distanceOfShapes(const std::vector<float>& a, const std::vector<float>& b) {
    double widest = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        widest = std::max(widest, static_cast<double>(std::abs(a[i] - b[i])));
    }
    return widest;
}

} // namespace

class DocumentTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_document = std::make_unique<Document>(); }
    void cleanup() { m_document.reset(); }

    void opensInTheBackground() {
        QSignalSpy opened(m_document.get(), &Document::opened);
        m_document->openText("Plain", sampleText("plain"));
        QVERIFY(m_document->isOpening());
        QVERIFY(!m_document->file());
        QVERIFY(opened.wait());
        QVERIFY(!m_document->isOpening());
        QCOMPARE(m_document->step(), m_document->operationCount());
        QVERIFY(m_document->shownFabric() == m_document->file()->fabric);
        QVERIFY(!m_document->selection().operation || m_document->selection().empty());
    }

    void settlesUntilItIsAtRest() {
        openSettled("rib-1x1");
        QCOMPARE(m_document->stopReason(), simulation::StopReason::ResidualReached);
        QVERIFY(m_document->frame()->residual <= 1e-3);
        QCOMPARE(m_document->shownFrame()->positions.size(),
                 3 * static_cast<std::size_t>(m_document->shownFabric()->entryCount));
    }

    void showsTheFabricAfterAnOperation() {
        openSettled("plain");
        const auto whole = m_document->file()->fabric;
        QSignalSpy shown(m_document.get(), &Document::fabricShown);
        const OperationIndex half = m_document->operationCount() / 2;
        m_document->setStep(half);
        QTRY_COMPARE(shown.count(), 1);
        const auto state = m_document->machineState();
        QCOMPARE(static_cast<int>(m_document->shownFabric()->loops.size()), state.loopCount);
        QVERIFY(m_document->shownFabric()->loops.size() < whole->loops.size());
        QCOMPARE(m_document->shownFrame()->positions.size(),
                 3 * static_cast<std::size_t>(m_document->shownFabric()->entryCount));
        QCOMPARE(m_document->selection().operation, half - 1);
        m_document->setStep(m_document->operationCount());
        QVERIFY(m_document->shownFabric() == whole);
        QVERIFY(m_document->selection().empty());
    }

    void theLatestOfManyStepsWins() {
        openSettled("plain");
        for (OperationIndex k = 10; k < 200; ++k) {
            m_document->setStep(k);
        }
        const int loops = m_document->machineState().loopCount;
        QTRY_COMPARE(static_cast<int>(m_document->shownFabric()->loops.size()), loops);
    }

    void coursesAndPassesAreWalkedBothWays() {
        openSettled("plain");
        m_document->setStep(0);
        int courses = 0;
        while (m_document->step() < m_document->operationCount()) {
            const OperationIndex before = m_document->step();
            m_document->moveCourse(+1);
            QVERIFY(m_document->step() > before);
            ++courses;
        }
        QVERIFY(courses >= m_document->file()->fabric->courseCount);
        const OperationIndex end = m_document->step();
        m_document->movePass(-1);
        const OperationIndex last = m_document->step();
        QVERIFY(last < end);
        m_document->movePass(+1);
        QVERIFY(m_document->step() > last);
    }

    void aYarnIsReplacedAndTheShapeGoesOn() {
        openSettled("plain");
        const auto before = m_document->frame();
        const std::uint64_t generation = m_document->generation();
        const int carrier = usedCarrier();
        yarn::Yarn other = *m_document->library().find("cotton-combed-2-30");
        other.axialStiffnessMilliNewton *= 2; // a body of its own, whatever the sample has
        m_document->assignYarn(carrier, other);
        QCOMPARE(m_document->carriers()[static_cast<std::size_t>(carrier)].yarn, other);
        QTRY_VERIFY(m_document->frame() != before);
        QCOMPARE(m_document->generation(), generation);
        QCOMPARE(m_document->frame()->generation, generation);
        const double pitch = m_document->file()->fabric->pitchMm;
        QVERIFY(distanceOfShapes(m_document->frame()->positions, before->positions) < 3 * pitch);
        QTRY_COMPARE(m_document->activity(), Activity::AtRest);
        m_document->undoStack()->undo();
        QVERIFY(m_document->carriers()[static_cast<std::size_t>(carrier)].yarn != other);
    }

    void aColourDoesNotTouchPhysics() {
        openSettled("plain");
        const auto frame = m_document->frame();
        QSignalSpy yarns(m_document.get(), &Document::yarnsChanged);
        m_document->setCarrierColour(usedCarrier(), {1, 2, 3});
        QCOMPARE(yarns.count(), 1);
        // Commands keep their order: the frame after this one shows whether anything was started before it.
        m_document->setIntegrator("fire");
        QTRY_VERIFY(m_document->frame() != frame);
        QCOMPARE(m_document->frame()->step, frame->step);
        QCOMPARE(m_document->activity(), Activity::AtRest);
    }

    void restartRaisesTheGeneration() {
        openSettled("plain");
        const std::uint64_t generation = m_document->generation();
        const auto settled = m_document->frame()->positions;
        m_document->restart();
        QCOMPARE(m_document->generation(), generation + 1);
        QTRY_COMPARE(m_document->frame()->generation, generation + 1);
        QTRY_COMPARE(m_document->activity(), Activity::AtRest);
        QVERIFY(distanceOfShapes(m_document->frame()->positions, settled) < 0.2);
    }

    void aBrokenFileLeavesTheOldOneOpen() {
        openSettled("plain");
        const auto file = m_document->file();
        QSignalSpy failed(m_document.get(), &Document::openFailed);
        m_document->openText("broken", ";!knitout-2\n;;Carriers: 1\nin 1\nkint + f1 1\n");
        QVERIFY(failed.wait());
        QVERIFY(m_document->file() == file);
        QVERIFY(m_document->failedFile());
        QCOMPARE(m_document->problems().size(), std::size_t{1});
        QCOMPARE(m_document->problems().front().id, std::string("KS0107"));
        QCOMPARE(m_document->problems().front().place.line, 4);
        QCOMPARE(m_document->activity(), Activity::AtRest);
    }

    void aMissingFileIsAProblemToo() {
        QSignalSpy failed(m_document.get(), &Document::openFailed);
        m_document->open("/nowhere/at/all.k");
        QVERIFY(failed.wait());
        QCOMPARE(m_document->problems().front().id, std::string("KS0001"));
        QCOMPARE(m_document->activity(), Activity::Empty);
    }

    void aCancelledOpeningIsUnheard() {
        openSettled("plain");
        const auto file = m_document->file();
        QSignalSpy opened(m_document.get(), &Document::opened);
        QSignalSpy ended(m_document.get(), &Document::openingEnded);
        m_document->openText("Rib", sampleText("rib-2x2"));
        m_document->cancelOpening();
        QCOMPARE(ended.count(), 1);
        QVERIFY(!m_document->isOpening());
        m_document->openText("Garter", sampleText("garter"));
        QVERIFY(opened.wait());
        QCOMPARE(opened.count(), 1);
        QCOMPARE(m_document->file()->request.title, QString("Garter"));
    }

    void selectionIsSharedBothWays() {
        openSettled("plain");
        QSignalSpy changed(m_document.get(), &Document::selectionChanged);
        m_document->selectLoop(40);
        const Selection selection = m_document->selection();
        QVERIFY(selection.line > 0);
        m_document->clearSelection();
        m_document->selectLine(selection.line);
        QCOMPARE(m_document->selection(), selection);
        m_document->selectLine(selection.line);
        QCOMPARE(changed.count(), 3);
    }

    void theIntegratorChangesWhileItRuns() {
        openSettled("plain");
        QVERIFY(simulation::integrators().size() >= 4);
        for (const simulation::IntegratorInfo& info : simulation::integrators().first(4)) {
            m_document->setIntegrator(info.id);
            m_document->restart();
            QTRY_COMPARE(m_document->frame()->generation, m_document->generation());
            QTRY_VERIFY(m_document->frame()->step > 0 || m_document->activity() == Activity::AtRest);
            QTRY_COMPARE(QString::fromStdString(m_document->frame()->integrator), QString(info.id));
        }
    }

    void endsWhileFilesAreBeingOpened() {
        for (int i = 0; i < 5; ++i) {
            Document shortLived;
            shortLived.openText("Jacquard", sampleText("float-jacquard"));
            for (int turn = 0; turn < i * 20; ++turn) {
                QCoreApplication::processEvents();
            }
        }
    }

private:
    void openSettled(const char* id) {
        QSignalSpy opened(m_document.get(), &Document::opened);
        m_document->openText(id, sampleText(id));
        QVERIFY(opened.wait());
        m_document->start();
        QTRY_COMPARE_WITH_TIMEOUT(m_document->activity(), Activity::AtRest, 30000);
    }

    int usedCarrier() const {
        const auto& carriers = m_document->carriers();
        const auto used =
            std::find_if(carriers.begin(), carriers.end(), [](const CarrierYarn& c) { return c.used; });
        return static_cast<int>(used - carriers.begin());
    }

    std::unique_ptr<Document> m_document;
};

} // namespace knittsim::document

QTEST_GUILESS_MAIN(knittsim::document::DocumentTest)
#include "document_test.moc"
