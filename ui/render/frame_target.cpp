#include "ui/render/frame_target.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>

namespace knittsim::render {

Result<std::unique_ptr<FrameTarget>> FrameTarget::create(int width, int height, int samples) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    const auto fail = [&](std::string reason) {
        return Diagnostic{.id = "KS0404",
                          .place = {},
                          .arguments = {fmt::format("{} x {} pixels: {}", width, height, reason)}};
    };
    if (width < 1 || height < 1 || width > largest || height > largest) {
        return fail(fmt::format("the graphics driver takes 1 to {}", largest));
    }
    std::unique_ptr<FrameTarget> target(new FrameTarget(width, height, samples));
    if (!target->build()) {
        return fail("the graphics driver has not enough memory");
    }
    return target;
}

int FrameTarget::mostPixels() {
    GLint most[2] = {};
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, most);
    return std::min(most[0], most[1]);
}

bool FrameTarget::build() {
    GLint most = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    m_samples = std::clamp(m_samples, 0, static_cast<int>(most));
    glGenRenderbuffers(3, m_buffers);
    glGenFramebuffers(1, &m_drawn);
    glGenFramebuffers(1, &m_resolved);
    glBindRenderbuffer(GL_RENDERBUFFER, m_buffers[0]);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, m_samples, GL_RGBA8, m_width, m_height);
    glBindRenderbuffer(GL_RENDERBUFFER, m_buffers[1]);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, m_samples, GL_DEPTH_COMPONENT24, m_width, m_height);
    glBindRenderbuffer(GL_RENDERBUFFER, m_buffers[2]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, m_width, m_height);
    glBindFramebuffer(GL_FRAMEBUFFER, m_resolved);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, m_buffers[2]);
    const bool resolvedComplete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    glBindFramebuffer(GL_FRAMEBUFFER, m_drawn);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, m_buffers[0]);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, m_buffers[1]);
    return resolvedComplete && glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

FrameTarget::~FrameTarget() {
    glDeleteFramebuffers(1, &m_drawn);
    glDeleteFramebuffers(1, &m_resolved);
    glDeleteRenderbuffers(3, m_buffers);
}

void FrameTarget::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, m_drawn);
}

void FrameTarget::clear() const {
    bind();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void FrameTarget::finish() const {
    resolve();
    glFinish();
}

void FrameTarget::resolve() const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_drawn);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, m_resolved);
    glBlitFramebuffer(0, 0, m_width, m_height, 0, 0, m_width, m_height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

Image FrameTarget::read() const {
    resolve();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_resolved);
    Image image{m_width, m_height, {}};
    const std::size_t row = 4 * static_cast<std::size_t>(m_width);
    image.pixels.resize(row * static_cast<std::size_t>(m_height));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, m_width, m_height, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    for (std::size_t y = 0; y < static_cast<std::size_t>(m_height) / 2; ++y) {
        auto* upper = image.pixels.data() + y * row;
        auto* lower = image.pixels.data() + (static_cast<std::size_t>(m_height) - 1 - y) * row;
        std::swap_ranges(upper, upper + row, lower);
    }
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        const int alpha = image.pixels[i + 3];
        for (std::size_t c = i; alpha > 0 && alpha < 255 && c < i + 3; ++c) {
            image.pixels[c] =
                static_cast<std::uint8_t>(std::min(255, (image.pixels[c] * 255 + alpha / 2) / alpha));
        }
    }
    return image;
}

} // namespace knittsim::render
