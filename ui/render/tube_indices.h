#pragma once

#include <cstddef>
#include <cstdint>

namespace knittsim::render {

/// Index buffer that joins rings of `sides` + 1 vertices to tubes. A piece of yarn is one triangle strip: its
/// segment from node n to n + 1 takes the indices [perSegment() n, perSegment() (n + 1)).
class TubeIndices {
public:
    TubeIndices();
    ~TubeIndices();
    TubeIndices(const TubeIndices&) = delete;
    TubeIndices& operator=(const TubeIndices&) = delete;

    /// Makes room for this many nodes and sides; does nothing when it fits already.
    void prepare(std::size_t nodes, int sides);

    std::size_t perSegment() const { return 2 * (static_cast<std::size_t>(m_sides) + 1); }

    /// Vertex array that has the buffer as its index buffer and no attributes.
    unsigned array() const { return m_array; }

private:
    std::size_t m_nodes = 0;
    int m_sides = 0;
    unsigned m_buffer = 0;
    unsigned m_array = 0;
};

} // namespace knittsim::render
