#ifndef Q_MOC_RUN // moc 6.4 does not read all headers of C++20
#include "core/pattern/samples.h"
#endif

#include "tests/gui/window/window_fixture.h"
#include "ui/views/diagnostics/diagnostics_panel.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/views/pattern_editor/pattern_grid.h"
#include "ui/views/source/source_view.h"
#include "ui/views/step_player/step_player.h"
#include "ui/views/style/appearance.h"
#include "ui/window/banner.h"
#include "ui/window/gallery.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QSlider>
#include <QToolButton>

namespace knittsim::ui {

using document::Activity;
using document::Document;

class WindowTest : public WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }

    void init() { beginTest(); }

    void cleanup() { endTest(); }

    void beginsWithTheGallery() {
        QVERIFY(child<Gallery>("gallery")->isVisible());
        QVERIFY(!child<PatternGrid>("patternGrid")->isVisible());
        QCOMPARE(child<QMenu>("sampleMenu")->actions().size(),
                 static_cast<qsizetype>(pattern::samples().size()));
        QVERIFY(pattern::samples().size() >= 12);
    }

    void aCardOpensItsSampleAndItSettles() {
        QTest::mouseClick(child<QAbstractButton>("sample_rib-1x1"), Qt::LeftButton);
        QTRY_VERIFY(document().file());
        QVERIFY(child<FabricView>("fabricView")->isVisible());
        QVERIFY(m_window->windowTitle().startsWith("Rib 1x1"));
        settle();
        QTRY_VERIFY(child<QLabel>("simulationState")->text().startsWith("At rest"));
        QVERIFY(child<QLabel>("statusStitches")->text().contains("stitches"));
        QVERIFY(child<QLabel>("statusEnergy")->text().startsWith("V "));
    }

    void settlesTheYarnItself() {
        openSample("plain");
        QTest::keyClick(m_window.get(), Qt::Key_Y);
        QTRY_COMPARE(child<QToolButton>("settleYarn")->text(), QString("Stop the yarn"));
        QTRY_VERIFY_WITH_TIMEOUT(document().yarnRun().shape(), 60000);
        QTRY_VERIFY(!child<QLabel>("yarnState")->text().isEmpty());
        QTest::mouseClick(child<QToolButton>("settleYarn"), Qt::LeftButton);
        QCOMPARE(child<QToolButton>("settleYarn")->text(), QString("Go on as yarn"));
        QCOMPARE(child<QLabel>("yarnState")->text(), QString("Stopped"));
    }

    void aClickOnACellSelectsTheStitchEverywhere() {
        openData("plain");
        auto* grid = child<PatternGrid>("patternGrid");
        const machine::LoopIndex loop = 75;
        const QPoint cell = grid->showLoop(loop);
        QTest::mouseClick(grid->viewport(), Qt::LeftButton, {}, cell);
        QCOMPARE(document().selection().loop, loop);
        QCOMPARE(child<FabricView>("fabricView")->selection(), loop);
        QCOMPARE(child<SourceView>("sourceView")->currentLine(), document().selection().line);
        QVERIFY(document().selection().line > 0);
        QVERIFY(child<QLabel>("statusNeedle")
                    ->text()
                    .contains(QString::fromStdString(
                        machine::toString(document().file()->timeline->loops().loops[75].needle))));
        QVERIFY(!grid->accessibleDescription().isEmpty());
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        QVERIFY(document().selection().empty());
        QCOMPARE(child<FabricView>("fabricView")->selection(), -1);
    }

    void arrowsWalkInTheGridAndStepElsewhere() {
        openData("plain");
        auto* grid = child<PatternGrid>("patternGrid");
        document().selectLoop(75);
        const auto place = document().file()->grid->placeOf(75);
        grid->setFocus();
        QTest::keyClick(grid, Qt::Key_Up);
        const auto above = document().file()->grid->placeOf(document().selection().loop);
        QCOMPARE(above.course, place.course + 1);
        QCOMPARE(above.column, place.column);
        QTest::keyClick(grid, Qt::Key_Right);
        QCOMPARE(document().file()->grid->placeOf(document().selection().loop).column, place.column + 1);
        QCOMPARE(document().step(), document().operationCount());

        child<FabricView>("fabricView")->setFocus();
        QTest::keyClick(m_window.get(), Qt::Key_Left);
        QCOMPARE(document().step(), document().operationCount() - 1);
        QTest::keyClick(m_window.get(), Qt::Key_Home);
        QCOMPARE(document().step(), 0);
        QTest::keyClick(m_window.get(), Qt::Key_Up);
        QCOMPARE(document().step(), document().file()->courseEnds.front());
        QTest::keyClick(m_window.get(), Qt::Key_Right, Qt::ShiftModifier);
        QVERIFY(document().step() > document().file()->courseEnds.front());
        QTest::keyClick(m_window.get(), Qt::Key_End);
        QCOMPARE(document().step(), document().operationCount());
    }

    void stepsWithSliderAndButtons() {
        openSample("plain");
        auto* slider = child<QSlider>("stepSlider");
        auto* courses = child<QSlider>("courseSlider");
        courses->setValue(2);
        QCOMPARE(document().step(), document().file()->courseEnds.at(1));
        QCOMPARE(slider->maximum(), document().step());
        QCOMPARE(slider->minimum(), document().file()->courseEnds.at(0));
        document().setStep(100);
        QVERIFY(slider->minimum() < 100 && slider->maximum() >= 100);
        slider->setValue(slider->minimum());
        QCOMPARE(document().step(), slider->value());
        document().setStep(100);
        QCOMPARE(document().step(), 100);
        QTRY_COMPARE(static_cast<int>(document().shownFabric()->loops.size()),
                     document().machineState().loopCount);
        QTest::mouseClick(child<QToolButton>("stepForward"), Qt::LeftButton);
        QCOMPARE(document().step(), 101);
        QCOMPARE(slider->value(), 101);
        QVERIFY(child<QLabel>("stepWords")->text().contains("needle"));
        QTest::mouseClick(child<QToolButton>("stepFirst"), Qt::LeftButton);
        QCOMPARE(document().step(), 0);
    }

    void playsToTheEnd() {
        openSample("plain");
        document().setStep(document().operationCount() - 40);
        auto* player = child<StepPlayer>("stepPlayer");
        auto* speed = child<QComboBox>("stepSpeed");
        speed->setCurrentIndex(speed->count() - 1);
        child<FabricView>("fabricView")->setFocus();
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QVERIFY(player->isPlaying());
        QTRY_VERIFY(!player->isPlaying());
        QCOMPARE(document().step(), document().operationCount());
    }

    void aYarnGoesOntoACarrierAndBack() {
        openSample("plain");
        settle();
        const std::uint64_t generation = document().generation();
        const QString before = yarnOnFirstCarrier();
        child<QLineEdit>("yarnSearch")->setText("mohair");
        auto* list = child<QListView>("yarnList");
        QCOMPARE(list->model()->rowCount(), 1);
        QTest::mouseClick(child<QPushButton>("assignYarn"), Qt::LeftButton);
        QVERIFY(yarnOnFirstCarrier().contains("ohair"));
        QCOMPARE(document().generation(), generation);
        QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(yarnOnFirstCarrier(), before);
    }

    void aDoubleClickPutsAYarnOnTheSelectedCarrier() {
        openSample("float-jacquard");
        auto* carriers = child<QListView>("carrierList");
        carriers->setCurrentIndex(carriers->model()->index(1, 0));
        auto* yarns = child<QListView>("yarnList");
        const QModelIndex second = yarns->model()->index(1, 0);
        const QPoint place = yarns->visualRect(second).center();
        QTest::mouseClick(yarns->viewport(), Qt::LeftButton, {}, place);
        QTest::mouseDClick(yarns->viewport(), Qt::LeftButton, {}, place);
        QCOMPARE(carriers->model()->index(1, 0).data(Qt::DisplayRole).toString().section(": ", 1),
                 second.data(Qt::DisplayRole).toString());
    }

    void aClickOnTheFabricSelectsCellAndLine() {
        openSample("plain");
        emit child<FabricView>("fabricView")->loopClicked(33);
        QCOMPARE(document().selection().loop, 33);
        QCOMPARE(child<SourceView>("sourceView")->currentLine(), document().selection().line);
        auto* source = child<SourceView>("sourceView");
        child<QDockWidget>("sourceDock")->raise();
        source->setFocus();
        QTest::keyClick(source, Qt::Key_Down, Qt::ControlModifier);
        QCOMPARE(document().selection().loop, 34);
    }

    void aYarnIsDroppedOntoACarrier() {
        openSample("float-jacquard");
        auto* carriers = child<QListView>("carrierList");
        QCOMPARE(carriers->model()->rowCount(), 2);
        auto* yarns = child<QListView>("yarnList");
        const std::unique_ptr<QMimeData> data(yarns->model()->mimeData({yarns->model()->index(0, 0)}));
        const QModelIndex second = carriers->model()->index(1, 0);
        QVERIFY(carriers->model()->canDropMimeData(data.get(), Qt::CopyAction, -1, -1, second));
        QVERIFY(carriers->model()->dropMimeData(data.get(), Qt::CopyAction, -1, -1, second));
        QCOMPARE(carriers->model()->index(1, 0).data(Qt::DisplayRole).toString().section(": ", 1),
                 yarns->model()->index(0, 0).data(Qt::DisplayRole).toString());
    }

    void aBrokenFileIsToldInPlaceAndTheOldOneStays() {
        openSample("plain");
        const auto file = document().file();
        m_window->openFile(write("broken.k", ";!knitout-2\n;;Carriers: 1\nin 1\nknit + f1 1\nkint + f2 1\n"));
        QTRY_VERIFY(document().failedFile());
        QVERIFY(document().file() == file);
        auto* banner = child<Banner>("banner");
        QVERIFY(banner->isVisible());
        QVERIFY2(banner->text().contains("broken.k") && banner->text().contains("kint"),
                 qPrintable(banner->text()));
        QVERIFY(child<QDockWidget>("problemDock")->isVisible());
        auto* list = child<DiagnosticsList>("diagnosticsList");
        QCOMPARE(list->problemCount(), 1);
        const QRect row = list->visualRect(list->model()->index(0, 2));
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, row.center());
        QTest::mouseDClick(list->viewport(), Qt::LeftButton, {}, row.center());
        QCOMPARE(child<SourceView>("sourceView")->currentLine(), 5);
        openSample("garter");
        QVERIFY(!banner->isVisible());
        QVERIFY(!child<QDockWidget>("problemDock")->isVisible());
    }

    void problemsOfAnOpenFileLeadToLineAndStitch() {
        m_window->openFile(
            write("faults.k", ";!knitout-2\n;;Carriers: 1\nknit + f1 1\nknit + f2 1\nout 1\n"));
        QTRY_VERIFY(document().file());
        QVERIFY(child<DiagnosticsList>("diagnosticsList")->problemCount() >= 1);
        QTest::keyClick(m_window.get(), Qt::Key_F8);
        QCOMPARE(document().selection().line, 3);
        QCOMPARE(document().selection().loop, 0);
        QCOMPARE(child<SourceView>("sourceView")->currentLine(), 3);
    }

    void problemsAreFilteredSortedAndCopied() {
        m_window->openFile(write("many.k", ";!knitout-2\n;;Carriers: 1\nknit + f1 1\nrack 99\nrack 0\n"
                                           "x-stitch-number 500\nknit + f2 1\nxfer f2 f3\n"));
        QTRY_VERIFY(document().file());
        auto* list = child<DiagnosticsList>("diagnosticsList");
        QVERIFY(child<QDockWidget>("problemDock")->isVisible());
        QCOMPARE(child<QToolButton>("showErrors")->text(), QStringLiteral("3 errors"));
        QCOMPARE(child<QToolButton>("showWarnings")->text(), QStringLiteral("2 warnings"));
        QCOMPARE(child<QToolButton>("showNotes")->text(), QStringLiteral("3 notes"));
        QCOMPARE(list->problemCount(), 8);
        child<QToolButton>("showNotes")->click();
        QCOMPARE(list->problemCount(), 5);
        child<QToolButton>("showWarnings")->click();
        QCOMPARE(list->problemCount(), 3);

        QCOMPARE(list->model()->index(1, DiagnosticsModel::Where).data().toString(),
                 QStringLiteral("line 4, course 1"));

        // The rack is the second error: F8 walks over what is shown.
        QTest::keyClick(m_window.get(), Qt::Key_F8);
        QTest::keyClick(m_window.get(), Qt::Key_F8);
        QCOMPARE(child<SourceView>("sourceView")->currentLine(), 4);
        QTest::keyClick(m_window.get(), Qt::Key_F8, Qt::ShiftModifier);
        QCOMPARE(child<SourceView>("sourceView")->currentLine(), 3);

        list->sortByColumn(DiagnosticsModel::Where, Qt::DescendingOrder);
        const QString text = [&] {
            list->clearSelection();
            return list->asText();
        }();
        QCOMPARE(text.count(u'\n'), 2);
        QVERIFY(text.indexOf("KS0207") < text.indexOf("KS0218") &&
                text.indexOf("KS0218") < text.indexOf("KS0201"));

        auto* rules = child<QComboBox>("ruleChoice");
        rules->setCurrentIndex(rules->findData(QStringLiteral("KS0218")));
        QCOMPARE(list->problemCount(), 1);
        openSample("plain");
        QVERIFY2(!child<QDockWidget>("problemDock")->isVisible(), "notes alone do not open the dock");
        QCOMPARE(rules->currentIndex(), 0);
    }

    void aDroppedFileIsOpened() {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(
            write("dropped.k", QByteArray::fromStdString(pattern::sampleText("plain"))))});
        QDragEnterEvent enter({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_window.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_window.get(), &drop);
        QTRY_VERIFY(document().file());
        QCOMPARE(document().file()->request.title, QString("dropped.k"));
    }

    void recentFilesAndWindowAreRemembered() {
        const QString path = write("remembered.k", QByteArray::fromStdString(pattern::sampleText("seed")));
        m_window->openFile(path);
        QTRY_VERIFY(document().file());
        child<QDockWidget>("yarnDock")->close();
        action("actionStyleMesh")->trigger();
        m_window->resize(1100, 720);
        m_window->close();
        openWindow();
        QCOMPARE(m_window->size(), QSize(1100, 720));
        QCOMPARE(child<QMenu>("recentMenu")->actions().front()->text(), QString("remembered.k"));
        QVERIFY(action("actionStyleMesh")->isChecked());
        child<QMenu>("recentMenu")->actions().front()->trigger();
        QTRY_VERIFY(document().file());
        QVERIFY(!child<QDockWidget>("yarnDock")->isVisible());
        QVERIFY(child<QDockWidget>("gridDock")->isVisible());
    }

    void startsPausesAndRestarts() {
        openSample("plain");
        settle();
        const std::uint64_t generation = document().generation();
        child<FabricView>("fabricView")->setFocus();
        QTest::keyClick(m_window.get(), Qt::Key_R);
        QCOMPARE(document().generation(), generation + 1);
        settle();
        auto* choice = child<QComboBox>("integratorChoice");
        QVERIFY(choice->count() >= 4);
        choice->setCurrentIndex(1);
        QCOMPARE(document().integrator(), choice->itemData(1).toString());
        QVERIFY(action("actionIntegrator_" + document().integrator())->isChecked());
    }

    void theAppearanceChangesAtOnce() {
        openSample("plain");
        const QImage light = m_window->grab().toImage();
        action("actionDark")->trigger();
        QTRY_VERIFY(isDark(m_window->palette()));
        QCOMPARE(document::Session().appearance(), document::Appearance::Dark);
        const QImage dark = m_window->grab().toImage();
        const QPoint corner(4, m_window->height() - 4);
        QVERIFY(qGray(dark.pixel(corner)) + 100 < qGray(light.pixel(corner)));
        action("actionLight")->trigger();
        QTRY_VERIFY(!isDark(m_window->palette()));
    }

    void textHasEnoughContrast_data() {
        QTest::addColumn<bool>("dark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }

    void textHasEnoughContrast() {
        QFETCH(bool, dark);
        const QPalette palette = dark ? darkPalette() : lightPalette();
        const Accents accents = accentsOf(palette);
        for (const QColor& ground : {palette.color(QPalette::Window), palette.color(QPalette::Base)}) {
            for (const QColor& text :
                 {palette.color(QPalette::Text), accents.faintText, accents.good, accents.busy,
                  accents.warning, accents.error, palette.color(QPalette::Link)}) {
                QVERIFY2(contrast(text, ground) >= 4.5, qPrintable(text.name() + " on " + ground.name()));
            }
        }
        QVERIFY(contrast(palette.color(QPalette::HighlightedText), palette.color(QPalette::Highlight)) >=
                4.0);
    }

    void nothingIsCutOff_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("1280 x 800") << QSize(1280, 800);
        QTest::newRow("1024 x 700") << QSize(1024, 700);
    }

    void nothingIsCutOff() {
        QFETCH(QSize, size);
        m_window->resize(size);
        openSample("float-jacquard");
        for (const Layout layout : {Layout::Standard, Layout::Checking, Layout::Teaching}) {
            m_window->applyLayout(layout);
            QTRY_VERIFY2(misfits().isEmpty(), qPrintable(misfits().join('\n'))); // once it is laid out anew
            QCOMPARE(m_window->size(), size);
        }
    }

    void everyControlHasANameAndATip() {
        openSample("plain");
        for (const QAbstractButton* button : m_window->findChildren<QAbstractButton*>()) {
            if (!button->isVisible() || button->objectName().startsWith("qt_") ||
                button->inherits("QLineEditIconButton")) {
                continue;
            }
            QVERIFY2(!button->toolTip().isEmpty() || !button->text().isEmpty(),
                     qPrintable(button->objectName() + button->metaObject()->className() +
                                button->parent()->objectName()));
            QVERIFY2(!button->accessibleName().isEmpty() || !button->text().isEmpty() ||
                         !button->toolTip().isEmpty(),
                     qPrintable(button->objectName()));
        }
    }

    void noKeyIsGivenTwice() {
        QHash<QString, QString> owners;
        for (const QAction* one : m_window->findChildren<QAction*>()) {
            const QString key = one->shortcut().toString();
            if (!key.isEmpty()) {
                QVERIFY2(!owners.contains(key),
                         qPrintable(key + ": " + owners.value(key) + " and " + one->objectName()));
                owners.insert(key, one->objectName());
            }
        }
        QVERIFY(owners.size() > 25);
    }

private:
    /// A sample as machine data, which is looked at in the pattern grid.
    void openData(const char* id) {
        open([&] { document().openText(id, QString::fromStdString(pattern::sampleText(id))); });
    }

    QString yarnOnFirstCarrier() {
        return child<QListView>("carrierList")->model()->index(0, 0).data(Qt::DisplayRole).toString();
    }

    QStringList misfits() {
        QStringList all;
        for (const QWidget* widget : m_window->findChildren<QWidget*>()) {
            if (const QString what = misfit(widget); !what.isEmpty()) {
                all << what;
            }
        }
        return all;
    }

    /// What is wrong with a visible widget that leaves its parent or is smaller than it needs; nothing in
    /// scrolled areas.
    static QString misfit(const QWidget* widget) {
        const QWidget* parent = widget->parentWidget();
        const bool shown = widget->isVisible() && !widget->visibleRegion().isEmpty(); // not behind a tab
        const bool ofQt = widget->objectName().startsWith("qt_") || widget->inherits("QLineEditIconButton");
        if (!shown || ofQt || widget->isWindow() || !parent) {
            return {};
        }
        for (const QWidget* up = widget; up; up = up->parentWidget()) {
            if (qobject_cast<const QAbstractScrollArea*>(up) || up->inherits("QTabBar") ||
                up->inherits("QMenuBar")) {
                return {};
            }
        }
        const QString what =
            QString("%1 %2 in %3")
                .arg(widget->metaObject()->className(), widget->objectName(), parent->objectName());
        if (!parent->rect().adjusted(-1, -1, 1, 1).contains(widget->geometry())) {
            return what + " leaves its parent";
        }
        const QSize least = widget->minimumSizeHint().boundedTo(widget->maximumSize());
        if (widget->width() < least.width() || widget->height() < least.height()) {
            return what + QString(" is %1 x %2, needs %3 x %4")
                              .arg(widget->width())
                              .arg(widget->height())
                              .arg(least.width())
                              .arg(least.height());
        }
        return {};
    }

    static double lightness(const QColor& colour) {
        const auto linear = [](double c) {
            return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
        };
        return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
               0.0722 * linear(colour.blueF());
    }

    static double contrast(const QColor& a, const QColor& b) {
        const auto [low, high] = std::minmax({lightness(a), lightness(b)});
        return (high + 0.05) / (low + 0.05);
    }
};

} // namespace knittsim::ui

QTEST_MAIN(knittsim::ui::WindowTest)
#include "window_test.moc"
