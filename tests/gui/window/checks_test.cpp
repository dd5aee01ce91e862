// Machine, rules that are turned off and the report, by real events.

#ifndef Q_MOC_RUN // moc 6.4 does not read all headers of C++20
#include "core/base/sha256.h"
#endif

#include "tests/gui/window/window_fixture.h"
#include "ui/document/session.h"
#include "ui/views/diagnostics/diagnostics_panel.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/window/banner.h"
#include "ui/window/machine_choice.h"

#include <QAction>
#include <QApplication>
#include <QFile>
#include <QInputDialog>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QMenu>
#include <QTimer>
#include <QToolButton>

namespace knittsim::ui {

using document::Document;

/// 60 mm of float is too much for every machine; stitch number 5 means another loop on each.
const char* const kProgram = ";!knitout-2\n;;Carriers: 1\n;;Machine: SWG091N2\nin 1\nx-stitch-number 5\n"
                             "knit + f1 1\nknit + f2 1\nknit + f60 1\nout 1\n";

class ChecksTest : public WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        qputenv("KNITTSIM_MACHINES", m_folder.filePath("machines").toUtf8());
        prepare();
    }

    void init() {
        QDir(m_folder.filePath("machines")).removeRecursively();
        beginTest();
    }

    void cleanup() { endTest(); }

    void theChoiceSaysWhatTheFileMeans() {
        auto* choice = child<MachineChoice>("machineChoice");
        QCOMPARE(choice->currentText(), QString("As the file says"));
        openPiece();
        QCOMPARE(choice->currentText(), QString("As the file says: Shima Seiki SWG type, 15 gauge"));
        QVERIFY(choice->findData("kniterate") > 0);
        QVERIFY(choice->toolTip().contains("Shima Seiki"));
    }

    void anotherMachineChecksAgainAndFeedsOtherLoops() {
        openPiece();
        const auto before = document().file();
        const double loop = before->timeline->loops().loops[1].lengthMm;
        const yarn::Yarn own = document().library().yarns().front();
        document().assignYarn(0, own);
        choose("kniterate");
        QTRY_VERIFY(document().file() != before);
        QCOMPARE(document().file()->timeline->profile().id, std::string("kniterate"));
        QVERIFY(document().file()->timeline->loops().loops[1].lengthMm > 1.2 * loop);
        QCOMPARE(document().carriers().front().yarn.id, own.id);
        QVERIFY(document().file()->fabric != before->fabric);
        QCOMPARE(child<MachineChoice>("machineChoice")->currentText(), QString("Kniterate, 7 gauge"));
    }

    void theMachineIsRemembered() {
        openPiece();
        choose("stoll-cms");
        QTRY_COMPARE(document().file()->timeline->profile().id, std::string("stoll-cms"));
        m_window.reset();
        openWindow();
        openPiece();
        QCOMPARE(document().file()->timeline->profile().id, std::string("stoll-cms"));
        choose(QString());
        QTRY_COMPARE(document().file()->timeline->profile().id, std::string("shima-swg"));
    }

    void aMachineOfOnesOwnIsCopiedWhenItIsWithoutFault() {
        openPiece();
        QFile original(QStringLiteral(KNITTSIM_SOURCE_DIR "/resources/machines/kniterate.json"));
        QVERIFY(original.open(QIODevice::ReadOnly));
        const QByteArray text = original.readAll();
        m_window->addMachine(write(
            "bad.json", QByteArray(text).replace("\"needles_per_bed\": 252", "\"needles_per_bed\": 0")));
        auto* banner = child<Banner>("banner");
        QVERIFY(banner->isVisible());
        QVERIFY2(banner->text().contains("bad.json") && banner->text().contains("needles_per_bed"),
                 qPrintable(banner->text()));
        QVERIFY(!QFile::exists(m_folder.filePath("machines/kniterate.json")));

        m_window->addMachine(write("own.json", QByteArray(text)
                                                   .replace("\"id\": \"kniterate\"", "\"id\": \"mine\"")
                                                   .replace("Kniterate, 7 gauge", "My own machine")));
        QVERIFY(QFile::exists(m_folder.filePath("machines/mine.json")));
        QTRY_COMPARE(document().file()->timeline->profile().id, std::string("mine"));
        QCOMPARE(child<MachineChoice>("machineChoice")->currentText(), QString("My own machine"));
    }

    void aRuleIsTurnedOffWithAReasonAndOnAgain() {
        openPiece();
        auto* list = child<DiagnosticsList>("diagnosticsList");
        const int all = list->problemCount();
        const int row = rowOf("KS0233");
        QVERIFY(row >= 0);
        QVERIFY(document().problemMarks().contains(2));
        QTRY_COMPARE(child<FabricView>("fabricView")->problemMarkCount(), 1);
        turn(row);
        QTRY_VERIFY(m_window->findChild<QInputDialog*>("turnOffDialog"));
        auto* dialog = m_window->findChild<QInputDialog*>("turnOffDialog");
        QTest::keyClicks(dialog->findChild<QLineEdit*>(), "cut by hand");
        QTest::keyClick(dialog, Qt::Key_Return);
        QTRY_COMPARE(rowOf("KS0233"), -1);
        QCOMPARE(list->problemCount(), all - 1);
        QVERIFY2(document().problemMarks().empty(), "a stitch without problem is not marked");
        QCOMPARE(child<FabricView>("fabricView")->problemMarkCount(), 0);

        QTest::mouseClick(child<QToolButton>("showOff"), Qt::LeftButton);
        const int off = rowOf("KS0233");
        QVERIFY(off >= 0);
        QVERIFY(list->model()
                    ->index(off, DiagnosticsModel::What)
                    .data()
                    .toString()
                    .contains("Turned off: cut by hand."));
        list->clearSelection();
        QVERIFY(list->asText().contains("(turned off: cut by hand)"));

        m_window.reset(); // it is kept
        openWindow();
        openPiece();
        QCOMPARE(rowOf("KS0233"), -1);
        QTest::mouseClick(child<QToolButton>("showOff"), Qt::LeftButton);
        turn(rowOf("KS0233"));
        QTRY_VERIFY(document().rulesOff().empty());
        QCOMPARE(child<DiagnosticsList>("diagnosticsList")->problemCount(), all);
    }

    void withoutAReasonNothingIsTurnedOff() {
        openPiece();
        turn(rowOf("KS0233"));
        QTRY_VERIFY(m_window->findChild<QInputDialog*>("turnOffDialog"));
        QTest::keyClick(m_window->findChild<QInputDialog*>("turnOffDialog"), Qt::Key_Return);
        QTRY_VERIFY(!m_window->findChild<QInputDialog*>("turnOffDialog"));
        QVERIFY(document().rulesOff().empty());
    }

    void theReportIsWrittenInTheBackground() {
        auto* report = m_window->findChild<QAction*>("actionExportReport");
        QVERIFY(!report->isEnabled());
        openPiece();
        QVERIFY(report->isEnabled());
        QVERIFY(child<QToolButton>("exportReport")->isEnabled());
        document().turnRuleOff("KS0233", "cut by hand");
        const QString path = m_folder.filePath("report.json");
        m_window->exportReport(path);
        QTRY_VERIFY(QFile::exists(path));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonObject found = QJsonDocument::fromJson(file.readAll()).object();
        QCOMPARE(found["sha256"].toString().toStdString(), sha256(kProgram));
        QCOMPARE(found["machine"].toObject()["id"].toString(), QString("shima-swg"));
        QVERIFY(file.fileName().endsWith("report.json"));
        QCOMPARE(found["sizes"].toObject()["loops"].toInt(), 3);

        m_window->exportReport(m_folder.filePath("none/report.html"));
        QTRY_VERIFY(child<Banner>("banner")->isVisible());
        QVERIFY(child<Banner>("banner")->text().contains("cannot be written"));
    }

private:
    void openPiece() {
        open([&] { m_window->openFile(write("piece.k", kProgram)); });
    }

    /// By keys, as a person without a mouse would.
    void choose(const QString& id) {
        auto* choice = child<MachineChoice>("machineChoice");
        choice->setFocus();
        const int wanted = choice->findData(id);
        QVERIFY(wanted >= 0);
        while (choice->currentIndex() != wanted) {
            const int before = choice->currentIndex();
            QTest::keyClick(choice, before < wanted ? Qt::Key_Down : Qt::Key_Up, Qt::ControlModifier);
            QVERIFY(choice->currentIndex() != before);
        }
    }

    int rowOf(const QString& rule) {
        auto* list = child<DiagnosticsList>("diagnosticsList");
        for (int row = 0; row < list->problemCount(); ++row) {
            if (list->model()->index(row, DiagnosticsModel::Kind).data().toString().contains(rule)) {
                return row;
            }
        }
        return -1;
    }

    /// The context menu's entry that turns the rule of this row off or on.
    void turn(int row) {
        auto* list = child<DiagnosticsList>("diagnosticsList");
        const QPoint at = list->visualRect(list->model()->index(row, 0)).center();
        QTimer::singleShot(0, this, [] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            QVERIFY(menu);
            auto* entry = menu->findChild<QAction*>("actionTurnRule");
            QVERIFY(entry && entry->isEnabled());
            QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(entry).center());
        });
        QContextMenuEvent event(QContextMenuEvent::Mouse, at, list->viewport()->mapToGlobal(at));
        QApplication::sendEvent(list->viewport(), &event);
    }
};

} // namespace knittsim::ui

QTEST_MAIN(knittsim::ui::ChecksTest)
#include "checks_test.moc"
