#include "ui/speech/voice.h"

#include <QLocale>
#include <QTextToSpeech>

#include <algorithm>

namespace knittsim::ui {

namespace {

class PlatformVoice : public Voice {
public:
    VoiceTrouble trouble() const override {
        return QTextToSpeech::availableEngines().isEmpty()             ? VoiceTrouble::NoEngine
               : m_engine && m_engine->state() == QTextToSpeech::Error ? VoiceTrouble::NoService
                                                                       : VoiceTrouble::None;
    }

    VoiceTrouble say(const QString& sentence, const QLocale& language) override {
        if (QTextToSpeech::availableEngines().isEmpty()) {
            return VoiceTrouble::NoEngine;
        }
        if (!m_engine || m_engine->state() == QTextToSpeech::Error) {
            begin(); // also where the service has come up since
        }
        if (m_engine->state() == QTextToSpeech::Error) {
            return VoiceTrouble::NoService;
        }
        if (m_engine->locale().language() != language.language() && !choose(language)) {
            return VoiceTrouble::NoLanguage;
        }
        m_engine->say(sentence);
        return VoiceTrouble::None;
    }

    void stop() override {
        if (m_engine) {
            m_engine->stop(QTextToSpeech::BoundaryHint::Immediate);
        }
    }

    bool speaking() const override { return m_engine && m_engine->state() == QTextToSpeech::Speaking; }

private:
    void begin() {
        m_engine = std::make_unique<QTextToSpeech>();
        QObject::connect(m_engine.get(), &QTextToSpeech::stateChanged, m_engine.get(),
                         [this] { tellChange(); });
    }

    bool choose(const QLocale& language) {
        const auto known = m_engine->availableLocales();
        const auto found = std::ranges::find(known, language.language(), &QLocale::language);
        if (found == known.end()) {
            return false;
        }
        m_engine->setLocale(known.contains(language) ? language : *found);
        return true;
    }

    std::unique_ptr<QTextToSpeech> m_engine;
};

} // namespace

std::unique_ptr<Voice> platformVoice() {
    return std::make_unique<PlatformVoice>();
}

} // namespace knittsim::ui
