#include "ui/dialogs/glossary_dialog.h"
#include "ui/document/message_text.h"
#include "ui/views/lesson/lesson_panel.h"
#include "ui/views/lesson/teaching_board.h"
#include "ui/views/step_player/step_player.h"
#include "ui/views/style/language.h"
#include "ui/window/banner.h"
#include "ui/window/main_window.h"

#include <QActionGroup>
#include <QBoxLayout>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMenu>
#include <QMenuBar>

#include <algorithm>

namespace knittsim::ui {

void MainWindow::buildTeaching() {
    m_board = new TeachingBoard(m_document, m_workspace);
    qobject_cast<QBoxLayout*>(m_workspace->layout())->insertWidget(0, m_board);
    m_lesson = new LessonPanel(m_document, this);
    m_lessonDock = addDock(QStringLiteral("lessonDock"), tr("Lesson"), m_lesson, Qt::RightDockWidgetArea);
    connect(m_lesson, &LessonPanel::sampleWanted, this, &MainWindow::openSample);
    connect(m_lesson, &LessonPanel::programWanted, this, &MainWindow::openFile);
    connect(m_lesson, &LessonPanel::openWanted, this, &MainWindow::chooseLesson);
    connect(m_lesson, &LessonPanel::begun, this, &MainWindow::takeLesson);
    connect(m_lesson, &LessonPanel::runningChanged, this, &MainWindow::takeActions);
    connect(m_lesson, &LessonPanel::stopShown, this, [this](lesson::Look look) {
        m_gridDock->setVisible(look == lesson::Look::Chart);
        if (look == lesson::Look::Chart) {
            resizeDocks({m_gridDock}, {width() / 4}, Qt::Horizontal);
        }
        m_sourceDock->setVisible(look == lesson::Look::Source);
    });
}

/// The program of a lesson is open: everything for the class, and a bookmark at each stop.
void MainWindow::takeLesson() {
    if (m_layout != Layout::Teaching) {
        applyLayout(Layout::Teaching);
    }
    m_bedDock->show();
    m_lessonDock->show();
    resizeDocks({m_lessonDock}, {std::max(360, width() / 4)}, Qt::Horizontal);
    const auto steps = m_lesson->stopSteps();
    m_player->marks().setBookmarks({steps.begin(), steps.end()});
}

void MainWindow::buildLessonMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&Lesson"));
    menu->setObjectName(QStringLiteral("lessonMenu"));
    menu->setToolTipsVisible(true);
    m_lessonMenu = menu->addMenu(tr("&Begin a lesson"));
    m_lessonMenu->setObjectName(QStringLiteral("lessonsMenu"));
    m_lessonMenu->setToolTipsVisible(true);
    connect(m_lessonMenu, &QMenu::aboutToShow, this, &MainWindow::listLessons);
    listLessons();
    addAction(menu, "actionOpenLesson", tr("&Open a lesson\u2026"), {}, {}, [this] { chooseLesson(); });
    menu->addSeparator();
    addAction(menu, "actionStopNext", tr("&Next stop"), Qt::Key_PageDown, "forward",
              [this] { m_lesson->moveStop(+1); });
    addAction(menu, "actionStopBack", tr("Stop be&fore"), Qt::Key_PageUp, "back",
              [this] { m_lesson->moveStop(-1); });
    menu->addSeparator();
    buildRecordingMenu(menu);
    menu->addSeparator();
    buildSpeechAction(menu);
    addAction(menu, "actionGlossary", tr("&Words of machine knitting"), Qt::SHIFT | Qt::Key_F1, {},
              [this] { showGlossary(); });
}

void MainWindow::listLessons() {
    m_lessonMenu->clear();
    const auto& lessons = m_lesson->lessons();
    for (std::size_t i = 0; i < lessons.size(); ++i) {
        const std::string language = QLocale().name().toStdString();
        QAction* action = m_lessonMenu->addAction(QString::fromStdString(lessons[i].title.in(language)), this,
                                                  [this, i] { m_lesson->begin(static_cast<int>(i)); });
        action->setToolTip(QString::fromStdString(lessons[i].summary.in(language)));
    }
}

void MainWindow::chooseLesson() {
    const QString path = askWhich(tr("Open a lesson"), tr("Lessons (*.json);;All files (*)"));
    if (!path.isEmpty()) {
        openLesson(path);
    }
}

void MainWindow::openLesson(const QString& path) {
    const auto& known = m_lesson->lessons();
    const auto found = std::ranges::find(known, path.toStdString(), &lesson::Lesson::id);
    if (found != known.end()) {
        m_lesson->begin(static_cast<int>(found - known.begin()));
        return;
    }
    const Diagnostics problems = m_lesson->openFile(path);
    if (!problems.empty()) {
        const QString place = document::placeText(problems.front().place);
        m_banner->showMessage(Banner::Kind::Error,
                              tr("%1 is no lesson that can be used.").arg(QFileInfo(path).fileName()) + u' ' +
                                  (place.isEmpty() ? QString() : place + QStringLiteral(": ")) +
                                  document::causeText(problems.front()) + u' ' +
                                  document::cureText(problems.front()));
    }
}

void MainWindow::showGlossary() {
    auto* dialog = findChild<GlossaryDialog*>();
    if (!dialog) {
        dialog = new GlossaryDialog(this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
    }
    dialog->show();
    dialog->raise();
}

void MainWindow::buildLanguageMenu(QMenu* view) {
    QMenu* menu = view->addMenu(tr("Lan&guage"));
    menu->setObjectName(QStringLiteral("languageMenu"));
    auto* group = new QActionGroup(this);
    const QString chosen = m_session.language();
    const auto add = [&](const QString& id, const QString& text) {
        QAction* action =
            addChoice(menu, group, QStringLiteral("actionLanguage_") + id, text, {}, {}, [this, id] {
                m_session.setLanguage(id);
                emit languageChosen(id);
            });
        action->setChecked(id == chosen);
    };
    add({}, tr("As the &system"));
    for (const QString& id : languages()) {
        add(id, QLocale(id).nativeLanguageName());
    }
}

} // namespace knittsim::ui
