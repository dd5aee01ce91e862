// Files that a designer chooses in a dialog: yarns and machine data.

#ifndef Q_MOC_RUN // moc 6.4 does not read all headers of C++20
#include "core/formats/formats.h"
#include "core/pattern/lift.h"
#include "core/yarn/own_yarns.h"
#include "core/yarn/yarn_library.h"
#endif

#include "tests/gui/window/chart_fixture.h"
#include "ui/views/yarn_library/yarn_dialog.h"
#include "ui/views/yarn_library/yarn_model.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

namespace knittsim::ui {

using document::Document;

class DeskFilesTest : public ChartFixture {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }
    void init() {
        beginTest();
        newChart(12, 10);
    }
    void cleanup() {
        QDir(Document::ownYarnFolder()).removeRecursively();
        endTest();
    }

    void aYarnIsExportedAndNamedByTheDialog() {
        const QString id = yarns()->currentIndex().data(IdRole).toString();
        const QString path = m_folder.filePath("one yarn");
        choose(kExport, path);
        const auto read = yarn::readYarns((path + ".json").toStdString());
        QVERIFY(read);
        QCOMPARE(read.value().size(), std::size_t{1});
        QCOMPARE(QString::fromStdString(read.value()[0].id), id);
    }

    void nothingIsWrittenWhereTheDialogIsLeft() {
        const auto files = [this] { return QDir(m_folder.path()).entryList(QDir::Files); };
        const QStringList before = files();
        answer<QFileDialog>([](QFileDialog* dialog) { QTest::keyClick(dialog, Qt::Key_Escape); });
        own(kExport)->trigger();
        QVERIFY(m_answered);
        QCOMPARE(files(), before);
    }

    void ownYarnsAreOneFileThatComesBack() {
        QVERIFY(!own(kExportOwn)->isEnabled());
        makeYarn("Tweed of mine");
        makeYarn("Silk of mine");
        const QString path = m_folder.filePath("mine.json");
        choose(kExportOwn, path);
        QCOMPARE(yarn::readYarns(path.toStdString()).value().size(), std::size_t{2});
        deleteYarn("tweed-of-mine");
        deleteYarn("silk-of-mine");
        QVERIFY(!document().library().find("tweed-of-mine"));
        child<QLineEdit>("yarnSearch")->setText("linen");
        choose(kImport, path);
        QVERIFY(document().library().find("tweed-of-mine"));
        QVERIFY(document().library().find("silk-of-mine"));
        QCOMPARE(yarns()->model()->rowCount(), 2); // what was imported is seen
        QVERIFY(yarns()->currentIndex().data(TitleRole).toString().endsWith("of mine"));
    }

    void aFileWithoutYarnsIsRefusedWithTheReason() {
        yarn::Yarn slippery = yarn::defaultYarn();
        slippery.id = "x";
        slippery.friction = 9;
        const QString path = write("bad.json", QByteArray::fromStdString(yarn::toJson(slippery)));
        const int before = yarns()->model()->rowCount();
        QString told;
        answer<QFileDialog>([&](QFileDialog* dialog) {
            answer<QMessageBox>([&](QMessageBox* box) {
                told = box->text();
                QTest::keyClick(box, Qt::Key_Return);
            });
            enter(dialog, path);
        });
        own(kImport)->trigger();
        QVERIFY2(told.contains("bad.json") && told.contains("friction"), qPrintable(told));
        QCOMPARE(yarns()->model()->rowCount(), before);
        QVERIFY(!document().library().find("x"));
    }

    void aNewYarnIsSeenWhateverIsSearched() {
        child<QLineEdit>("yarnSearch")->setText("linen");
        makeYarn("Zebra");
        QCOMPARE(yarns()->currentIndex().data(TitleRole).toString(), QString("Zebra"));
    }

    void aYarnIsKeptWhereItsDeletionIsNotConfirmed() {
        makeYarn("Tweed of mine");
        answer<QMessageBox>([](QMessageBox* box) { QTest::keyClick(box, Qt::Key_Escape); });
        own(kDelete)->trigger();
        QVERIFY(m_answered);
        QVERIFY(document().library().find("tweed-of-mine"));
    }

    void machineDataOfEveryMakerComesFromAnyChart_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("machine");
        QTest::newRow("knitout") << "a.k"
                                 << "generic-e15";
        QTest::newRow("DAT") << "a.dat"
                             << "SWG";
        QTest::newRow("k-code") << "a.kc"
                                << "Kniterate";
    }
    void machineDataOfEveryMakerComesFromAnyChart() {
        QFETCH(QString, name);
        QFETCH(QString, machine);
        const QString path = m_folder.filePath(name);
        answer<QFileDialog>([&](QFileDialog* dialog) { enter(dialog, path); });
        action("actionExportMachine")->trigger();
        const auto program = formats::readProgram(path.toStdString());
        QVERIFY(program);
        QVERIFY(QString::fromStdString(program.value().header.machine).startsWith(machine));
        const auto back = pattern::readAnyProject(path.toStdString());
        QVERIFY(back);
        QCOMPARE(back.value().chart.cells, chart().cells);
    }

    void enterBeginsANewChartOnTheOpeningPage() {
        openWindow();
        auto* fresh = child<QPushButton>("galleryNew");
        QTRY_COMPARE(m_window->focusWidget(), fresh);
        QTest::keyClick(fresh, Qt::Key_Return);
        QTRY_VERIFY(m_window->findChild<QDialog*>("newChart"));
    }

    void cellsStayBelowThePointerWhenHintsCome() {
        QTRY_VERIFY(document().fabricFollowsChart() && !document().isRebuilding());
        QTest::qWait(200); // until all lies where it stays
        const QPoint before = place({3, 3});
        QTest::mouseMove(canvas()->viewport(), before);
        QTRY_VERIFY(!child<QLabel>("chartHint")->text().isEmpty());
        QTest::qWait(50); // the layout may follow
        QCOMPARE(place({3, 3}), before);
        QTest::mouseMove(canvas()->viewport(), QPoint(1, 1));
        QTRY_COMPARE(place({3, 3}), before);
    }

private:
    // Entries of the menu, with its separator.
    static constexpr int kNew = 0;
    static constexpr int kDelete = 2;
    static constexpr int kImport = 4;
    static constexpr int kExport = 5;
    static constexpr int kExportOwn = 6;

    QListView* yarns() { return child<QListView>("yarnList"); }

    QAction* own(int entry) {
        auto* menu = child<QMenu>("ownYarnMenu");
        emit menu->aboutToShow();
        return menu->actions().at(entry);
    }

    /// `how` is called with the next modal dialog of this kind.
    template<class T> void answer(std::function<void(T*)> how) {
        m_answered = false;
        auto* timer = new QTimer(this);
        connect(timer, &QTimer::timeout, this, [this, timer, how] {
            if (auto* dialog = qobject_cast<T*>(QApplication::activeModalWidget())) {
                timer->stop();
                timer->deleteLater();
                m_answered = true;
                how(dialog);
            }
        });
        timer->start(20);
    }

    /// The name is not typed: whether it is completed depends on how fast the folder is read.
    static void enter(QFileDialog* dialog, const QString& path) {
        dialog->findChild<QLineEdit*>("fileNameEdit")->setText(path);
        const bool saves = dialog->acceptMode() == QFileDialog::AcceptSave;
        dialog->findChild<QDialogButtonBox*>()
            ->button(saves ? QDialogButtonBox::Save : QDialogButtonBox::Open)
            ->click();
    }

    void choose(int entry, const QString& path) {
        answer<QFileDialog>([path](QFileDialog* dialog) { enter(dialog, path); });
        own(entry)->trigger();
        QVERIFY(m_answered);
    }

    void makeYarn(const QString& name) {
        own(kNew)->trigger();
        auto* dialog = m_window->findChild<YarnDialog*>();
        QVERIFY(dialog);
        auto* field = dialog->findChild<QLineEdit*>("name");
        QCOMPARE(dialog->focusWidget(), field);
        QTest::keyClicks(field, name); // the old one is selected
        QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save),
                          Qt::LeftButton);
        QTRY_VERIFY(!m_window->findChild<YarnDialog*>());
    }

    void deleteYarn(const QString& id) {
        const QAbstractItemModel* model = yarns()->model();
        for (int i = 0; i < model->rowCount(); ++i) {
            if (model->index(i, 0).data(IdRole).toString() == id) {
                yarns()->setCurrentIndex(model->index(i, 0));
                answer<QMessageBox>([](QMessageBox* box) {
                    QTest::mouseClick(box->button(QMessageBox::Yes), Qt::LeftButton);
                });
                own(kDelete)->trigger();
                QVERIFY(m_answered);
                return;
            }
        }
        QFAIL("no such yarn");
    }

    bool m_answered = false;
};

} // namespace knittsim::ui

QTEST_MAIN(knittsim::ui::DeskFilesTest)
#include "desk_files_test.moc"
