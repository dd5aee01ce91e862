#include "ui/render/buffer_texture.h"

#include <epoxy/gl.h>

namespace knittsim::render {

BufferTexture::BufferTexture(unsigned format) : m_format(format) {
    glGenBuffers(1, &m_buffer);
    glGenTextures(1, &m_texture);
    glBindBuffer(GL_TEXTURE_BUFFER, m_buffer);
    constexpr unsigned kNothing[4] = {};
    glBufferData(GL_TEXTURE_BUFFER, sizeof kNothing, kNothing, GL_STREAM_DRAW);
    glBindTexture(GL_TEXTURE_BUFFER, m_texture);
    glTexBuffer(GL_TEXTURE_BUFFER, m_format, m_buffer);
}

BufferTexture::~BufferTexture() {
    glDeleteTextures(1, &m_texture);
    glDeleteBuffers(1, &m_buffer);
}

void BufferTexture::upload(const void* data, std::size_t bytes) {
    if (bytes == 0) {
        return;
    }
    glBindBuffer(GL_TEXTURE_BUFFER, m_buffer);
    glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STREAM_DRAW);
    glBindTexture(GL_TEXTURE_BUFFER, m_texture);
    glTexBuffer(GL_TEXTURE_BUFFER, m_format, m_buffer);
}

void BufferTexture::bind(int unit) const {
    glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_BUFFER, m_texture);
}

} // namespace knittsim::render
