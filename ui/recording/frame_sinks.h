#pragma once

#include <QImage>
#include <QString>

#include <memory>

namespace knittsim::ui {

/// Takes the pictures of a recording. Nothing appears under its name before finish(); without it nothing is
/// left.
class FrameSink {
public:
    virtual ~FrameSink() = default;

    /// `words` say what is seen; `milliseconds`: how long it is shown. False when it is of no use to go on:
    /// finish() says why.
    virtual bool add(const QImage& picture, const QString& words, int milliseconds) = 0;

    /// What went wrong, in a sentence; empty: all is written.
    virtual QString finish() = 0;
};

/// Numbered PNG files in a new folder.
std::unique_ptr<FrameSink> makePngSink(const QString& folder);

/// One animated WebP file that begins again at its end, without loss. Pictures of other sizes are scaled to
/// that of the first.
std::unique_ptr<FrameSink> makeWebpSink(const QString& path);

/// A PDF for print: on A4, two steps a page, each with its number and words.
std::unique_ptr<FrameSink> makeHandoutSink(const QString& path, const QString& title);

} // namespace knittsim::ui
