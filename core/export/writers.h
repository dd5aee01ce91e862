#pragma once

#include "core/export/output.h"
#include "core/export/write_shape.h"
#include "core/geometry/tube_mesh.h"

namespace knittsim::exports {

// One writer for each format; all throw Stopped, none commits.

/// `materials`: the second file of the format; `materialsName`: how `out` calls it.
void writeObj(Output& out, Output& materials, const std::string& materialsName, const Shape& shape,
              const WriteOptions& options);

/// False when the binary form would have 4 GiB or more.
bool writeGltf(Output& out, const Shape& shape, const WriteOptions& options, bool binary);

void writeBcc(Output& out, const Shape& shape);
void writeSvg(Output& out, const Shape& shape, const WriteOptions& options);
void writePointsCsv(Output& out, const Shape& shape);

/// Nodes of a yarn of the shape.
inline std::span<const Vec3f> nodesOf(const Shape& shape, const geometry::YarnCurves::Range& yarn) {
    return std::span(shape.curves.nodes)
        .subspan(static_cast<std::size_t>(yarn.first), static_cast<std::size_t>(yarn.count));
}

/// The tube of a yarn, of as many nodes as the eye can tell.
geometry::TubeMesh tubeOf(const Shape& shape, const geometry::YarnCurves::Range& yarn,
                          const WriteOptions& options);

} // namespace knittsim::exports
