#include "ui/document/document.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace knittsim::document {

namespace {

constexpr int kWales = 12;

QString pass(int course) {
    QString lines;
    for (int i = 0; i < kWales; ++i) {
        lines += course % 2 == 0 ? QString("knit + f%1 1\n").arg(i)
                                 : QString("knit - f%1 1\n").arg(kWales - 1 - i);
    }
    return lines;
}

/// Plain knit of so many courses; needle 5 lets its loop go at the end where `drop` says so.
QString swatch(int courses, bool drop) {
    QString text = ";!knitout-2\n;;Carriers: 1\nin 1\n";
    for (int course = 0; course < courses; ++course) {
        text += pass(course);
    }
    return text + (drop ? "drop f5\n" : "") + "out 1\n";
}

} // namespace

class LadderTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_document = std::make_unique<Document>(); }
    void cleanup() { m_document.reset(); }

    void aHeldFabricSaysThatNothingRuns() {
        open(swatch(6, false));
        QSignalSpy nothing(m_document.get(), &Document::nothingRuns);
        QCOMPARE(m_document->unstableLoops(), std::size_t{0});
        m_document->removeLadders();
        QCOMPARE(nothing.count(), 1);
        QVERIFY(!m_document->undoStack()->canUndo());
        QVERIFY(!m_document->laddersRun());
    }

    void aDroppedLoopRunsCourseByCourse() {
        open(swatch(8, true));
        settle();
        const auto whole = m_document->shownFabric();
        QCOMPARE(m_document->unstableLoops(), std::size_t{8});
        QSignalSpy shown(m_document.get(), &Document::fabricShown);
        std::vector<std::size_t> gone;
        connect(m_document.get(), &Document::ladderChanged, this,
                [&] { gone.push_back(m_document->removedLoops()); });
        m_document->removeLadders();
        QVERIFY(m_document->laddersRun());
        QTRY_VERIFY_WITH_TIMEOUT(!m_document->laddersRun(), 8000);
        QVERIFY2(shown.count() >= 5, "one picture for each of most steps");
        QVERIFY(std::is_sorted(gone.begin(), gone.end()));
        QCOMPARE(m_document->removedLoops(), std::size_t{8});
        QCOMPARE(m_document->unstableLoops(), std::size_t{0});
        QVERIFY(m_document->shownFabric()->points.size() < whole->points.size());
        QTRY_COMPARE_WITH_TIMEOUT(m_document->activity(), Activity::AtRest, 30000);
        QVERIFY(fits());
    }

    void theShapeGoesOnFromWhereItIs() {
        open(swatch(8, true));
        settle();
        const auto before = m_document->shownFabric();
        const auto settled = m_document->shownFrame()->positions;
        QSignalSpy shown(m_document.get(), &Document::fabricShown);
        m_document->removeLadders();
        QTRY_VERIFY(shown.count() > 0);
        // The first picture: one loop less, and every other place where it was, within what physics moved
        // meanwhile.
        const auto after = m_document->shownFabric();
        QVERIFY(fits());
        const auto place = [](const fabric::Fabric& fabric, const std::vector<float>& places, int loop) {
            const auto point = fabric.loops[static_cast<std::size_t>(loop)].headLeft;
            const auto entry = fabric.points[static_cast<std::size_t>(point)].entry;
            return Vec3f::Map(places.data() + 3 * static_cast<std::size_t>(entry)).eval();
        };
        const auto now = m_document->shownFrame()->positions;
        for (int loop = 0; loop < 8 * kWales; ++loop) {
            if (after->loops[static_cast<std::size_t>(loop)].headLeft >= 0) {
                const float moved = (place(*after, now, loop) - place(*before, settled, loop)).norm();
                QVERIFY2(moved < before->pitchMm, qPrintable(QString::number(moved)));
            }
        }
    }

    void undoPutsTheLoopsBackInOneStep() {
        open(swatch(8, true));
        settle();
        const auto whole = m_document->shownFabric();
        const auto settled = m_document->shownFrame()->positions;
        m_document->removeLadders();
        QTRY_VERIFY_WITH_TIMEOUT(!m_document->laddersRun(), 8000);
        const auto ladder = m_document->shownFabric();
        QCOMPARE(m_document->undoStack()->count(), 1);
        m_document->undoStack()->undo();
        QVERIFY(m_document->shownFabric() == whole);
        QCOMPARE(m_document->shownFrame()->positions, settled);
        QCOMPARE(m_document->unstableLoops(), std::size_t{8});
        QCOMPARE(m_document->removedLoops(), std::size_t{0});
        m_document->undoStack()->redo();
        QVERIFY2(m_document->shownFabric() == ladder, "done again it is there at once");
        QCOMPARE(m_document->removedLoops(), std::size_t{8});
        QVERIFY(fits());
    }

    void aRunIsCancelled() {
        open(swatch(8, true));
        const auto whole = m_document->shownFabric();
        m_document->removeLadders();
        QTRY_VERIFY(m_document->shownFabric() != whole);
        QVERIFY(m_document->laddersRun());
        m_document->cancelLadders();
        QVERIFY(!m_document->laddersRun());
        QVERIFY(m_document->shownFabric() == whole);
        QCOMPARE(m_document->unstableLoops(), std::size_t{8});
        QTest::qWait(400); // what was under way must not be told any more
        QVERIFY(m_document->shownFabric() == whole);
        m_document->removeLadders();
        QTRY_COMPARE_WITH_TIMEOUT(m_document->removedLoops(), std::size_t{8}, 8000);
    }

    void cancellingUndoesNothingElse() {
        open(swatch(8, true));
        m_document->removeLadders();
        yarn::Yarn other = m_document->library().yarns().front();
        other.colour = {1, 2, 3};
        m_document->assignYarn(0, other);
        m_document->cancelLadders();
        QCOMPARE(m_document->carriers()[0].yarn, other);
        QTRY_COMPARE(m_document->removedLoops(), std::size_t{8});
        m_document->undoStack()->undo();
        m_document->undoStack()->undo();
        QVERIFY(m_document->shownFabric() == m_document->file()->fabric);
    }

    void aRunIsSkipped() {
        open(swatch(8, true));
        QElapsedTimer time;
        time.start();
        m_document->removeLadders();
        m_document->removeLadders();
        QTRY_VERIFY(!m_document->laddersRun());
        QVERIFY2(time.elapsed() < 1000, "eight steps take two seconds to watch");
        QCOMPARE(m_document->removedLoops(), std::size_t{8});
        QCOMPARE(m_document->undoStack()->count(), 1);
    }

    void aLongRunTakesAboutFourSeconds() {
        open(swatch(60, true));
        QElapsedTimer time;
        time.start();
        m_document->removeLadders();
        QTRY_VERIFY_WITH_TIMEOUT(!m_document->laddersRun(), 15000);
        QVERIFY2(time.elapsed() > 3000 && time.elapsed() < 6000, qPrintable(QString::number(time.elapsed())));
        QCOMPARE(m_document->removedLoops(), std::size_t{60});
    }

    void withoutTheStitchHolderAllOfItRavels() {
        open(swatch(6, false));
        settle();
        QSignalSpy changed(m_document.get(), &Document::ladderChanged);
        m_document->setStitchHolder(false);
        QCOMPARE(changed.count(), 1);
        QCOMPARE(m_document->unstableLoops(), std::size_t{6 * kWales});
        m_document->removeLadders();
        m_document->removeLadders();
        QTRY_VERIFY(!m_document->laddersRun());
        QCOMPARE(m_document->shownFabric()->entryCount, 0);
        QTRY_COMPARE(m_document->activity(), Activity::AtRest);
        m_document->undoStack()->undo();
        QVERIFY(m_document->shownFabric()->entryCount > 0);
        QTRY_VERIFY(fits());
    }

    void firstTheDroppedOnesThenAll() {
        open(swatch(6, true));
        skipThrough();
        QCOMPARE(m_document->removedLoops(), std::size_t{6});
        m_document->setStitchHolder(false);
        QCOMPARE(m_document->unstableLoops(), std::size_t{6 * (kWales - 1)});
        skipThrough();
        QCOMPARE(m_document->undoStack()->count(), 2);
        for (int i = 0; i < 2; ++i) {
            m_document->undoStack()->undo();
        }
        QVERIFY(m_document->shownFabric() == m_document->file()->fabric);
        for (int i = 0; i < 2; ++i) {
            m_document->undoStack()->redo();
        }
        QCOMPARE(m_document->removedLoops(), std::size_t{6 * kWales});
    }

    void steppingBackShowsTheMachinesFabric() {
        open(swatch(8, true));
        skipThrough();
        settle();
        const auto ladder = m_document->shownFabric();
        const OperationIndex end = m_document->operationCount();
        const OperationIndex beforeTheDrop = end - 2;
        m_document->setStep(beforeTheDrop);
        QTRY_VERIFY(m_document->shownFabric() != ladder);
        const auto stepped = m_document->shownFabric();
        QVERIFY2(std::ranges::all_of(stepped->loops, [](const fabric::Loop& l) { return l.headLeft >= 0; }),
                 "nothing has run before the end");
        QVERIFY(fits());
        m_document->setStep(end);
        QVERIFY(m_document->shownFabric() == ladder);
        m_document->setStep(beforeTheDrop);
        m_document->undoStack()->undo();
        QCOMPARE(m_document->step(), end);
        QVERIFY(m_document->shownFabric() == m_document->file()->fabric);
    }

    void aRunGoesToItsEndOutOfSight() {
        open(swatch(8, true));
        m_document->removeLadders();
        m_document->setStep(40);
        QTRY_VERIFY(!m_document->laddersRun());
        QTRY_COMPARE(static_cast<int>(m_document->shownFabric()->loops.size()),
                     m_document->machineState().loopCount);
        QTRY_VERIFY(m_document->shownFrame() && fits());
        m_document->setStep(m_document->operationCount());
        QCOMPARE(m_document->shownFabric()->loops[5].headLeft, -1);
        QVERIFY(fits());
    }

    void restartKeepsTheLadderOut() {
        open(swatch(8, true));
        settle();
        m_document->removeLadders();
        const std::uint64_t generation = m_document->generation();
        m_document->restart();
        QTRY_VERIFY(!m_document->laddersRun());
        QVERIFY(m_document->generation() > generation);
        QTRY_COMPARE(m_document->frame()->generation, m_document->generation());
        QTRY_COMPARE_WITH_TIMEOUT(m_document->activity(), Activity::AtRest, 30000);
        QCOMPARE(m_document->removedLoops(), std::size_t{8});
        QVERIFY(fits());
    }

    void beforeItSettlesTheMachineKeepsItsShape() {
        open(swatch(8, true));
        QTRY_VERIFY(m_document->frame());
        QCOMPARE(m_document->activity(), Activity::Machine);
        skipThrough();
        QCOMPARE(m_document->activity(), Activity::Machine);
        QTRY_VERIFY(fits());
        const auto fabric = m_document->shownFabric();
        for (std::size_t e = 0; e < fabric->machinePositions.size(); ++e) {
            QCOMPARE(m_document->shownFrame()->positions[3 * e + 1],
                     static_cast<float>(fabric->machinePositions[e].y()));
        }
    }

    void anotherFileEndsTheRun() {
        open(swatch(8, true));
        m_document->removeLadders();
        open(swatch(6, false));
        QVERIFY(!m_document->laddersRun());
        QCOMPARE(m_document->removedLoops(), std::size_t{0});
        QTest::qWait(300);
        QVERIFY(m_document->shownFabric() == m_document->file()->fabric);
        QVERIFY(!m_document->undoStack()->canUndo());
    }

private:
    void open(const QString& text) {
        QSignalSpy opened(m_document.get(), &Document::opened);
        m_document->openText("Swatch", text);
        QVERIFY(opened.wait());
    }

    void settle() {
        m_document->start();
        QTRY_COMPARE_WITH_TIMEOUT(m_document->activity(), Activity::AtRest, 30000);
    }

    void skipThrough() {
        m_document->removeLadders();
        m_document->removeLadders();
        QTRY_VERIFY(!m_document->laddersRun());
    }

    /// The frame shown belongs to the fabric shown.
    bool fits() const {
        const auto frame = m_document->shownFrame();
        return frame &&
               frame->positions.size() == 3 * static_cast<std::size_t>(m_document->shownFabric()->entryCount);
    }

    std::unique_ptr<Document> m_document;
};

} // namespace knittsim::document

QTEST_GUILESS_MAIN(knittsim::document::LadderTest)
#include "ladder_test.moc"
