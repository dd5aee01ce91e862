// A designer at work: keys and drags of the chart, what is out of date, the kept shape, own yarns.

#ifndef Q_MOC_RUN // moc 6.4 does not read all headers of C++20
#include "core/pattern/project.h"
#include "core/yarn/own_yarns.h"
#endif

#include "tests/gui/window/chart_fixture.h"
#include "ui/views/chart_editor/new_chart_dialog.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/views/yarn_library/colourway_bar.h"
#include "ui/views/yarn_library/yarn_dialog.h"
#include "ui/views/yarn_library/yarn_model.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QListWidget>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QSpinBox>
#include <QTextBrowser>
#include <QToolButton>
#include <QUndoStack>

namespace knittsim::ui {

using document::Document;
using pattern::CellRange;
using pattern::Stitch;

class DesignerTest : public ChartFixture {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }
    void init() { beginTest(); }
    void cleanup() {
        QDir(Document::ownYarnFolder()).removeRecursively();
        endTest();
    }

    void aNewChartHasAsManyYarnsAsAskedFor() {
        NewChartDialog dialog({});
        dialog.findChild<QSpinBox*>("newYarns")->setValue(2);
        const auto project = std::make_shared<pattern::Project>(dialog.project());
        QCOMPARE(project->chart.yarns.size(), std::size_t{2});
        QVERIFY(project->chart.yarns[0].colour != project->chart.yarns[1].colour);
        open([&] { document().openProject("new", project); });
        QCOMPARE(child<QListView>("carrierList")->model()->rowCount(), 2); // also the one not yet drawn with
    }

    void aYarnColoursStitchesAndAStitchKeepsTheirColours() {
        twoYarns(12, 10);
        QVERIFY2(canvas()->isShown(SideColumn::Carrier), "not only when it is drawn with");
        QTest::mouseClick(child<QToolButton>("yarn1"), Qt::LeftButton);
        QVERIFY(child<QLabel>("chartToolHint")->text().contains("carrier 2"));
        stroke({2, 3}, {6, 3});
        QCOMPARE(chart().at(4, 3), (pattern::Cell{Stitch::Knit, 1}));
        QTest::mouseClick(child<QToolButton>("stitch1"), Qt::LeftButton); // purl
        stroke({4, 3}, {8, 3});
        QCOMPARE(chart().at(4, 3), (pattern::Cell{Stitch::Purl, 1}));
        QCOMPARE(chart().at(8, 3), (pattern::Cell{Stitch::Purl, 0}));
    }

    void whatIsChosenTwiceStaysChosen() {
        newChart(6, 6);
        QTest::mouseClick(child<QToolButton>("stitch1"), Qt::LeftButton);
        QTest::mouseClick(child<QToolButton>("stitch1"), Qt::LeftButton);
        QVERIFY(canvas()->brush().stitch);
    }

    void anEdgeThatIsDraggedRepeatsTheSelection() {
        newChart(12, 10);
        stroke({4, 4}, {4, 4});
        canvas()->setTool(ChartTool::Select);
        canvas()->select({4, 4, 2, 2});
        const QRect first = canvas()->geometryOfChart().cellRect(4, 4);
        const QPoint left(first.left(), first.center().y());
        dragTo(left, place({0, 4}));
        for (int wale = 0; wale < 12; ++wale) {
            QCOMPARE(chart().at(wale, 4).stitch == Stitch::Purl, wale <= 4 && wale % 2 == 0);
        }
        QCOMPARE(canvas()->selection(), (CellRange{0, 4, 6, 2}));
        QCOMPARE(document().undoStack()->count(), 2);
    }

    void arrowsShiftMoveAndRepeat() {
        newChart(12, 10);
        stroke({4, 4}, {4, 4});
        canvas()->setTool(ChartTool::Select);
        canvas()->setFocus();
        canvas()->select({4, 4, 2, 1});
        for (int i = 0; i < 4; ++i) { // the period stays two
            QTest::keyClick(canvas(), Qt::Key_Right, Qt::ControlModifier | Qt::ShiftModifier);
        }
        for (int wale = 0; wale < 12; ++wale) {
            QCOMPARE(chart().at(wale, 4).stitch == Stitch::Purl, wale == 4 || wale == 6 || wale == 8);
        }
        QTest::keyClick(canvas(), Qt::Key_Up, Qt::AltModifier);
        QCOMPARE(canvas()->selection(), (CellRange{4, 5, 6, 1}));
        QCOMPARE(chart().at(4, 4).stitch, Stitch::Knit);
        QCOMPARE(chart().at(8, 5).stitch, Stitch::Purl);
        QTest::keyClick(canvas(), Qt::Key_Left, Qt::ControlModifier);
        QCOMPARE(chart().at(9, 5).stitch, Stitch::Purl); // from the left end
        QCOMPARE(chart().at(5, 5).stitch, Stitch::Purl);
        QCOMPARE(chart().at(4, 5).stitch, Stitch::Knit);
    }

    void stitchAndYarnAreChosenAndPickedByKeys() {
        twoYarns(8, 8);
        document().editChart("tuck", [](pattern::Chart& chart) { chart.at(2, 2) = {Stitch::Tuck, 1}; });
        canvas()->setFocus();
        press(Qt::Key_E);
        QCOMPARE(canvas()->brush().stitch, std::optional(Stitch::Tuck)); // after purl
        press(Qt::Key_E, Qt::ShiftModifier);
        QCOMPARE(canvas()->brush().stitch, std::optional(Stitch::Purl));
        press(Qt::Key_O);
        QCOMPARE(canvas()->brush().yarn, std::optional(std::uint8_t{0}));
        QVERIFY(!canvas()->brush().stitch);
        for (int i = 0; i < 2; ++i) {
            QTest::keyClick(canvas(), Qt::Key_Right);
            QTest::keyClick(canvas(), Qt::Key_Up);
        }
        press(Qt::Key_Q);
        QCOMPARE(canvas()->brush().stitch, std::optional(Stitch::Tuck));
        QCOMPARE(canvas()->brush().yarn, std::optional(std::uint8_t{1}));
    }

    /// Choices of a menu are reached by its letters, what is done while drawing by a key of its own.
    void allThatIsDoneToAChartHasAKey() {
        for (const QAction* one : child<QMenu>("patternMenu")->actions()) {
            if (one->isSeparator()) {
                continue;
            }
            QVERIFY2(one->menu() || !one->shortcut().isEmpty(), qPrintable(one->text()));
        }
        for (const QMenu* menu : child<QMenu>("patternMenu")->findChildren<QMenu*>()) {
            QVERIFY2(menu->title().contains(u'&'), qPrintable(menu->title()));
        }
        for (const auto* button : child<QWidget>("chartEditor")->findChildren<QToolButton*>()) {
            QVERIFY2(button->defaultAction() || button->focusPolicy() & Qt::TabFocus ||
                         button->objectName() == "qt_toolbar_ext_button",
                     qPrintable(button->objectName()));
        }
    }

    void theCatalogueIsSearchedAndNoNameIsCutOff() {
        newChart(12, 10);
        action("actionChartStamp")->trigger();
        auto* list = child<QListWidget>("catalogueList");
        auto* search = child<QLineEdit>("catalogueSearch");
        QTRY_VERIFY(search->hasFocus());
        const QSize grid = list->gridSize();
        for (int i = 0; i < list->count(); ++i) {
            const QRect text =
                list->fontMetrics().boundingRect(QRect(0, 0, grid.width() - 10, 1000),
                                                 Qt::TextWordWrap | Qt::AlignHCenter, list->item(i)->text());
            QVERIFY2(text.height() + list->iconSize().height() + 8 <= grid.height(),
                     qPrintable(list->item(i)->text()));
        }
        QTest::keyClicks(search, "cable 2x2");
        int shown = 0;
        for (int i = 0; i < list->count(); ++i) {
            shown += list->item(i)->isHidden() ? 0 : 1;
        }
        QCOMPARE(shown, 2);
        QTest::keyClick(search, Qt::Key_Return);
        QCOMPARE(canvas()->tool(), ChartTool::Stamp);
        QVERIFY(child<QLabel>("chartToolHint")->text().startsWith("Cable 2x2, left"));
        QTest::mouseMove(canvas()->viewport(), place({4, 3}));
        QVERIFY(child<QLabel>("chartToolHint")->text().startsWith("Cable 2x2, left"));
    }

    void theNextColourwayComesByKey() {
        newChart(8, 8);
        auto* choice = child<QComboBox>("colourwayChoice");
        child<ColourwayBar>("colourways")->add("Night");
        QCOMPARE(choice->currentIndex(), 1);
        press(Qt::Key_W, Qt::ControlModifier | Qt::AltModifier);
        QCOMPARE(choice->currentIndex(), 0);
    }

    void yarnThatIsOutOfDateSaysSoUntilItFollows() {
        newChart(6, 6);
        settle();
        document().settleYarn();
        QTRY_VERIFY_WITH_TIMEOUT(document().yarnRun().shape() && !document().yarnRun().running(), 60000);
        QVERIFY(document().showsYarn());
        const auto words = [this] { return fabric()->words().join(u' '); };
        QVERIFY(!words().contains("preview"));
        stroke({2, 2}, {3, 2});
        QVERIFY2(words().contains("out of date"), qPrintable(words()));
        QTRY_VERIFY(document().fabricFollowsChart());
        QVERIFY(!words().contains("out of date"));
        QVERIFY2(words().contains("preview"), "the bonding points, not the yarn");
        QTRY_VERIFY_WITH_TIMEOUT(document().showsYarn(), 60000);
        QTRY_VERIFY(!words().contains("preview"));
    }

    void aShapeThatWasKeptLiesThereAtOnce() {
        newChart(8, 8);
        stroke({1, 1}, {5, 5});
        QTRY_VERIFY(document().fabricFollowsChart());
        settle();
        const std::vector<float> rest = document().shapeAtRest();
        QVERIFY(!rest.empty());
        action("actionSaveShape")->setChecked(true);
        const QString path = m_folder.filePath("kept.knitt");
        QVERIFY(!hasErrors(document().save(path)));
        action("actionSave")->trigger();
        open([&] { document().open(path); });
        QTRY_VERIFY(document().frame());
        const auto frame = document().frame();
        QCOMPARE(frame->positions.size(), rest.size());
        for (std::size_t i = 0; i < rest.size(); ++i) {
            QVERIFY(std::abs(frame->positions[i] - rest[i]) < 0.01F);
        }
        action("actionSaveShape")->setChecked(false);
        action("actionSave")->trigger();
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(!file.readAll().contains("shape"));
    }

    void aYarnIsDroppedOnACarrier() {
        newChart(8, 8);
        auto* carriers = child<QListView>("carrierList");
        auto* yarns = child<QListView>("yarnList");
        child<QLineEdit>("yarnSearch")->setText("linen");
        QVERIFY(yarns->model()->rowCount() > 0);
        const QModelIndex linen = yarns->model()->index(0, 0);
        const std::unique_ptr<QMimeData> dragged(yarns->model()->mimeData({linen}));
        const QPoint at = carriers->visualRect(carriers->model()->index(0, 0)).center();
        QDragEnterEvent enter(at, Qt::CopyAction, dragged.get(), Qt::LeftButton, {});
        QDragMoveEvent move(at, Qt::CopyAction, dragged.get(), Qt::LeftButton, {});
        QDropEvent drop(at, Qt::CopyAction, dragged.get(), Qt::LeftButton, {});
        for (QEvent* event :
             {static_cast<QEvent*>(&enter), static_cast<QEvent*>(&move), static_cast<QEvent*>(&drop)}) {
            QApplication::sendEvent(carriers->viewport(), event);
        }
        QCOMPARE(QString::fromStdString(document().carriers()[0].yarn.id), linen.data(IdRole).toString());
    }

    void searchAndFilterFindYarns() {
        auto* list = child<QListView>("yarnList");
        auto* search = child<QLineEdit>("yarnSearch");
        auto* filter = child<QComboBox>("yarnFilter");
        const int all = list->model()->rowCount();
        QVERIFY(all >= 20);
        QTest::keyClicks(search, "nm 2/30");
        QVERIFY(list->model()->rowCount() > 0 && list->model()->rowCount() < all);
        search->clear();
        filter->setCurrentIndex(filter->findText("cotton"));
        emit filter->activated(filter->currentIndex());
        const int cottons = list->model()->rowCount();
        QVERIFY(cottons > 0 && cottons < all);
        for (int i = 0; i < cottons; ++i) {
            QVERIFY(list->model()->index(i, 0).data(DetailRole).toString().contains("cotton"));
        }
    }

    void everyNumberOfAYarnNamesItsSourceAndAllCounts() {
        auto* list = child<QListView>("yarnList");
        auto* details = child<QTextBrowser>("yarnDetails");
        for (int i = 0; i < list->model()->rowCount(); ++i) {
            list->setCurrentIndex(list->model()->index(i, 0));
            const QString text = details->toPlainText();
            for (const char* unit : {" tex", " dtex", " den", "Nm ", "Ne "}) {
                QVERIFY2(text.contains(unit), unit);
            }
            QVERIFY2(!text.contains("source not given"), qPrintable(text));
        }
    }

    void anOwnYarnIsTypedInChangedAndDeleted() {
        newChart(8, 8);
        auto* list = child<QListView>("yarnList");
        child<QMenu>("ownYarnMenu")->actions().front()->trigger();
        auto* dialog = m_window->findChild<YarnDialog*>();
        QVERIFY(dialog);
        auto* name = dialog->findChild<QLineEdit*>("name");
        name->selectAll();
        QTest::keyClicks(name, "Tweed of mine");
        auto* friction = dialog->findChild<QLineEdit*>("friction");
        friction->selectAll();
        QTest::keyClicks(friction, "9");
        auto* save = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save);
        QVERIFY(!save->isEnabled());
        QVERIFY(dialog->findChild<QLabel*>("friction.reason")->text().contains("2"));
        friction->selectAll();
        QTest::keyClicks(friction, "0.3");
        QTest::mouseClick(save, Qt::LeftButton);
        const yarn::Yarn* made = document().library().find("tweed-of-mine");
        QVERIFY(made);
        QCOMPARE(made->friction, 0.3);
        QCOMPARE(made->sources.at("friction"), std::string("entered by hand"));
        QCOMPARE(list->currentIndex().data(TitleRole).toString(), QString("Tweed of mine"));
        QTest::keyClick(list, Qt::Key_Return); // onto the carrier
        QCOMPARE(document().carriers()[0].yarn.id, std::string("tweed-of-mine"));
        const QString library = m_folder.filePath("yarns.json");
        write("yarns.json", QByteArray::fromStdString(yarn::toJson(std::vector{*made})));
        const auto folder = Document::ownYarnFolder().toStdString();
        yarn::forgetYarn(folder, "tweed-of-mine");
        document().reloadLibrary();
        QVERIFY(!document().library().find("tweed-of-mine"));
        QVERIFY(yarn::importYarns(library.toStdString(), folder));
        document().reloadLibrary();
        QVERIFY(document().library().find("tweed-of-mine"));
    }

private:
    void twoYarns(int wales, int courses) {
        newChart(wales, courses);
        document().editChart("yarn", [](pattern::Chart& chart) {
            chart.yarns.push_back({"2", {9, 90, 200}, "merino-2-30"});
        });
    }

    void dragTo(QPoint from, QPoint to) {
        QTest::mousePress(canvas()->viewport(), Qt::LeftButton, {}, from);
        QTest::mouseMove(canvas()->viewport(), (from + to) / 2);
        QTest::mouseMove(canvas()->viewport(), to);
        QTest::mouseRelease(canvas()->viewport(), Qt::LeftButton, {}, to);
    }
};

} // namespace knittsim::ui

QTEST_MAIN(knittsim::ui::DesignerTest)
#include "designer_test.moc"
