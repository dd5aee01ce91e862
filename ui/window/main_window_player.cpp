#include "ui/speech/speaker.h"
#include "ui/views/lesson/lesson_panel.h"
#include "ui/views/step_player/step_player.h"
#include "ui/window/banner.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QMenu>

#include <utility>

namespace knittsim::ui {

namespace {

const QString kMarks = QStringLiteral("marks"); ///< group of what was marked in a file
const QString kSpeech = QStringLiteral("preferences/speech");

} // namespace

/// What the player has besides its own buttons: marks that are kept with the file, and a voice.
void MainWindow::buildPlayer() {
    m_speaker = new Speaker(m_document, this);
    connect(m_player, &StepPlayer::playingChanged, m_speaker, &Speaker::setPlaying);
    connect(m_speaker, &Speaker::speakingChanged, m_player, &StepPlayer::setWaiting);
    connect(&m_player->marks(), &document::StepMarks::changed, this, &MainWindow::keepMarks);
}

/// A lesson brings its own bookmarks; those of the person stay as they were.
void MainWindow::keepMarks() {
    if (!m_marksKey.isEmpty() && m_marksKey == document::Session::keyOf(kMarks, m_document.path()) &&
        !m_lesson->running()) {
        m_session.setValue(m_marksKey, std::as_const(*m_player).marks().save());
    }
}

void MainWindow::recallMarks() {
    m_marksKey = document::Session::keyOf(kMarks, m_document.path());
    if (!m_marksKey.isEmpty() && m_player->marks().restore(m_session.value(m_marksKey))) {
        m_player->marks().endAt(m_document.operationCount()); // the file may have become shorter
    }
}

/// The document has another name now.
void MainWindow::moveMarks() {
    m_marksKey = document::Session::keyOf(kMarks, m_document.path());
    keepMarks();
}

void MainWindow::buildSpeechAction(QMenu* menu) {
    QAction* speech = addChoice(menu, nullptr, "actionSpeech", tr("&Speak the operations"),
                                Qt::SHIFT | Qt::Key_S, {}, [] {});
    const QString help = tr("Speaks each operation that is shown, in the language of the window (Shift+S)");
    const QString trouble = Speaker::troubleText(m_speaker->trouble());
    speech->setToolTip(trouble.isEmpty() ? help : help + u'\n' + trouble);
    speech->setEnabled(trouble.isEmpty());
    connect(speech, &QAction::toggled, m_speaker, &Speaker::setOn);
    connect(speech, &QAction::triggered, this,
            [this](bool on) { m_session.setValue(kSpeech, on ? "1" : "0"); });
    connect(m_speaker, &Speaker::failed, this, [this, speech](const QString& text) {
        speech->setChecked(false);
        m_banner->showMessage(Banner::Kind::Note, text);
    });
    speech->setChecked(speech->isEnabled() && m_session.value(kSpeech) == "1");
}

} // namespace knittsim::ui
