#pragma once

#include <cstddef>

namespace knittsim::render {

/// A buffer that shaders read as a one-dimensional array of texels. Needs a current context for its whole
/// life.
class BufferTexture {
public:
    /// `format`: the OpenGL internal format of a texel.
    explicit BufferTexture(unsigned format);
    ~BufferTexture();
    BufferTexture(const BufferTexture&) = delete;
    BufferTexture& operator=(const BufferTexture&) = delete;

    /// Replaces the content; the driver may go on drawing with the old one meanwhile.
    void upload(const void* data, std::size_t bytes);

    /// Makes it readable through texture unit `unit`.
    void bind(int unit) const;

private:
    unsigned m_format;
    unsigned m_buffer = 0;
    unsigned m_texture = 0;
};

} // namespace knittsim::render
