#include "ui/speech/voice.h"

namespace knittsim::ui {

namespace {

/// Stands in where the program is built without Qt's speech library.
class NoVoice : public Voice {
public:
    VoiceTrouble trouble() const override { return VoiceTrouble::NotBuilt; }
    VoiceTrouble say(const QString&, const QLocale&) override { return VoiceTrouble::NotBuilt; }
    void stop() override {}
    bool speaking() const override { return false; }
};

} // namespace

std::unique_ptr<Voice> platformVoice() {
    return std::make_unique<NoVoice>();
}

} // namespace knittsim::ui
