#include "ui/document/operation_text.h"
#include "ui/recording/recorder.h"
#include "ui/speech/speaker.h"
#include "ui/views/fabric_view/fabric_view.h"
#include "ui/views/lesson/lesson_panel.h"
#include "ui/views/needle_beds/needle_beds.h"
#include "ui/views/step_player/step_player.h"
#include "ui/window/banner.h"
#include "ui/window/main_window.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QProgressDialog>
#include <QStatusBar>

#include <algorithm>
#include <utility>

namespace knittsim::ui {

namespace {

const QString kAnimation = QStringLiteral(".webp");
constexpr int kStopMs = 4000;
constexpr double kFastest = 25; ///< operations a second
constexpr double kSlowest = 0.5;
constexpr std::size_t kMostFrames = 2000; ///< of an animation, which is held in memory until it is written

/// Why so many steps are not recorded there; empty otherwise.
QString tooLongText(const QString& path, std::size_t steps) {
    return path.endsWith(kAnimation) && steps > kMostFrames
               ? QCoreApplication::translate("knittsim::ui::MainWindow",
                                             "An animation has %1 steps at most, and %2 are chosen: mark a "
                                             "shorter range, or record numbered pictures.")
                     .arg(kMostFrames)
                     .arg(steps)
               : QString();
}

} // namespace

void MainWindow::buildRecordingMenu(QMenu* menu) {
    addAction(menu, "actionRecordAnimation", tr("Record an &animation\u2026"), {}, {}, [this] {
        chooseRecording(tr("Record an animation"), tr("Animated WebP (*.webp)"), kAnimation);
    });
    addAction(menu, "actionRecordPictures", tr("Record &pictures\u2026"), {}, {}, [this] {
        chooseRecording(tr("Record pictures: name of a new folder"), tr("Folder of PNG files (*)"), {});
    });
    addAction(menu, "actionHandout", tr("Print a &hand-out\u2026"), {}, {},
              [this] { chooseRecording(tr("Print a hand-out"), tr("PDF (*.pdf)"), QStringLiteral(".pdf")); });
    const QString what = tr("The range to play, else the bookmarks or the stops of the lesson");
    for (const char* name : {"actionRecordAnimation", "actionRecordPictures", "actionHandout"}) {
        findChild<QAction*>(QString::fromLatin1(name))->setToolTip(what);
    }
}

/// Every operation of the range that is set, else the bookmarks.
std::vector<RecordedStep> MainWindow::stepsToRecord() const {
    const document::StepMarks& marks = std::as_const(*m_player).marks();
    const machine::Timeline& timeline = *m_document.file()->timeline;
    const auto words = [&](int step) {
        return step == 0 ? tr("The empty machine.") : document::operationSentence(timeline, step - 1);
    };
    std::vector<RecordedStep> steps;
    if (marks.loops()) {
        const int ms = static_cast<int>(1000 / std::clamp(m_player->speed(), kSlowest, kFastest));
        for (int step = marks.loopFrom(); step <= marks.loopTo(); ++step) {
            steps.push_back({step, words(step), ms});
        }
        return steps;
    }
    const auto stops = m_lesson->stopSteps();
    for (const int step : marks.bookmarks()) {
        const auto stop = std::ranges::find(stops, step);
        steps.push_back(
            {step,
             stop == stops.end() ? words(step) : m_lesson->textOf(static_cast<int>(stop - stops.begin())),
             kStopMs});
    }
    return steps;
}

void MainWindow::chooseRecording(const QString& title, const QString& filter, const QString& extension) {
    std::vector<RecordedStep> steps = m_document.file() ? stepsToRecord() : std::vector<RecordedStep>();
    if (steps.empty()) {
        m_banner->showMessage(
            Banner::Kind::Note,
            tr("Nothing is chosen yet: set bookmarks (Ctrl+B), mark a range (Shift+Home, Shift+End) "
               "or begin a lesson."));
        return;
    }
    if (const QString trouble = tooLongText(extension, steps.size()); !trouble.isEmpty()) {
        m_banner->showMessage(Banner::Kind::Note, trouble);
        return;
    }
    const QString name = QFileInfo(m_document.title()).completeBaseName() + extension;
    QString path = QFileDialog::getSaveFileName(this, title, m_session.lastFolder() + u'/' + name, filter);
    if (path.isEmpty()) {
        return;
    }
    if (!path.endsWith(extension)) {
        path += extension;
    }
    m_session.setLastFolder(QFileInfo(path).absolutePath());
    record(path, std::move(steps));
}

void MainWindow::record(const QString& path) {
    record(path, stepsToRecord());
}

void MainWindow::record(const QString& path, std::vector<RecordedStep> steps) {
    const auto count = static_cast<int>(steps.size());
    const QString title = m_lesson->running() ? m_lesson->title() : m_document.title();
    if (const QString trouble = tooLongText(path, steps.size()); !trouble.isEmpty()) {
        m_banner->showMessage(Banner::Kind::Note, trouble);
        return;
    }
    auto sink = path.endsWith(kAnimation)              ? makeWebpSink(path)
                : path.endsWith(QLatin1String(".pdf")) ? makeHandoutSink(path, title)
                                                       : makePngSink(path);
    m_player->setPlaying(false);
    const bool speaks = m_speaker->isOn();
    m_speaker->setOn(false);
    // What the lesson says at one stop is not true at the others; a hand-out writes it under each picture.
    const bool explains = m_lessonDock->isVisible();
    m_lessonDock->hide();
    m_banner->hide();
    // Steps are shown as they are, not on their way.
    m_beds->setPlaying(true);
    m_beds->setSpeed(1000);
    const int menu = menuBar()->height();
    auto* recorder = new Recorder(
        m_document, std::move(steps), std::move(sink), [this] { return m_fabric->isUpToDate(); },
        [this, menu] {
            m_fabric->picture(); // draws it, where that happens on a thread
            return grab(rect().adjusted(0, menu, 0, 0)).toImage();
        },
        this);
    auto* progress = new QProgressDialog(tr("Recording %1 steps").arg(count), tr("Cancel"), 0, count, this);
    progress->setObjectName(QStringLiteral("recordProgress"));
    progress->setWindowModality(Qt::WindowModal);
    progress->setMinimumDuration(0);
    progress->setAttribute(Qt::WA_DeleteOnClose);
    const auto leave = [this, recorder, progress, speaks, explains] {
        m_speaker->setOn(speaks);
        m_lessonDock->setVisible(explains);
        m_beds->setPlaying(false);
        m_beds->setSpeed(m_player->speed());
        recorder->deleteLater();
        progress->deleteLater();
    };
    connect(recorder, &Recorder::progressed, progress, &QProgressDialog::setValue);
    connect(progress, &QProgressDialog::canceled, this, [recorder, leave] {
        recorder->cancel();
        leave();
    });
    connect(recorder, &Recorder::ended, this, [this, path, leave](const QString& problem) {
        leave();
        if (problem.isEmpty()) {
            statusBar()->showMessage(tr("Written to %1").arg(path), 5000);
        }
        m_banner->showMessage(problem.isEmpty() ? Banner::Kind::Note : Banner::Kind::Error,
                              problem.isEmpty() ? tr("Written to %1").arg(path) : problem);
    });
    progress->show();
    recorder->start();
}

} // namespace knittsim::ui
