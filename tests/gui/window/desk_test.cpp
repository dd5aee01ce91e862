// What stands around a chart: columns, symbols, legend, steps, colourways, yarns of one's own.

#ifndef Q_MOC_RUN // moc 6.4 does not read all headers of C++20
#include "core/pattern/samples.h"
#include "core/pattern/swatch.h"
#include "core/yarn/own_yarns.h"
#endif

#include "tests/gui/window/chart_fixture.h"
#include "ui/views/chart_editor/chart_sheet.h"
#include "ui/views/chart_editor/legend_panel.h"
#include "ui/views/pattern_editor/pattern_grid.h"
#include "ui/views/yarn_library/colourway_bar.h"
#include "ui/views/yarn_library/yarn_dialog.h"

#include <QAction>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QUndoView>

namespace knittsim::ui {

using document::Document;
using pattern::Stitch;

class DeskTest : public ChartFixture {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }

    void init() { beginTest(); }

    void cleanup() { endTest(); }

    void columnsWithoutInformationHide() {
        newChart(10, 8);
        QVERIFY(canvas()->isShown(SideColumn::Course));
        QVERIFY(canvas()->isShown(SideColumn::Direction));
        QVERIFY2(!canvas()->isShown(SideColumn::Carrier), "there is one yarn");
        QVERIFY(!canvas()->isShown(SideColumn::StitchSize));
        QVERIFY(!canvas()->isShown(SideColumn::Racking));
        const int narrow = canvas()->geometryOfChart().header.width();
        document().editChart("size", [](pattern::Chart& chart) { chart.course(3).stitchNumber = 5; });
        QVERIFY(canvas()->isShown(SideColumn::StitchSize));
        QVERIFY(canvas()->geometryOfChart().header.width() > narrow);
        document().undoStack()->undo();
        QVERIFY(!canvas()->isShown(SideColumn::StitchSize));
        action("actionColumn3")->trigger(); // by hand: also where it is empty
        QVERIFY(canvas()->isShown(SideColumn::StitchSize));
        action("actionColumnsByContent")->trigger();
        QVERIFY(!canvas()->isShown(SideColumn::StitchSize));
    }

    void theStitchSizeIsTypedIn() {
        newChart(10, 8);
        canvas()->setFocus();
        QTest::keyClick(canvas(), Qt::Key_Up);
        action("actionChartStitchSize")->trigger();
        auto* field = child<QLineEdit>("sideEditor");
        QTest::keyClicks(field, "no number");
        QTest::keyClick(field, Qt::Key_Return);
        QVERIFY(field->isVisible());
        QVERIFY(!field->toolTip().isEmpty());
        field->setText("7.5");
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(chart().course(1).stitchNumber, std::optional(7.5));
        QVERIFY(!chart().course(0).stitchNumber);
        QCOMPARE(document().undoStack()->count(), 1);
    }

    void aCourseGetsAnotherYarn() {
        newChart(10, 8);
        document().editChart("yarn", [](pattern::Chart& chart) {
            chart.yarns.push_back({"2", {9, 9, 9}, ""});
        });
        canvas()->setFocus();
        action("actionChartCourseYarn")->trigger();
        auto* menu = child<QMenu>("courseYarn");
        QCOMPARE(menu->actions().size(), 2);
        menu->actions().at(1)->trigger();
        QCOMPARE(chart().at(9, 0).yarn, std::uint8_t{1});
        QCOMPARE(chart().at(0, 1).yarn, std::uint8_t{0});
        QVERIFY(canvas()->isShown(SideColumn::Carrier));
        menu->close();
    }

    void aProgramTellsItsCourses() {
        open([&] {
            document().openText("text", QString::fromStdString(pattern::sampleText("float-jacquard")));
        });
        auto* grid = child<PatternGrid>("patternGrid");
        QVERIFY(grid->isVisible());
        QVERIFY(grid->isShown(SideColumn::Direction));
        QVERIFY2(grid->isShown(SideColumn::Carrier), "it has two yarns");
    }

    void symbolsAreSwitchedAndRemembered() {
        newChart(10, 8);
        stroke({2, 2}, {6, 2});
        const QImage before = canvas()->grab().toImage();
        QTest::keyClick(m_window.get(), Qt::Key_A);
        QVERIFY(action("actionSymbols1")->isChecked());
        QVERIFY(canvas()->grab().toImage() != before);
        QTest::keyClick(m_window.get(), Qt::Key_A);
        QVERIFY(action("actionSymbols2")->isChecked());
        document().undoStack()->setClean();
        m_window->close();
        m_window = std::make_unique<MainWindow>();
        QVERIFY(action("actionSymbols2")->isChecked());
    }

    void theLegendNamesWhatIsThere() {
        newChart(10, 8);
        child<QDockWidget>("legendDock")->raise();
        auto* legend = child<LegendPanel>("legend");
        QTRY_VERIFY(legend->isVisible());
        QCOMPARE(legend->count(), 2); // knit, and the yarn
        stroke({2, 2}, {6, 2});
        QTRY_COMPARE(legend->count(), 3);
        document().editChart("cable", [](pattern::Chart& chart) {
            chart.course(4).moves = pattern::cross(2, 2, 2, pattern::Front::Right);
        });
        QTRY_COMPARE(legend->count(), 4);
        QVERIFY(legend->item(2)->text().startsWith("Cable"));
    }

    void stepsAreListedAndReached() {
        newChart(10, 8);
        const pattern::Chart start = chart();
        stroke({0, 0}, {5, 0});
        stroke({0, 2}, {5, 2});
        child<QDockWidget>("stepsDock")->raise();
        auto* steps = child<QUndoView>("steps");
        QTRY_VERIFY(steps->isVisible());
        QCOMPARE(steps->model()->rowCount(), 3);
        QTest::mouseClick(steps->viewport(), Qt::LeftButton, {},
                          steps->visualRect(steps->model()->index(0, 0)).center());
        QCOMPARE(chart(), start);
    }

    void colourwaysAreSwitchedUndoneAndSaved() {
        newChart(10, 8);
        auto* bar = child<ColourwayBar>("colourways");
        auto* choice = child<QComboBox>("colourwayChoice");
        QCOMPARE(choice->count(), 1);
        const yarn::Colour first = document().carriers()[0].yarn.colour;
        bar->add("Night");
        document().assignYarn(0, *document().library().find("linen-26"));
        document().setCarrierColour(0, {1, 2, 3});
        QCOMPARE(choice->count(), 2);
        choice->setCurrentIndex(0);
        emit choice->activated(0);
        QCOMPARE(document().carriers()[0].yarn.colour, first);
        QCOMPARE(document().carriers()[0].yarn.id, std::string("merino-2-30"));
        QVERIFY2(document().fabricFollowsChart(), "nothing is knitted anew");
        document().undoStack()->undo();
        QCOMPARE(document().carriers()[0].yarn.colour, (yarn::Colour{1, 2, 3}));
        QCOMPARE(document().carriers()[0].yarn.id, std::string("linen-26"));
        QCOMPARE(choice->currentText(), QString("Night"));
        const QString path = m_folder.filePath("ways.knitt");
        QVERIFY(!hasErrors(document().save(path)));
        open([&] { document().open(path); });
        QCOMPARE(choice->count(), 2);
        QCOMPARE(choice->currentText(), QString("Night"));
        bar->removeUsed();
        QCOMPARE(choice->count(), 1);
        QCOMPARE(document().carriers()[0].yarn.colour, first);
    }

    void badNumbersOfAYarnAreRefusedWithTheReason() {
        YarnDialog dialog(yarn::defaultYarn());
        auto* save = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save);
        QVERIFY(save->isEnabled());
        auto* outer = dialog.findChild<QLineEdit*>("outer_diameter_mm");
        auto* reason = dialog.findChild<QLabel*>("outer_diameter_mm.reason");
        outer->setText("99");
        QVERIFY(!save->isEnabled());
        QVERIFY(reason->text().contains("50"));
        outer->setText("wide");
        QVERIFY(!save->isEnabled());
        outer->setText("0.1"); // below the core
        QVERIFY(!save->isEnabled());
        QVERIFY(!dialog.findChild<QLabel*>("core_diameter_mm.reason")->text().isEmpty());
        QTest::mouseClick(dialog.findChild<QPushButton*>("computeDiameters"), Qt::LeftButton);
        QVERIFY(save->isEnabled());
        // The formula with phi = 0.5, wool 1.31 g/cm3 and Nm 15.
        QCOMPARE(dialog.yarn().outerDiameterMm, 0.36);
        QVERIFY(dialog.yarn().sources.at("outer_diameter_mm").find("formula") == 0);
    }

    void countsAreConverted() {
        YarnDialog dialog(yarn::defaultYarn()); // Nm 15
        auto* count = dialog.findChild<QLineEdit*>("count.tex");
        auto* system = dialog.findChild<QComboBox*>("countSystem");
        QCOMPARE(count->text(), QString("15"));
        system->setCurrentText("den");
        QCOMPARE(count->text(), QString("600"));
        system->setCurrentText("tex");
        QCOMPARE(count->text().toDouble(), 66.667);
        QVERIFY2(dialog.yarn() == yarn::defaultYarn(), "another unit is not another yarn");
        count->setText("100");
        QCOMPARE(dialog.yarn().tex, 100.0);
        QCOMPARE(dialog.yarn().count, std::string("100 tex"));
    }

    void anOwnYarnIsInTheLibrary() {
        newChart(10, 8);
        yarn::Yarn own = yarn::defaultYarn();
        own.name = "My yarn";
        own.id = "my-yarn";
        QVERIFY(!hasErrors(yarn::keepYarn(Document::ownYarnFolder().toStdString(), own)));
        const std::size_t before = document().library().yarns().size();
        document().reloadLibrary();
        QCOMPARE(document().library().yarns().size(), before + 1);
        document().assignYarn(0, *document().library().find("my-yarn"));
        const QString path = m_folder.filePath("own.knitt");
        QVERIFY(!hasErrors(document().save(path)));
        open([&] { document().open(path); });
        QCOMPARE(document().carriers()[0].yarn.name, std::string("My yarn"));
        yarn::forgetYarn(Document::ownYarnFolder().toStdString(), "my-yarn");
    }

    void pagesHoldEveryCellOnce() {
        std::vector<int> seen(53 * 41);
        for (const pattern::CellRange& page : pagesOf(53, 41, 20, 15)) {
            QVERIFY(page.width <= 20 && page.height <= 15);
            for (int c = page.course; c < page.course + page.height; ++c) {
                for (int w = page.wale; w < page.wale + page.width; ++w) {
                    ++seen[static_cast<std::size_t>(c * 53 + w)];
                }
            }
        }
        QVERIFY(std::ranges::all_of(seen, [](int times) { return times == 1; }));
    }

    void aLargeChartHasSeveralPages() {
        ChartSheet sheet{.title = "Large", .chart = pattern::plainChart(120, 150), .yarns = {}};
        sheet.yarns = {{"1", "Merino", Qt::red, 12, 3}};
        const QString path = m_folder.filePath("large.pdf");
        int pages = 0;
        QVERIFY(writeChartPdf(sheet, path, [&](int, int all) {
                    pages = all;
                    return true;
                }).empty());
        QVERIFY(pages > 4);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().startsWith("%PDF"));
        const auto ended =
            writeChartPdf(sheet, m_folder.filePath("none.pdf"), [](int, int) { return false; });
        QCOMPARE(ended.front().id, std::string("KS0009"));
        QVERIFY(!QFile::exists(m_folder.filePath("none.pdf")));
        QVERIFY(chartImage(sheet).width() > 120 * 20);
    }
};

} // namespace knittsim::ui

QTEST_MAIN(knittsim::ui::DeskTest)
#include "desk_test.moc"
