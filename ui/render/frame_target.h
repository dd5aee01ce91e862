#pragma once

#include "core/base/result.h"
#include "ui/render/image.h"

#include <memory>

namespace knittsim::render {

/// A multisampled framebuffer to draw into and read back. Needs a current context for its whole life.
class FrameTarget {
public:
    /// Four samples a pixel where the driver has them. Errors: KS0404.
    static Result<std::unique_ptr<FrameTarget>> create(int width, int height);

    ~FrameTarget();
    FrameTarget(const FrameTarget&) = delete;
    FrameTarget& operator=(const FrameTarget&) = delete;

    void bind() const;

    /// Resolves the samples without reading them back; a later bind() draws again.
    void resolve() const;

    /// What was drawn. Colours that were drawn premultiplied are divided by their alpha.
    Image read() const;

    int samples() const { return m_samples; }

private:
    FrameTarget(int width, int height) : m_width(width), m_height(height) {}
    bool build();

    int m_width;
    int m_height;
    int m_samples = 0;
    unsigned m_drawn = 0; ///< framebuffers
    unsigned m_resolved = 0;
    unsigned m_buffers[3] = {}; ///< colour and depth of the drawn one, colour of the resolved one
};

} // namespace knittsim::render
