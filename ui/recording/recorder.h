#pragma once

#include "ui/document/document.h"
#include "ui/recording/frame_sinks.h"

#include <QTimer>

#include <functional>
#include <memory>

namespace knittsim::ui {

/// One step to record.
struct RecordedStep {
    machine::OperationIndex step = 0;
    QString words;
    int milliseconds = 1000; ///< how long it is shown
};

/// Walks through steps of the document and hands a picture of each to a sink. Window thread; gives it free
/// between two steps.
class Recorder : public QObject {
    Q_OBJECT

public:
    /// `ready`: the picture shows the document's step. `picture`: takes it.
    Recorder(document::Document& document, std::vector<RecordedStep> steps, std::unique_ptr<FrameSink> sink,
             std::function<bool()> ready, std::function<QImage()> picture, QObject* parent = nullptr);

    /// Steps behind the end of the program are left out. Another program ends it, and nothing is written.
    void start();
    void cancel(); ///< nothing is written; ended() tells nothing of it

signals:
    void progressed(int done);
    void ended(const QString& problem); ///< empty: written. The document is at the step where it began.

private:
    void look();
    void end(const QString& problem);

    document::Document& m_document;
    std::vector<RecordedStep> m_steps;
    std::unique_ptr<FrameSink> m_sink;
    std::function<bool()> m_ready;
    std::function<QImage()> m_picture;
    QTimer m_timer;
    std::weak_ptr<const document::OpenedFile> m_file; ///< that is recorded
    std::size_t m_next = 0;
    int m_readyLooks = 0; ///< in a row
    machine::OperationIndex m_before = 0;
};

} // namespace knittsim::ui
