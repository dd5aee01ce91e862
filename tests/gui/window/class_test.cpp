#include "tests/gui/window/window_fixture.h"
#include "ui/views/needle_beds/needle_beds.h"
#include "ui/views/step_player/step_player.h"
#include "ui/views/style/language.h"

#include <QAbstractItemView>
#include <QApplication>

namespace knittsim::ui {

/// What a teacher finds again: marks of a file, keys wherever the focus is, beds that fit.
class ClassTest : public WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        prepare();
        applyLanguage(*qApp, QStringLiteral("en"));
        program("long.k", 40);
        program("short.k", 8);
    }

    void init() { beginTest(); }

    void cleanup() { endTest(); }

    void marksComeBackWithTheirFile() {
        openFile("long.k");
        for (const int step : {12, 30}) {
            document().setStep(step);
            press(Qt::Key_B, Qt::ControlModifier);
        }
        marks().setLoopFrom(5);
        marks().setLoopTo(20);
        document::StopRules rules;
        rules.set(machine::OperationKind::Xfer, true);
        marks().setRules(rules);
        openFile("short.k");
        QVERIFY(marks().bookmarks().empty());
        QVERIFY(!marks().loops());
        marks().setRules({});
        document().setStep(3);
        press(Qt::Key_B, Qt::ControlModifier);
        m_window->close();
        openWindow();
        openFile("long.k");
        QCOMPARE(marks().bookmarks(), (std::set<int>{12, 30}));
        QCOMPARE(marks().loopFrom(), 5);
        QCOMPARE(marks().loopTo(), 20);
        QVERIFY(marks().rules() == rules);
        openFile("short.k");
        QCOMPARE(marks().bookmarks(), (std::set<int>{3}));
        QVERIFY(!marks().loops());
        QVERIFY(marks().rules().empty());
    }

    void marksBehindTheEndOfAFileThatBecameShorterAreForgotten() {
        openFile("long.k");
        document().setStep(30);
        press(Qt::Key_B, Qt::ControlModifier);
        document().setStep(4);
        press(Qt::Key_B, Qt::ControlModifier);
        openFile("short.k");
        program("long.k", 8);
        openFile("long.k");
        program("long.k", 40);
        QCOMPARE(marks().bookmarks(), (std::set<int>{4}));
    }

    /// Twenty needles fit, though only just: the page is not turned to where there is no fabric.
    void theBedsShowAllOfTheFabricWhereItFits() {
        program("twenty.k", 21);
        openFile("twenty.k");
        NeedleBeds beds(document());
        beds.resize(760, 330);
        beds.show();
        QVERIFY(QTest::qWaitForWindowExposed(&beds));
        for (int step = 1; step <= document().operationCount(); ++step) {
            document().setStep(step);
            QVERIFY2(beds.placeOf({machine::Bed::Front, 1}).x() > 60, qPrintable(QString::number(step)));
            QVERIFY2(beds.placeOf({machine::Bed::Front, 20}).x() < 490, qPrintable(QString::number(step)));
        }
        beds.resize(620, 330); // not all of them, but the one that works
        for (int step = 2; step < document().operationCount(); ++step) {
            document().setStep(step);
            const int x = beds.placeOf({machine::Bed::Front, step - 1}).x();
            QVERIFY2(x > 60 && x < 400, qPrintable(QString::number(step)));
        }
    }

private:
    StepPlayer& player() { return *m_window->findChild<StepPlayer*>(); }
    document::StepMarks& marks() { return player().marks(); }

    void openFile(const char* name) {
        open([&] { m_window->openFile(m_folder.filePath(name)); });
    }

    void program(const char* name, int operations) {
        QByteArray text = ";!knitout-2\n;;Carriers: 1\nin 1\n";
        for (int i = 1; i < operations; ++i) {
            text += "knit + f" + QByteArray::number(i) + " 1\n";
        }
        write(name, text + "out 1\n");
    }
};

} // namespace knittsim::ui

QTEST_MAIN(knittsim::ui::ClassTest)
#include "class_test.moc"
