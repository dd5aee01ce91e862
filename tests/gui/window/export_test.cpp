#ifndef Q_MOC_RUN // moc 6.4 does not read all headers of C++20
#include "core/pattern/samples.h"
#endif

#include "tests/gui/window/window_fixture.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/views/fabric_view/fabric_view.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QStatusBar>

namespace knittsim::ui {

using document::Document;

/// File > Export, driven by keys and mouse.
class ExportWindowTest : public WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }

    void init() {
        m_out = std::make_unique<QTemporaryDir>();
        beginTest();
    }

    void cleanup() { endTest(); }

    void isOffWhileNothingIsOpen() { QVERIFY(!child<QAction>("actionExport")->isEnabled()); }

    void writesEveryFormat() {
        openSample("plain");
        const QStringList formats{"png", "svg", "glb", "gltf", "obj", "bcc", "csv"};
        for (int i = 0; i < formats.size(); ++i) {
            openDialog();
            child<QComboBox>("exportFormat")->setCurrentIndex(i);
            const QString path = m_out->filePath("swatch." + formats[i]);
            QVERIFY2(child<QLineEdit>("exportPath")->text().endsWith('.' + formats[i]),
                     qPrintable(formats[i]));
            setPath(path);
            QTest::mouseClick(child<QPushButton>("exportStart"), Qt::LeftButton);
            QTRY_VERIFY_WITH_TIMEOUT(!m_dialog, 30000);
            QVERIFY2(QFileInfo(path).size() > 500, qPrintable(path));
            QVERIFY(m_window->statusBar()->currentMessage().contains(path));
        }
        QVERIFY(QFileInfo::exists(m_out->filePath("swatch.mtl")));
    }

    void writesTheSettlingAsAFolderOfPictures() {
        openSample("plain");
        openDialog();
        child<QComboBox>("exportFormat")->setCurrentIndex(7);
        QVERIFY(child<QLineEdit>("exportPath")->text().endsWith(".frames"));
        child<QSpinBox>("exportWidth")->setValue(64);
        child<QSpinBox>("exportHeight")->setValue(48);
        const QString path = m_out->filePath("plain.frames");
        setPath(path);
        QTest::mouseClick(child<QPushButton>("exportStart"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!m_dialog, 60000);
        const QStringList pictures = QDir(path).entryList({"*.png"});
        QVERIFY(pictures.size() >= 10);
        QCOMPARE(pictures.first(), QString("0001.png"));
        QVERIFY(QImage(path + "/0001.png") != QImage(path + '/' + pictures.last()));
        QVERIFY(!QFileInfo::exists(path + ".part"));
    }

    void aCancelledSequenceLeavesNothing() {
        openSample("plain");
        openDialog();
        child<QComboBox>("exportFormat")->setCurrentIndex(7);
        setPath(m_out->filePath("plain.frames"));
        QTest::mouseClick(child<QPushButton>("exportStart"), Qt::LeftButton);
        QTest::mouseClick(child<QPushButton>("exportCancel"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!m_dialog, 30000);
        QVERIFY(QDir(m_out->path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot).isEmpty());
    }

    void aPictureHasItsSizeAndNoBackground() {
        openSample("plain");
        openDialog();
        setPath(m_out->filePath("a.png"));
        child<QSpinBox>("exportWidth")->setValue(300);
        child<QSpinBox>("exportHeight")->setValue(200);
        QTest::mouseClick(child<QCheckBox>("exportTransparent"), Qt::LeftButton, {}, {8, 8});
        QVERIFY(child<QCheckBox>("exportTransparent")->isChecked());
        child<QComboBox>("exportSide")->setCurrentIndex(2);
        QTest::keyClick(m_dialog, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(!m_dialog, 30000);
        const QImage image(m_out->filePath("a.png"));
        QCOMPARE(image.size(), QSize(300, 200));
        QCOMPARE(qAlpha(image.pixel(0, 0)), 0);
        int opaque = 0;
        for (int y = 80; y < 120; ++y) {
            for (int x = 130; x < 170; ++x) {
                opaque += qAlpha(image.pixel(x, y)) == 255 ? 1 : 0;
            }
        }
        QVERIFY(opaque > 200);
    }

    void asksBeforeItReplacesAFile() {
        openSample("plain");
        const QString path = write("there.csv", "mine");
        openDialog();
        child<QComboBox>("exportFormat")->setCurrentIndex(6);
        setPath(path);
        QTest::mouseClick(child<QPushButton>("exportStart"), Qt::LeftButton);
        QVERIFY(child<QLabel>("exportProblem")->text().contains("exists"));
        QCOMPARE(QFileInfo(path).size(), 4);
        QTest::mouseClick(child<QPushButton>("exportStart"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!m_dialog, 30000);
        QVERIFY(QFileInfo(path).size() > 500);
    }

    void pixelsAreForPicturesOnly() {
        openSample("plain");
        openDialog();
        QVERIFY(child<QSpinBox>("exportWidth")->isEnabled());
        QCOMPARE(child<QSpinBox>("exportWidth")->maximum(), 8192);
        child<QComboBox>("exportFormat")->setCurrentIndex(2);
        QVERIFY(!child<QSpinBox>("exportWidth")->isEnabled());
        QVERIFY(!child<QCheckBox>("exportTransparent")->isEnabled());
        QVERIFY(!child<QComboBox>("exportSide")->isEnabled());
        QTest::keyClick(m_dialog, Qt::Key_Escape);
        QTRY_VERIFY(!m_dialog);
    }

    void saysWhatCannotBeWritten() {
        openSample("plain");
        openDialog();
        setPath(m_out->filePath("none/a.png"));
        child<QComboBox>("exportFormat")->setCurrentIndex(1);
        QTest::mouseClick(child<QPushButton>("exportStart"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(
            child<QLabel>("exportProblem")->text().startsWith("The file cannot be written"), 30000);
        QVERIFY2(child<QPushButton>("exportStart")->isEnabled(), "one can try again");
        QVERIFY(m_dialog->isVisible());
        QTest::keyClick(m_dialog, Qt::Key_Escape);
        QTRY_VERIFY(!m_dialog);
    }

    void cancelLeavesNoFile() {
        openSample("cable-left");
        openDialog();
        setPath(m_out->filePath("big.png"));
        child<QSpinBox>("exportWidth")->setValue(8192);
        child<QSpinBox>("exportHeight")->setValue(8192);
        QTest::mouseClick(child<QPushButton>("exportStart"), Qt::LeftButton);
        QVERIFY(child<QProgressBar>("exportProgress")->isVisible());
        QVERIFY(!child<QPushButton>("exportStart")->isEnabled());
        QTRY_VERIFY_WITH_TIMEOUT(child<QProgressBar>("exportProgress")->value() > 0, 30000);
        QTest::mouseClick(child<QPushButton>("exportCancel"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!m_dialog, 30000);
        QVERIFY2(QDir(m_out->path()).isEmpty(), "nothing is left");
    }

    void closingTheWindowEndsTheWork() {
        openSample("cable-left");
        openDialog();
        setPath(m_out->filePath("big.png"));
        child<QSpinBox>("exportWidth")->setValue(8192);
        child<QSpinBox>("exportHeight")->setValue(8192);
        QTest::mouseClick(child<QPushButton>("exportStart"), Qt::LeftButton);
        m_window.reset();
        QVERIFY(QDir(m_out->path()).isEmpty());
    }

private:
    template<class T> T* find(const QString& name) {
        T* found = m_window->findChild<T*>(name);
        if (!found) {
            qFatal("no %s", qPrintable(name));
        }
        return found;
    }

    void openDialog() {
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        QTest::keyClick(m_window.get(), Qt::Key_E, Qt::ControlModifier);
        m_dialog = m_window->findChild<ExportDialog*>("exportDialog");
        QVERIFY(m_dialog);
        QVERIFY(m_dialog->isVisible());
    }

    void setPath(const QString& path) {
        auto* line = child<QLineEdit>("exportPath");
        line->selectAll();
        QTest::keyClicks(line, path);
        QCOMPARE(line->text(), path);
    }

    std::unique_ptr<QTemporaryDir> m_out;
    QPointer<ExportDialog> m_dialog;
};

} // namespace knittsim::ui

QTEST_MAIN(knittsim::ui::ExportWindowTest)
#include "export_test.moc"
