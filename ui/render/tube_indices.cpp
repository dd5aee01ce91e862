#include "ui/render/tube_indices.h"

#include <epoxy/gl.h>

#include <vector>

namespace knittsim::render {

TubeIndices::TubeIndices() {
    glGenBuffers(1, &m_buffer);
    glGenVertexArrays(1, &m_array);
    glBindVertexArray(m_array);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_buffer);
    glBindVertexArray(0);
}

TubeIndices::~TubeIndices() {
    glDeleteVertexArrays(1, &m_array);
    glDeleteBuffers(1, &m_buffer);
}

void TubeIndices::prepare(std::size_t nodes, int sides) {
    if (nodes <= m_nodes && sides == m_sides) {
        return;
    }
    m_nodes = nodes;
    m_sides = sides;
    const auto ring = static_cast<std::uint32_t>(sides) + 1;
    std::vector<std::uint32_t> indices;
    indices.reserve(nodes * perSegment());
    // The last vertex of a ring lies on its first, so two segments join by triangles without area.
    for (std::uint32_t node = 0; node < nodes; ++node) {
        for (std::uint32_t corner = 0; corner < ring; ++corner) {
            indices.push_back((node + 1) * ring + corner);
            indices.push_back(node * ring + corner);
        }
    }
    glBindVertexArray(m_array);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof indices[0]),
                 indices.data(), GL_STATIC_DRAW);
    glBindVertexArray(0);
}

} // namespace knittsim::render
