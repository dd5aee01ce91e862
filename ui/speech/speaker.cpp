#include "ui/speech/speaker.h"

#include "ui/document/operation_text.h"

#include <QLocale>

#include <utility>

namespace knittsim::ui {

Speaker::Speaker(document::Document& document, QObject* parent) : QObject(parent), m_document(document) {
    setObjectName(QStringLiteral("speaker"));
    m_settling.setSingleShot(true);
    m_settling.setInterval(kSettleMs);
    m_longest.setSingleShot(true);
    m_longest.setInterval(kLongestMs);
    connect(&m_settling, &QTimer::timeout, this, &Speaker::speak);
    connect(&m_longest, &QTimer::timeout, this, &Speaker::tellSpeaking);
    connect(&m_document, &document::Document::stepChanged, this, &Speaker::takeStep);
    connect(&m_document, &document::Document::fileChanged, this, &Speaker::takeStep);
    setVoice(platformVoice());
}

void Speaker::setVoice(std::unique_ptr<Voice> voice) {
    m_voice = std::move(voice);
    m_voice->onChange([this] { tellSpeaking(); });
}

QString Speaker::troubleText(VoiceTrouble trouble) {
    switch (trouble) {
    case VoiceTrouble::NotBuilt:
        return tr("This program was built without speech. Install qt6-speech-dev and qt6-declarative-dev and "
                  "build it anew.");
    case VoiceTrouble::NoEngine:
        return tr("Qt finds no speech engine. Install qt6-speech-speechd-plugin and speech-dispatcher.");
    case VoiceTrouble::NoService:
        return tr("The speech service does not answer. Install speech-dispatcher with a voice such as "
                  "speech-dispatcher-espeak-ng.");
    case VoiceTrouble::NoLanguage:
        return tr("The speech service has no voice in this language.");
    case VoiceTrouble::None:
        break;
    }
    return {};
}

void Speaker::setOn(bool on) {
    if (on == m_on) {
        return;
    }
    m_on = on;
    on ? speak() : hush();
}

void Speaker::setPlaying(bool on) {
    if (on || !m_on) {
        return;
    }
    hush();
    if (m_spoken != m_document.step()) {
        m_settling.start();
    }
}

void Speaker::takeStep() {
    if (m_on) {
        hush();
        m_spoken = -1;
        m_settling.start();
    }
}

void Speaker::speak() {
    m_settling.stop();
    const auto file = m_document.file();
    const int step = m_document.step();
    m_spoken = step;
    if (!file) {
        return;
    }
    const QString sentence =
        step == 0 ? tr("The empty machine.") : document::operationSentence(*file->timeline, step - 1);
    m_longest.start();
    const VoiceTrouble trouble = m_voice->say(sentence, QLocale());
    if (trouble != VoiceTrouble::None) {
        m_on = false;
        emit failed(troubleText(trouble));
    }
    tellSpeaking();
}

void Speaker::hush() {
    m_settling.stop();
    m_longest.stop();
    m_voice->stop();
    tellSpeaking();
}

void Speaker::tellSpeaking() {
    const bool speaking = m_on && m_longest.isActive() && m_voice->speaking();
    if (std::exchange(m_told, speaking) != speaking) {
        emit speakingChanged(speaking);
    }
}

} // namespace knittsim::ui
