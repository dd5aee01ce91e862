#include "tests/gui/window/window_fixture.h"
#include "ui/dialogs/glossary_dialog.h"
#include "ui/document/operation_text.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/views/lesson/lesson_panel.h"
#include "ui/views/lesson/teaching_board.h"
#include "ui/views/needle_beds/needle_beds.h"
#include "ui/views/step_player/step_player.h"
#include "ui/views/style/appearance.h"
#include "ui/views/style/language.h"
#include "ui/window/banner.h"

#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QImageReader>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QProgressDialog>
#include <QPushButton>
#include <QToolBar>
#include <QToolButton>
#include <QTreeWidget>

namespace knittsim::ui {

using document::Document;

class TeachingTest : public WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }

    void init() {
        applyLanguage(*qApp, QStringLiteral("en"));
        beginTest();
    }

    void cleanup() {
        endTest();
        applyLanguage(*qApp, QStringLiteral("en"));
    }

    void aLessonSetsUpTheClassAndLeadsThroughItsStops() {
        begin(4); // cable
        QVERIFY(child<TeachingBoard>("teachingBoard")->isVisible());
        QVERIFY(child<QWidget>("needleBeds")->isVisible());
        QVERIFY(child<LessonPanel>("lessonPanel")->isVisible());
        QVERIFY(!child<QToolBar>("toolBar")->isVisible());
        const auto steps = panel().stopSteps();
        QVERIFY(steps.size() >= 4);
        QCOMPARE(document().step(), steps.at(0));
        press(Qt::Key_PageDown);
        QCOMPARE(document().step(), steps.at(1));
        QTest::mouseClick(child<QToolButton>("stopNext"), Qt::LeftButton);
        QCOMPARE(document().step(), steps.at(2));
        QVERIFY(child<QLabel>("lessonTitle")->text().contains("rack", Qt::CaseInsensitive));
        press(Qt::Key_PageUp);
        QCOMPARE(document().step(), steps.at(1));
        QVERIFY(child<TeachingBoard>("teachingBoard")
                    ->sentence()
                    .startsWith("Transfer: the loop on front needle"));
        QCOMPARE(child<StepPlayer>("stepPlayer")->marks().bookmarks().size(), steps.size());
        QTRY_COMPARE(document().shownStep(), steps.at(1));
        QTRY_VERIFY(!document().needleHooks().empty());
        QCOMPARE(document().selection().operation, steps.at(1) - 1);
        QVERIFY2(document().selection().loop >= 0, "the loop that moved is highlighted");
    }

    void everyLessonStopsWhereItSays() {
        for (std::size_t i = 0; i < panel().lessons().size(); ++i) {
            begin(static_cast<int>(i));
            const auto steps = panel().stopSteps();
            QVERIFY2(std::ranges::is_sorted(steps), panel().current()->id.c_str());
            QVERIFY2(std::ranges::adjacent_find(steps) == steps.end(), panel().current()->id.c_str());
            for (std::size_t stop = 1; stop < steps.size(); ++stop) {
                press(Qt::Key_PageDown);
                QCOMPARE(document().step(), steps.at(stop));
            }
        }
    }

    void anOwnLessonIsOpenedAndABrokenOneIsToldAbout() {
        write("program.k", ";!knitout-2\n;;Carriers: 1\nin 1\nknit + f1 1\nknit + f2 1\nout 1\n");
        const QString good = write(
            "mine.json", R"({"title": {"en": "Mine"}, "summary": {"en": "S"}, "file": "program.k", "stops": [
                {"at": {"line": 5}, "title": {"en": "Here"}, "text": {"en": "Look"}, "look": "source"}]})");
        const QString bad = write("bad.json", R"({"title": {"en": "Mine"}})");
        m_window->openLesson(bad);
        QVERIFY(child<Banner>("banner")->isVisible());
        QVERIFY2(child<Banner>("banner")->text().contains("summary"),
                 qPrintable(child<Banner>("banner")->text()));
        m_window->openLesson(write("other.json",
                                   "{\n \"title\": {\"en\": \"Mine\"},\n \"summary\": {\"en\": \"S\"},\n"
                                   " \"sample\": \"nonsense\",\n \"stops\": [{\"at\": {\"end\": true},"
                                   " \"title\": {\"en\": \"A\"}, \"text\": {\"en\": \"B\"},"
                                   " \"look\": \"beds\"}]}"));
        QVERIFY2(child<Banner>("banner")->text().contains("line 4: 'sample' is \"nonsense\""),
                 qPrintable(child<Banner>("banner")->text()));
        m_window->openLesson(good);
        QTRY_VERIFY(panel().running());
        QCOMPARE(panel().stopSteps().at(0), 3);
        QCOMPARE(document().step(), 3);
        QVERIFY(child<QDockWidget>("sourceDock")->isVisible());
    }

    void aLessonThatDoesNotComeLeavesTheNextFileAlone() {
        begin(0);
        const std::string id = panel().current()->id;
        panel().begin(1);
        document().cancelOpening();
        QVERIFY(panel().running());
        QCOMPARE(panel().current()->id, id);
        openSample("plain");
        QVERIFY(!panel().running());
        panel().begin(1);
        openSample("plain"); // overtakes it
        QVERIFY(!panel().running());
        QVERIFY(!panel().current());
    }

    void aLessonEndsWhereItsProgramBecomesAChart() {
        write("program.k", ";!knitout-2\n;;Carriers: 1\nin 1\nknit + f1 1\nknit + f2 1\nout 1\n");
        const QString own = write(
            "mine.json", R"({"title": {"en": "Mine"}, "summary": {"en": "S"}, "file": "program.k", "stops": [
                {"at": {"line": 5}, "title": {"en": "Here"}, "text": {"en": "Look"}, "look": "source"}]})");
        m_window->openLesson(own);
        QTRY_VERIFY(panel().running());
        emit document().lifted(); // whether these few stitches make a chart is not what is tested
        QVERIFY(!panel().running());
        QVERIFY(panel().stopSteps().empty());
    }

    void layoutsHaveAKeyEachAndAreRemembered() {
        openSample("plain");
        press(Qt::Key_F7);
        QVERIFY(child<QDockWidget>("problemDock")->isVisible());
        QVERIFY(!child<QDockWidget>("yarnDock")->isVisible());
        press(Qt::Key_F4);
        QVERIFY(child<TeachingBoard>("teachingBoard")->isVisible());
        QVERIFY(!child<QDockWidget>("sourceDock")->isVisible());
        child<QDockWidget>("sourceDock")->show(); // as this teacher likes it
        press(Qt::Key_F3);
        QVERIFY(child<QDockWidget>("yarnDock")->isVisible());
        QVERIFY(!child<TeachingBoard>("teachingBoard")->isVisible());
        QVERIFY(child<QToolBar>("toolBar")->isVisible());
        press(Qt::Key_F4);
        QVERIFY(child<QDockWidget>("sourceDock")->isVisible());
        m_window->close();
        openWindow();
        openSample("plain");
        QVERIFY(child<TeachingBoard>("teachingBoard")->isVisible());
        QVERIFY(child<QDockWidget>("sourceDock")->isVisible());
    }

    void theBoardIsReadFromAfarAndSharp() {
        openSample("plain");
        press(Qt::Key_F4);
        document().setStep(130);
        auto* course = child<QLabel>("boardCourse");
        QVERIFY(course->text().contains("Row"));
        QVERIFY(QFontMetrics(course->font()).height() >= m_window->height() / 20);
        const QPalette colours = child<QWidget>("teachingBoard")->palette();
        const double light = colours.color(QPalette::Window).lightnessF();
        const double ink = colours.color(QPalette::WindowText).lightnessF();
        QVERIFY(std::abs(light - ink) > 0.99);
        press(Qt::Key_F3);
        QVERIFY(m_window->palette().color(QPalette::Window) == lightPalette().color(QPalette::Window));
    }

    void everyWordOfTheGlossaryIsShownByNeedles() {
        press(Qt::Key_F1, Qt::ShiftModifier);
        auto* dialog = m_window->findChild<GlossaryDialog*>();
        QVERIFY(dialog);
        QStringList ids;
        for (const GlossaryEntry& entry : glossary()) {
            ids << entry.id;
            dialog->showWord(entry.id);
            QTRY_VERIFY2(dialog->document().title() == entry.word, qPrintable(entry.id));
            QVERIFY2(!hasErrors(dialog->document().problems()), qPrintable(entry.id));
            QCOMPARE(dialog->document().step(), entry.from);
            QVERIFY2(dialog->document().operationCount() > entry.from, qPrintable(entry.id));
        }
        for (const char* word :
             {"knit", "purl", "tuck", "miss", "split", "transfer", "rack", "drop", "cast-on", "bind-off"}) {
            QVERIFY2(ids.contains(QLatin1String(word)), word);
        }
        dialog->showWord(QStringLiteral("transfer"));
        QTRY_VERIFY(dialog->stage().clock().running() && dialog->stage().clock().phase() > 0.1);
    }

    void keysAreFoundByWhatTheyDo() {
        press(Qt::Key_F1);
        auto* list = m_window->findChild<QTreeWidget*>(QStringLiteral("keyList"));
        QVERIFY(list);
        const auto shown = [list] {
            QStringList found;
            for (QTreeWidgetItemIterator item(list, QTreeWidgetItemIterator::NoChildren); *item; ++item) {
                if (!(*item)->isHidden() && !(*item)->parent()->isHidden()) {
                    found << (*item)->text(0);
                }
            }
            return found;
        };
        const qsizetype all = shown().size();
        QVERIFY(all > 80);
        QTest::keyClicks(child<QLineEdit>("keySearch"), "previous prob");
        QCOMPARE(shown(), QStringList{"Previous problem"});
        child<QLineEdit>("keySearch")->setText("mouse");
        QVERIFY2(shown().contains("Turn the fabric"), "a group is found by its name");
        child<QLineEdit>("keySearch")->clear();
        QCOMPARE(shown().size(), all);
    }

    void operationsSpeakEnglishAndGerman() {
        machine::Program program;
        program.header.carriers.push_back({"3", 0, false, ""});
        machine::Operation op;
        op.kind = machine::OperationKind::Xfer;
        op.needle = {machine::Bed::Front, 5};
        op.target = {machine::Bed::Rear, 5};
        program.operations.push_back(op);
        op.kind = machine::OperationKind::Tuck;
        op.carriers = {0};
        program.operations.push_back(op);
        QCOMPARE(document::operationSentence(program, 0),
                 QStringLiteral("Transfer: the loop on front needle 5 moves to rear needle 5."));
        QCOMPARE(document::operationSentence(program, 1),
                 QStringLiteral("Tuck: front needle 5 takes yarn of carrier 3 and keeps what it holds."));
        applyLanguage(*qApp, QStringLiteral("de"));
        QCOMPARE(document::operationSentence(program, 0),
                 QStringLiteral("Umh\u00e4ngen: Die Schleife von Nadel 5 vorn wandert auf Nadel 5 hinten."));
        QCOMPARE(
            document::operationSentence(program, 1),
            QStringLiteral("Fang: Nadel 5 vorn nimmt Faden von Fadenf\u00fchrer 3 und beh\u00e4lt, was sie "
                           "h\u00e4lt."));
        for (int kind = 0; kind < machine::kOperationKindCount; ++kind) {
            program.operations.front().kind = static_cast<machine::OperationKind>(kind);
            program.operations.front().carriers = {0};
            const QString german = document::operationSentence(program, 0);
            applyLanguage(*qApp, QStringLiteral("en"));
            const QString english = document::operationSentence(program, 0);
            applyLanguage(*qApp, QStringLiteral("de"));
            const bool same = kind == static_cast<int>(machine::OperationKind::Pause) ||
                              kind == static_cast<int>(machine::OperationKind::Extension);
            QVERIFY2(same || german != english, qPrintable(english));
        }
    }

    void theLanguageChangesWithTheDocumentAtHand() {
        openSample("cable-left");
        document().setStep(190);
        QTRY_COMPARE(document().shownStep(), 190);
        QSignalSpy chosen(m_window.get(), &MainWindow::languageChosen);
        child<QAction>("actionLanguage_de")->trigger();
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(document::Session().language(), QStringLiteral("de"));
        applyLanguage(*qApp, QStringLiteral("de"));
        const auto file = document().file();
        auto next = std::make_unique<MainWindow>(m_window->releaseDocument());
        m_window = std::move(next);
        m_window->show();
        QCOMPARE(document().file(), file);
        QCOMPARE(document().step(), 190);
        QCOMPARE(m_window->menuBar()->actions().at(0)->text(), QStringLiteral("&Datei"));
        QVERIFY(child<QLabel>("stepWords")->text().startsWith(QStringLiteral("Umh\u00e4ngen")));
        QTRY_VERIFY(child<FabricView>("fabricView")->isUpToDate());
        document().setStep(191);
        QVERIFY(child<QLabel>("stepWords")->text().startsWith("Versatz"));
        begin(0);
        QCOMPARE(child<QLabel>("lessonTitle")->text(), QStringLiteral("Die leere Maschine"));
    }

    void aRangeBecomesNumberedPictures() {
        openSample("plain");
        markRange(60, 63);
        const QString folder = m_folder.filePath("frames");
        record(folder);
        QCOMPARE(QDir(folder).entryList(QDir::Files),
                 (QStringList{"00001.png", "00002.png", "00003.png", "00004.png"}));
        const QImage first(folder + "/00001.png");
        QCOMPARE(first.width(), m_window->width());
        QVERIFY(first != QImage(folder + "/00004.png"));
        QCOMPARE(document().step(), 63);
    }

    void aRangeBecomesAnAnimation() {
        openSample("plain");
        markRange(60, 62);
        const QString path = m_folder.filePath("moving.webp");
        record(path);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        QVERIFY(bytes.startsWith("RIFF"));
        QCOMPARE(bytes.mid(8, 4), QByteArray("WEBP"));
        QCOMPARE(bytes.count("ANMF"), 3);
    }

    void theStopsOfALessonBecomeAHandout() {
        begin(0);
        const QString path = m_folder.filePath("hand-out.pdf");
        record(path);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        QVERIFY(bytes.startsWith("%PDF"));
        QVERIFY(bytes.contains("/Count 3")); // six stops, two a page
    }

    void aCancelledRecordingLeavesNothing() {
        openSample("plain");
        markRange(60, 300);
        const QStringList before = QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden);
        for (const char* name : {"gone", "gone.webp", "gone.pdf"}) {
            m_window->record(m_folder.filePath(name));
            auto* progress = recording();
            QVERIFY(progress && progress->isVisible());
            QTRY_VERIFY(progress->value() > 0);
            QTest::mouseClick(progress->findChild<QPushButton*>(), Qt::LeftButton);
            QTRY_VERIFY(!recording());
            QCOMPARE(document().step(), 300);
        }
        QCOMPARE(QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden), before);
    }

    void anAnimationThatIsTooLongIsRefused() {
        openSample("plain");
        markRange(0, 2000); // 2001 steps
        child<QAction>("actionRecordAnimation")->trigger();
        QVERIFY(child<Banner>("banner")->text().contains("shorter range"));
    }

    void stepsBehindTheEndAreNotWaitedFor() {
        openSample("plain");
        const int end = document().operationCount();
        child<StepPlayer>("stepPlayer")->marks().setBookmarks({end - 1, end, end + 5});
        const QString folder = m_folder.filePath("ends");
        record(folder);
        QCOMPARE(QDir(folder).entryList(QDir::Files), (QStringList{"00001.png", "00002.png"}));
    }

    void aFolderThatIsThereIsNotTouched() {
        openSample("plain");
        markRange(60, 61);
        const QString folder = m_folder.filePath("mine");
        QVERIFY(QDir().mkpath(folder));
        record(folder);
        QVERIFY(child<Banner>("banner")->text().contains("exists"));
        QVERIFY(QDir(folder).isEmpty());
    }

private:
    LessonPanel& panel() { return *child<LessonPanel>("lessonPanel"); }

    void begin(int lesson) {
        open([&] { panel().begin(lesson); });
        QVERIFY(panel().running());
    }

    void markRange(int from, int to) {
        auto& marks = child<StepPlayer>("stepPlayer")->marks();
        document().setStep(to);
        marks.setLoopFrom(from);
        marks.setLoopTo(to);
    }

    QProgressDialog* recording() { return m_window->findChild<QProgressDialog*>("recordProgress"); }

    void record(const QString& path) {
        m_window->record(path);
        QTRY_VERIFY_WITH_TIMEOUT(!recording(), 60000);
    }
};

} // namespace knittsim::ui

QTEST_MAIN(knittsim::ui::TeachingTest)
#include "teaching_test.moc"
