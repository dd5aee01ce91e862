#pragma once

#include <QString>

#include <functional>
#include <memory>

class QLocale;

namespace knittsim::ui {

/// Why nothing can be heard.
enum class VoiceTrouble {
    None,
    NotBuilt,  ///< the program was built without Qt's speech library
    NoEngine,  ///< Qt has no plugin for a speech engine
    NoService, ///< the engine does not answer
    NoLanguage ///< the engine has no voice in the language
};

/// Speaks sentences. Used from one thread.
class Voice {
public:
    Voice() = default;
    Voice(const Voice&) = delete;
    Voice& operator=(const Voice&) = delete;
    virtual ~Voice() = default;

    /// What is known without speaking.
    virtual VoiceTrouble trouble() const = 0;

    /// Speaks a sentence in place of the one that may be under way; returns at once.
    virtual VoiceTrouble say(const QString& sentence, const QLocale& language) = 0;
    virtual void stop() = 0;
    virtual bool speaking() const = 0;

    /// Called whenever speaking() may have changed.
    void onChange(std::function<void()> listener) { m_listener = std::move(listener); }

protected:
    void tellChange() const {
        if (m_listener) {
            m_listener();
        }
    }

private:
    std::function<void()> m_listener;
};

/// The voice of the platform (speech-dispatcher on Linux), begun with the first sentence.
std::unique_ptr<Voice> platformVoice();

} // namespace knittsim::ui
