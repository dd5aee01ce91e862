#ifndef Q_MOC_RUN // moc 6.4 does not read all headers of C++20
#include "core/pattern/samples.h"
#include "core/pattern/swatch.h"
#endif

#include "tests/gui/window/chart_fixture.h"
#include "ui/dialogs/picture_dialog.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/window/banner.h"
#include "ui/window/sample_thumbnail.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QInputDialog>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSpinBox>
#include <QTimer>
#include <QToolButton>

namespace knittsim::ui {

using document::Document;
using pattern::Stitch;

class ChartTest : public ChartFixture {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }

    void init() { beginTest(); }

    void cleanup() { endTest(); }

    void aNewChartIsDrawnAndTheFabricFollows() {
        newChart(12, 10);
        QCOMPARE(chart().width, 12);
        const std::size_t operations = operationCount();
        stroke({2, 3}, {6, 3});
        for (int wale = 2; wale <= 6; ++wale) {
            QCOMPARE(chart().at(wale, 3).stitch, Stitch::Purl);
        }
        QCOMPARE(chart().at(7, 3).stitch, Stitch::Knit);
        QTRY_VERIFY(document().fabricFollowsChart());
        QVERIFY(operationCount() > operations); // loops change beds now
        QTRY_VERIFY(child<FabricView>("fabricView")->measurement());
        QVERIFY(m_window->isWindowModified());
        document().undoStack()->undo();
        QCOMPARE(chart(), original());
        QTRY_VERIFY(document().fabricFollowsChart());
        QCOMPARE(operationCount(), operations);
        QVERIFY(!m_window->isWindowModified());
        document().undoStack()->redo();
        QCOMPARE(chart().at(4, 3).stitch, Stitch::Purl);
    }

    void machineDataBecomesAChartAndUndoBringsItBack() {
        const QString pause =
            QStringLiteral(";!knitout-2\n;;Carriers: 1 2 3\ninhook 1\nknit - f3 1\nknit - f2 1\nknit - f1 1\n"
                           "releasehook 1\npause look\nknit + f1 1\nknit + f2 1\nknit + f3 1\n"
                           "knit - f3 1\nknit - f2 1\nknit - f1 1\nouthook 1\n");
        document().openText(QStringLiteral("outside.k"), pause);
        QTRY_VERIFY(document().file());
        QVERIFY(!document().project());
        auto* lift = child<QAction>("actionEditAsChart");
        QVERIFY(lift->isEnabled());
        const std::size_t operations = operationCount();
        lift->trigger();
        QTRY_VERIFY(document().project());
        QCOMPARE(chart().height(), 3);
        QVERIFY(document().fabricFollowsChart());
        QCOMPARE(operationCount(), operations + 1);    // the colour of the yarn is said
        QVERIFY(chart().course(1).program != nullptr); // the pause
        QVERIFY(child<Banner>("banner")->text().contains(QStringLiteral("1 of 3 courses")));
        QVERIFY(child<Banner>("banner")->isVisible());
        QVERIFY(!lift->isEnabled());
        document().editChart(QStringLiteral("purl"),
                             [](pattern::Chart& edited) { edited.at(1, 1).stitch = Stitch::Purl; });
        QTRY_VERIFY(document().fabricFollowsChart());
        QVERIFY(operationCount() > operations + 1); // a loop changes beds and comes back
        document().undoStack()->undo();
        document().undoStack()->undo();
        QVERIFY(!document().project());
        QVERIFY2(!child<Banner>("banner")->isVisible(), "it says that this is a chart");
        QCOMPARE(operationCount(), operations);
        QVERIFY(lift->isEnabled());
        document().undoStack()->redo();
        document().undoStack()->redo();
        QCOMPARE(chart().at(1, 1).stitch, Stitch::Purl);
        QTRY_VERIFY(document().fabricFollowsChart());
    }

    void aPictureBecomesAChartInProportion() {
        QImage image(300, 300, QImage::Format_RGB32);
        image.fill(Qt::white);
        for (int y = 0; y < 100; ++y) {
            for (int x = 0; x < 300; ++x) {
                image.setPixel(x, y, qRgb(180, 20, 40)); // the upper third
            }
        }
        const QString path = m_folder.filePath(QStringLiteral("flag.png"));
        QVERIFY(image.save(path));
        PictureDialog dialog(path, {}, {"1", "2", "3"});
        dialog.show();
        auto* make = dialog.findChild<QPushButton*>(QStringLiteral("pictureMake"));
        QTRY_VERIFY(make->isEnabled());
        dialog.findChild<QSpinBox*>(QStringLiteral("pictureWales"))->setValue(30);
        QVERIFY(!make->isEnabled()); // until it is worked out
        QTRY_VERIFY(make->isEnabled());
        QCOMPARE(dialog.findChild<QSpinBox*>(QStringLiteral("pictureCourses"))->value(), 40); // 60 to 80
        QTest::keyClick(dialog.findChild<QSpinBox*>(QStringLiteral("pictureWales")), Qt::Key_Return);
        QCOMPARE(dialog.result(), int(QDialog::Accepted));
        const pattern::Chart chart = dialog.chart();
        QCOMPARE(chart.width, 30);
        QCOMPARE(chart.height(), 40);
        QCOMPARE(chart.yarns.size(), std::size_t{2});
        QCOMPARE(chart.yarns[1].colour, (yarn::Colour{180, 20, 40}));
        QCOMPARE(int(chart.at(5, 0).yarn), 0);
        QCOMPARE(int(chart.at(5, 39).yarn), 1);
    }

    void aSelectionIsSavedAsAModuleAndStandsInTheCatalogue() {
        qputenv("KNITTSIM_MODULES", m_folder.filePath(QStringLiteral("modules")).toUtf8());
        newChart(12, 10);
        stroke({1, 2}, {3, 2});
        child<QAction>("actionChartAll")->trigger();
        QTimer::singleShot(0, this, [] {
            auto* dialog = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
            dialog->setTextValue(QStringLiteral("Three purls"));
            dialog->accept();
        });
        child<QAction>("actionChartSaveModule")->trigger();
        auto* catalogue = m_window->findChild<QMenu*>(QStringLiteral("catalogue"));
        child<QAction>("actionChartStamp")->trigger();
        auto* list = catalogue->findChild<QListWidget*>(QStringLiteral("catalogueList"));
        QTRY_VERIFY(!list->findItems(QStringLiteral("Three purls"), Qt::MatchExactly).isEmpty());
        QListWidgetItem* item = list->findItems(QStringLiteral("Three purls"), Qt::MatchExactly).front();
        document().undoStack()->undo();
        QCOMPARE(chart().at(2, 2).stitch, Stitch::Knit);
        emit list->itemClicked(item);
        stroke({0, 0}, {0, 0});
        QCOMPARE(chart().at(2, 2).stitch, Stitch::Purl);
        qunsetenv("KNITTSIM_MODULES");
    }

    void aFileThatIsNoPictureIsRefusedInWords() {
        PictureDialog dialog(write("broken.png", "no picture"), {}, {"1", "2"});
        auto* words = dialog.findChild<QLabel*>(QStringLiteral("pictureWords"));
        QTRY_VERIFY(words->text().contains(QStringLiteral("cannot be read")));
        QVERIFY(!dialog.findChild<QPushButton*>(QStringLiteral("pictureMake"))->isEnabled());
    }

    void oneStrokeIsOneStepBack() {
        newChart(12, 10);
        stroke({0, 0}, {11, 9});
        stroke({0, 9}, {11, 0});
        QCOMPARE(document().undoStack()->count(), 2);
        QCOMPARE(document().undoStack()->undoText(), QString("pencil"));
    }

    void toolsHaveKeys() {
        newChart(12, 10);
        QTest::keyClick(m_window.get(), Qt::Key_U);
        QCOMPARE(canvas()->tool(), ChartTool::Rectangle);
        stroke({2, 2}, {5, 6});
        int purls = 0;
        for (const pattern::Cell& cell : chart().cells) {
            purls += cell.stitch == Stitch::Purl ? 1 : 0;
        }
        QCOMPARE(purls, 20);
        QTest::keyClick(m_window.get(), Qt::Key_K);
        QTest::mouseClick(child<QToolButton>("stitch3"), Qt::LeftButton); // tuck
        QTest::mouseClick(canvas()->viewport(), Qt::LeftButton, {}, place({3, 3}));
        QCOMPARE(chart().at(5, 6).stitch, Stitch::Tuck);
        QCOMPARE(chart().at(0, 0).stitch, Stitch::Knit);
    }

    void theKeyboardAloneIsEnough() {
        newChart(12, 10);
        canvas()->setFocus();
        QTest::keyClick(canvas(), Qt::Key_Right);
        QTest::keyClick(canvas(), Qt::Key_Up);
        QTest::keyClick(canvas(), Qt::Key_Return);
        QCOMPARE(chart().at(1, 1).stitch, Stitch::Purl);
        QTest::keyClick(canvas(), Qt::Key_Right, Qt::ShiftModifier);
        QTest::keyClick(canvas(), Qt::Key_Up, Qt::ShiftModifier);
        QCOMPARE(canvas()->selection(), (pattern::CellRange{1, 1, 2, 2}));
        QVERIFY(canvas()->accessibleDescription().contains("Needle 3, course 3"));
    }

    void copiesMirrorsAndRepeats() {
        newChart(8, 8);
        stroke({0, 0}, {0, 0});
        canvas()->select({0, 0, 2, 2});
        action("actionChartCopy")->trigger();
        QVERIFY(QGuiApplication::clipboard()->text().contains("\"knitt\""));
        canvas()->select({4, 4, 1, 1});
        action("actionChartPaste")->trigger();
        QCOMPARE(chart().at(4, 4).stitch, Stitch::Purl);
        QCOMPARE(canvas()->selection(), (pattern::CellRange{4, 4, 2, 2}));
        action("actionChartMirror")->trigger();
        QCOMPARE(chart().at(5, 4).stitch, Stitch::Purl);
        QCOMPARE(chart().at(4, 4).stitch, Stitch::Knit);
        canvas()->select({0, 0, 2, 2});
        action("actionChartRepeat")->trigger();
        for (int course = 0; course < 8; ++course) {
            for (int wale = 0; wale < 8; ++wale) {
                QCOMPARE(chart().at(wale, course).stitch == Stitch::Purl, wale % 2 == 0 && course % 2 == 0);
            }
        }
    }

    void theCatalogueStampsACable() {
        newChart(12, 10);
        child<QMenu>("catalogue")->popup(QPoint(10, 10));
        auto* list = child<QListWidget>("catalogueList");
        QTRY_VERIFY(list->count() >= 30);
        for (int i = 0; i < list->count(); ++i) {
            if (list->item(i)->data(Qt::UserRole) == "cable-2x2-left") {
                QTest::mouseClick(
                    list->viewport(), Qt::LeftButton, {},
                    (list->scrollToItem(list->item(i)), list->visualItemRect(list->item(i)).center()));
                break;
            }
        }
        QCOMPARE(canvas()->tool(), ChartTool::Stamp);
        QTest::mouseClick(canvas()->viewport(), Qt::LeftButton, {}, place({4, 3}));
        QCOMPARE(chart().course(4).moves.size(), std::size_t{4});
        QTRY_VERIFY(document().fabricFollowsChart());
        QVERIFY(!document().shownFabric()->crossings.empty());
    }

    void aChartThatCannotBeKnittedSaysSoAndKeepsTheFabric() {
        newChart(6, 6);
        const auto before = document().shownFabric();
        document().editChart("hole", [](pattern::Chart& chart) { chart.at(2, 3).stitch = Stitch::Empty; });
        QTRY_VERIFY(!document().isRebuilding());
        QVERIFY(!document().fabricFollowsChart());
        QCOMPARE(document().shownFabric(), before);
        QVERIFY(child<QLabel>("chartHint")->text().contains("Wale 2"));
        document().undoStack()->undo();
        QTRY_VERIFY(document().fabricFollowsChart());
        QVERIFY(child<QLabel>("chartHint")->text().isEmpty());
    }

    void aClickShowsTheStitchInTheFabricAndBack() {
        newChart(10, 10);
        canvas()->setTool(ChartTool::Select);
        QTest::mouseClick(canvas()->viewport(), Qt::LeftButton, {}, place({4, 5}));
        const auto loop = document().selection().loop;
        QVERIFY(loop >= 0);
        const machine::Loop& made =
            document().file()->timeline->loops().loops[static_cast<std::size_t>(loop)];
        QCOMPARE(made.needle.index, 5);
        QCOMPARE(document().cellOfLoop(loop)->course, 5);
        QCOMPARE(document().cellOfLoop(loop)->wale, 4);
    }

    void whatIsSavedOpensAgain() {
        newChart(9, 7);
        stroke({1, 1}, {7, 5});
        const pattern::Chart drawn = chart();
        const QString path = m_folder.filePath("mine.knitt");
        QVERIFY(!hasErrors(document().save(path)));
        QVERIFY(!m_window->isWindowModified());
        QVERIFY(m_window->windowTitle().startsWith("mine.knitt"));
        document().undoStack()->undo();
        QVERIFY(m_window->isWindowModified());
        document().undoStack()->redo();
        QVERIFY(!m_window->isWindowModified());
        open([&] { m_window->openFile(path); });
        QCOMPARE(chart(), drawn);
        QVERIFY(hasErrors(document().save("/no/such/folder/mine.knitt")));
    }

    void aYarnGivenToACarrierIsKept() {
        newChart(9, 7);
        const auto* yarn = document().library().find("linen-26");
        QVERIFY(yarn);
        document().assignYarn(0, *yarn);
        document().setCarrierColour(0, {1, 2, 3});
        QCOMPARE(chart().yarns[0].libraryId, std::string("linen-26"));
        QVERIFY2(document().fabricFollowsChart(), "nothing else changed");
        const QString path = m_folder.filePath("linen.knitt");
        QVERIFY(!hasErrors(document().save(path)));
        open([&] { m_window->openFile(path); });
        QCOMPARE(document().carriers()[0].yarn.id, std::string("linen-26"));
        QCOMPARE(document().carriers()[0].yarn.colour, (yarn::Colour{1, 2, 3}));
    }

    void escapeEndsAStroke() {
        newChart(9, 7);
        QTest::mousePress(canvas()->viewport(), Qt::LeftButton, {}, place({1, 1}));
        QTest::mouseMove(canvas()->viewport(), place({5, 5}));
        QTest::keyClick(canvas(), Qt::Key_Escape);
        QTest::mouseRelease(canvas()->viewport(), Qt::LeftButton, {}, place({5, 5}));
        QCOMPARE(document().undoStack()->count(), 0);
        canvas()->select({1, 1, 3, 3});
        QTest::keyClick(canvas(), Qt::Key_Escape);
        QVERIFY(canvas()->selection().empty());
    }

    void aChartThatCannotBeKnittedOpensAllTheSame() {
        pattern::Project project{.chart = pattern::plainChart(6, 6), .machine = {}};
        project.chart.at(3, 3).stitch = Stitch::Both; // on one bed
        const QString path = write("both.knitt", QByteArray::fromStdString(pattern::writeProject(project)));
        open([&] { m_window->openFile(path); });
        QVERIFY(!document().fabricFollowsChart());
        QVERIFY(!document().problems().empty());
        document().editChart("mend", [](pattern::Chart& chart) { chart.at(3, 3).stitch = Stitch::Knit; });
        QTRY_VERIFY(document().fabricFollowsChart());
    }

    void aSampleIsAChartOfItsOwn() {
        openSample("cable-left");
        QCOMPARE(chart(), pattern::sampleChart("cable-left"));
        QVERIFY(canvas()->isVisible());
        open([&] { document().openText("text", QString::fromStdString(pattern::sampleText("plain"))); });
        QVERIFY(!document().project());
        QVERIFY(!canvas()->isVisible());
        QVERIFY(!action("actionChartCut")->isEnabled());
    }

    void leavingAskedForUnsavedChanges() {
        newChart(6, 6);
        stroke({1, 1}, {2, 2});
        int asked = 0;
        const auto answer = [&](QMessageBox::StandardButton button) {
            QTimer::singleShot(200, this, [&asked, button] {
                auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
                QVERIFY(box);
                ++asked;
                box->button(button)->click();
            });
        };
        answer(QMessageBox::Cancel);
        m_window->openSample("plain");
        QCOMPARE(asked, 1);
        QVERIFY(!document().isOpening());
        QCOMPARE(chart().width, 6);
        answer(QMessageBox::Discard);
        openSample("plain");
        QCOMPARE(asked, 2);
        QVERIFY(chart().width != 6);
    }

    void whatACrashLeavesBehindIsOffered() {
        newChart(9, 7);
        stroke({1, 1}, {7, 5});
        const pattern::Chart drawn = chart();
        const QDir folder(document::Recovery::folder());
        QTRY_COMPARE_WITH_TIMEOUT(folder.entryList({"*.knitt"}, QDir::Files).size(), 1, 10000);
        QVERIFY2(document::Recovery::leftovers().empty(), "the window lives");
        const QString copy = folder.filePath(folder.entryList({"*.knitt"}, QDir::Files).front());
        QVERIFY(QFile::copy(copy, m_folder.filePath("kept.knitt")));
        cleanup();
        QVERIFY2(folder.entryList({"*.knitt"}, QDir::Files).isEmpty(), "left in peace");
        QVERIFY(QFile::copy(m_folder.filePath("kept.knitt"), copy)); // as if it had died

        init();
        QVERIFY(child<Banner>("banner")->text().contains("new"));
        open([&] { child<QPushButton>("bannerAction")->click(); });
        QCOMPARE(chart(), drawn);
        QVERIFY(m_window->isWindowModified());
        cleanup();

        QVERIFY(QFile::copy(m_folder.filePath("kept.knitt"), copy));
        init();
        QVERIFY(child<Banner>("banner")->isVisible());
        child<QPushButton>("bannerOther")->click();
        QVERIFY2(folder.entryList({"*.knitt"}, QDir::Files).isEmpty(), "declined");
        QVERIFY(!child<Banner>("banner")->isVisible());
    }

    void aChangeFromOutsideIsNoticed() {
        newChart(6, 6);
        const QString path = m_folder.filePath("shared.knitt");
        QVERIFY(!hasErrors(document().save(path)));
        QTest::qWait(600);
        QVERIFY2(!child<Banner>("banner")->isVisible(), "it was saved here");
        pattern::Project other{.chart = pattern::plainChart(4, 4), .machine = {}};
        write("shared.knitt", QByteArray::fromStdString(pattern::writeProject(other)));
        QTRY_VERIFY(child<Banner>("banner")->isVisible());
        QCOMPARE(chart().width, 6);
        open([&] { child<QPushButton>("bannerAction")->click(); });
        QCOMPARE(chart(), other.chart);
        // Work that is not saved stays, when the person says so.
        document().editChart("mine", [](pattern::Chart& chart) { chart.at(1, 1).stitch = Stitch::Purl; });
        write("shared.knitt", QByteArray::fromStdString(pattern::writeProject(project(9))));
        QTRY_VERIFY(child<Banner>("banner")->isVisible());
        child<QPushButton>("bannerOther")->click();
        QCOMPARE(chart().at(1, 1).stitch, Stitch::Purl);
        QVERIFY(m_window->isWindowModified());
    }

    void anotherWindowWithTheDocumentKnowsOfForeignChanges() {
        newChart(6, 6);
        const QString path = m_folder.filePath("handed.knitt");
        QVERIFY(!hasErrors(document().save(path)));
        const auto writeOther = [&](int wales) {
            write("handed.knitt", QByteArray::fromStdString(pattern::writeProject(project(wales))));
        };
        const auto isTold = [&] { return child<Banner>("banner")->text().contains("handed.knitt"); };
        adoptWindow();
        QVERIFY(!isTold());
        writeOther(9);
        QTRY_VERIFY2(isTold(), "it came after the other window");
        adoptWindow();
        QVERIFY2(isTold(), "it came before the other window");
        open([&] { child<QPushButton>("bannerAction")->click(); });
        QCOMPARE(chart().width, 9);
        QVERIFY(!child<Banner>("banner")->isVisible());
    }

    void viewsBelongToTheFile() {
        const auto hasView = [&] { return m_window->findChild<QAction*>("actionView_Edge") != nullptr; };
        newChart(6, 6);
        child<QAction>("actionSaveView")->trigger();
        auto* dialog = child<QInputDialog>("saveViewDialog");
        dialog->setTextValue("Edge");
        dialog->accept();
        QVERIFY(hasView());
        newChart(6, 6);
        QVERIFY2(!hasView(), "another chart of the same title");
        child<QAction>("actionSaveView")->trigger();
        dialog = child<QInputDialog>("saveViewDialog");
        dialog->setTextValue("Edge");
        dialog->accept();
        const QString path = m_folder.filePath("views.knitt");
        QVERIFY(!hasErrors(document().save(path)));
        QVERIFY(hasView());
        newChart(6, 6);
        QVERIFY(!hasView());
        open([&] { m_window->openFile(path); });
        QVERIFY(hasView());
        adoptWindow();
        QVERIFY(hasView());
    }

    void aThumbnailIsInTheFile() {
        newChart(12, 10);
        const QString path = m_folder.filePath("picture.knitt");
        const QByteArray picture = chartThumbnail(chart());
        QVERIFY(!hasErrors(document().save(path, {.thumbnail = picture.toStdString()})));
        QCOMPARE(pattern::readLook(path.toStdString()).thumbnail, picture.toStdString());
        QVERIFY(!thumbnailOf(path).isNull());
        QVERIFY(thumbnailOf(m_folder.filePath("no.knitt")).isNull());
    }

    void aLargeChartIsEditedWithoutWaiting() {
        auto project = std::make_shared<pattern::Project>();
        project->chart = pattern::plainChart(500, 500);
        open([&] { document().openProject("large", project); });
        canvas()->setTool(ChartTool::Pencil);
        stroke({10, 400}, {40, 420});
        document().undoStack()->undo();
        QCOMPARE(chart(), project->chart);
    }

private:
    pattern::Chart original() {
        pattern::Chart plain(12, 10);
        plain.yarns = chart().yarns;
        return plain;
    }
    std::size_t operationCount() { return static_cast<std::size_t>(document().operationCount()); }

    static pattern::Project project(int wales) {
        return {.chart = pattern::plainChart(wales, 4), .machine = {}};
    }
};

} // namespace knittsim::ui

QTEST_MAIN(knittsim::ui::ChartTest)
#include "chart_test.moc"
