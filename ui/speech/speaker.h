#pragma once

#include "ui/document/document.h"
#include "ui/speech/voice.h"

#include <QTimer>

namespace knittsim::ui {

/// Speaks the operation that is shown, in the language of the window: when a step has settled, so that of
/// steps that chase each other only the last is heard. The next step and a pause cut a sentence off.
class Speaker : public QObject {
    Q_OBJECT

public:
    /// A step that stays this long is spoken.
    static constexpr int kSettleMs = 450;
    /// No sentence takes longer: an engine without sound may never say that it is done.
    static constexpr int kLongestMs = 12000;

    explicit Speaker(document::Document& document, QObject* parent = nullptr);

    void setVoice(std::unique_ptr<Voice> voice);
    VoiceTrouble trouble() const { return m_voice->trouble(); }
    /// Cause and cure in words; empty without trouble.
    static QString troubleText(VoiceTrouble trouble);

    bool isOn() const { return m_on; }
    /// Off by default. The step that is shown is spoken at once.
    void setOn(bool on);

    /// The player plays: a pause ends the sentence; what was not yet spoken then is spoken.
    void setPlaying(bool on);

signals:
    /// While a sentence is spoken.
    void speakingChanged(bool on);
    void failed(const QString& text); ///< it is off now

private:
    void takeStep();
    void speak();
    void hush();
    void tellSpeaking();

    document::Document& m_document;
    std::unique_ptr<Voice> m_voice;
    QTimer m_settling;
    QTimer m_longest; ///< runs while a sentence may be under way
    bool m_on = false;
    bool m_told = false; ///< by speakingChanged
    int m_spoken = -1;   ///< the step whose sentence was begun last
};

} // namespace knittsim::ui
