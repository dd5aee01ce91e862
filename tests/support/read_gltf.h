#pragma once

#include "tests/support/surface.h"

#include <nlohmann/json.hpp>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace knittsim::test {

/// One triangle mesh of a glTF file.
struct GltfMesh {
    Surface surface; ///< as written, before the node's scale
    std::array<double, 4> colour{};
};

/// A glTF 2.0 file, read after the specification, and where it breaks its rules: chunks and padding, sizes,
/// alignment and targets of buffer views, accessors inside their views with true bounds, normals of unit
/// length, corners inside the mesh, no number that is not finite, no reference into nothing, no empty list.
struct GltfFile {
    nlohmann::json json;
    std::string buffer;
    std::vector<GltfMesh> meshes;
    std::vector<std::string> faults; ///< empty: the file is valid as far as this goes
};

GltfFile readGlb(std::string_view bytes);
GltfFile readGltf(std::string_view text); ///< with the buffer inside, as base64

} // namespace knittsim::test
