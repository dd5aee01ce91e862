#include "tests/gui/window/window_fixture.h"
#include "ui/speech/speaker.h"
#include "ui/views/step_player/step_player.h"
#include "ui/views/style/language.h"
#include "ui/window/banner.h"

#include <QAction>
#include <QElapsedTimer>
#include <QLocale>

namespace knittsim::ui {

namespace {

/// Notes what it should say; speaks until it is told that it is done.
class FakeVoice : public Voice {
public:
    struct Heard {
        QStringList sentences;
        QList<QLocale::Language> languages;
        bool speaking = false;
        VoiceTrouble trouble = VoiceTrouble::None;
    };

    explicit FakeVoice(Heard& heard) : m_heard(heard) {}

    VoiceTrouble trouble() const override { return VoiceTrouble::None; }
    VoiceTrouble say(const QString& sentence, const QLocale& language) override {
        if (m_heard.trouble == VoiceTrouble::None) {
            m_heard.sentences << sentence;
            m_heard.languages << language.language();
            m_heard.speaking = true;
            tellChange();
        }
        return m_heard.trouble;
    }
    void stop() override {
        m_heard.speaking = false;
        tellChange();
    }
    bool speaking() const override { return m_heard.speaking; }
    void end() { stop(); } ///< of the sentence

private:
    Heard& m_heard;
};

} // namespace

class SpeechTest : public WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }

    void init() {
        applyLanguage(*qApp, QStringLiteral("en"));
        beginTest();
        listen();
    }

    void cleanup() {
        endTest();
        applyLanguage(*qApp, QStringLiteral("en"));
    }

    void isSilentUntilItIsAskedFor() {
        QVERIFY(!speech()->isChecked());
        document().setStep(130);
        QVERIFY(m_heard.sentences.isEmpty());
        QVERIFY(speech()->toolTip().contains("Shift+S"));
    }

    void aStepIsSpokenWhenItHasSettled() {
        on();
        QCOMPARE(m_heard.sentences.size(), 1); // where it was switched on
        press(Qt::Key_Right);
        QVERIFY2(!m_heard.speaking, "the next step cuts the sentence off");
        QTRY_COMPARE(m_heard.sentences.size(), 2);
        QVERIFY2(m_heard.sentences.back().startsWith("Knit:"), qPrintable(m_heard.sentences.back()));
        QVERIFY(m_heard.speaking);
    }

    void ofManyStepsOnlyTheLastIsSpoken() {
        on();
        m_heard.sentences.clear();
        player().setSpeed(500);
        document().setStep(document().operationCount() - 300);
        player().setPlaying(true);
        QTRY_VERIFY(!player().isPlaying());
        QTRY_COMPARE(m_heard.sentences.size(), 1);
        const QString last = m_heard.sentences.front();
        m_heard.sentences.clear();
        document().setStep(10);
        document().setStep(document().operationCount());
        QTRY_COMPARE(m_heard.sentences, QStringList{last});
    }

    void slowPlayingWaitsForTheWordsAndAPauseEndsThem() {
        on();
        m_voice->end(); // of where it was switched on
        player().setSpeed(1);
        press(Qt::Key_Space);
        QTRY_COMPARE(document().step(), 129);
        QTRY_VERIFY(m_heard.speaking);
        QElapsedTimer operation;
        operation.start();
        QTRY_VERIFY(operation.hasExpired(1500)); // the next one would have been due
        QCOMPARE(document().step(), 129);
        m_voice->end();
        QTRY_COMPARE(document().step(), 130);
        QTRY_VERIFY(m_heard.speaking);
        QVERIFY(player().isPlaying());
        press(Qt::Key_Space);
        QVERIFY(!m_heard.speaking);
        QVERIFY(!player().isPlaying());
    }

    void speaksTheLanguageOfTheWindow() {
        applyLanguage(*qApp, QStringLiteral("de"));
        openWindow();
        listen();
        document().setStep(130);
        on();
        QCOMPARE(m_heard.languages.back(), QLocale::German);
        QVERIFY2(m_heard.sentences.back().startsWith("Stricken:"), qPrintable(m_heard.sentences.back()));
    }

    void isRememberedAndToldAboutWhenItFails() {
        on();
        QCOMPARE(document::Session().value("preferences/speech"), QByteArray("1"));
        press(Qt::Key_S, Qt::ShiftModifier);
        QVERIFY(!m_heard.speaking);
        QCOMPARE(document::Session().value("preferences/speech"), QByteArray("0"));
        m_heard.trouble = VoiceTrouble::NoLanguage;
        speech()->setEnabled(true);
        speech()->trigger();
        QVERIFY(!speech()->isChecked());
        QCOMPARE(m_window->findChild<Banner*>()->text(), Speaker::troubleText(VoiceTrouble::NoLanguage));
    }

private:
    StepPlayer& player() { return *m_window->findChild<StepPlayer*>(); }
    QAction* speech() { return action(QStringLiteral("actionSpeech")); }

    /// Where Qt has no engine the action is off; the fake does not need one.
    void on() {
        speech()->setEnabled(true);
        press(Qt::Key_S, Qt::ShiftModifier);
        QVERIFY(speech()->isChecked());
    }

    /// The window that is there gets the fake, and a program.
    void listen() {
        m_heard = {};
        auto voice = std::make_unique<FakeVoice>(m_heard);
        m_voice = voice.get();
        m_window->findChild<Speaker*>()->setVoice(std::move(voice));
        open([this] { m_window->openSample(QStringLiteral("plain")); });
        document().setStep(128);
    }

    FakeVoice::Heard m_heard;
    FakeVoice* m_voice = nullptr;
};

} // namespace knittsim::ui

QTEST_MAIN(knittsim::ui::SpeechTest)
#include "speech_test.moc"
