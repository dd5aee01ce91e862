#pragma once

#include "core/base/result.h"
#include "ui/render/image.h"

#include <memory>

namespace knittsim::render {

/// A framebuffer to draw into and read back. Needs a current context for its whole life.
class FrameTarget {
public:
    /// `samples` a pixel, or as many as the driver has; 0 draws hard edges. Errors: KS0404.
    static Result<std::unique_ptr<FrameTarget>> create(int width, int height, int samples = 4);

    ~FrameTarget();
    FrameTarget(const FrameTarget&) = delete;
    FrameTarget& operator=(const FrameTarget&) = delete;

    /// Pixels of the largest picture that can be drawn part by part.
    static int mostPixels();

    void bind() const;

    /// Clears colour and depth, and nothing else: what any picture costs at least.
    void clear() const;

    /// Resolves the samples without reading them back, and waits until all is drawn. A later bind() draws
    /// again.
    void finish() const;

    /// What was drawn. Colours that were drawn premultiplied are divided by their alpha.
    Image read() const;

    int width() const { return m_width; }
    int height() const { return m_height; }

private:
    void resolve() const;
    FrameTarget(int width, int height, int samples) : m_width(width), m_height(height), m_samples(samples) {}
    bool build();

    int m_width;
    int m_height;
    int m_samples;
    unsigned m_drawn = 0; ///< framebuffers
    unsigned m_resolved = 0;
    unsigned m_buffers[3] = {}; ///< colour and depth of the drawn one, colour of the resolved one
};

} // namespace knittsim::render
