#include "ui/recording/recorder.h"

namespace knittsim::ui {

namespace {

constexpr int kLookMs = 15;
constexpr int kLooks = 5; ///< what follows a step (curves, frames) comes within these

} // namespace

Recorder::Recorder(document::Document& document, std::vector<RecordedStep> steps,
                   std::unique_ptr<FrameSink> sink, std::function<bool()> ready,
                   std::function<QImage()> picture, QObject* parent)
    : QObject(parent), m_document(document), m_steps(std::move(steps)), m_sink(std::move(sink)),
      m_ready(std::move(ready)), m_picture(std::move(picture)) {
    m_timer.setInterval(kLookMs);
    connect(&m_timer, &QTimer::timeout, this, &Recorder::look);
}

void Recorder::start() {
    m_before = m_document.step();
    m_file = m_document.file();
    std::erase_if(
        m_steps, [last = m_document.operationCount()](const RecordedStep& step) { return step.step > last; });
    m_next = 0;
    m_readyLooks = 0;
    if (m_steps.empty()) {
        end(tr("There is no step to record."));
        return;
    }
    m_document.setStep(m_steps.front().step);
    m_timer.start();
}

void Recorder::cancel() {
    m_timer.stop();
    m_sink.reset();
    m_document.setStep(m_before);
}

void Recorder::look() {
    if (m_file.lock() != m_document.file()) {
        end(tr("The program changed while it was recorded."));
        return;
    }
    const RecordedStep& step = m_steps[m_next];
    const bool ready = m_document.step() == step.step && m_document.shownStep() == step.step && m_ready();
    m_readyLooks = ready ? m_readyLooks + 1 : 0;
    if (m_readyLooks < kLooks) {
        return;
    }
    m_readyLooks = 0;
    const bool goesOn = m_sink->add(m_picture(), step.words, step.milliseconds);
    ++m_next;
    if (!goesOn || m_next == m_steps.size()) {
        end(m_sink->finish());
        return;
    }
    m_document.setStep(m_steps[m_next].step);
    emit progressed(static_cast<int>(m_next));
}

void Recorder::end(const QString& problem) {
    m_timer.stop();
    m_sink.reset();
    m_document.setStep(m_before);
    emit ended(problem);
}

} // namespace knittsim::ui
