#pragma once

#include "core/base/file.h"
#include "core/export/shape.h"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace knittsim::exports {

enum class Format : std::uint8_t {
    Obj,  ///< Wavefront OBJ with its MTL beside it
    Gltf, ///< glTF 2.0, one text file
    Glb,  ///< glTF 2.0, one binary file
    Bcc,  ///< yarn curves
    Svg,  ///< three strokes, mm
    Csv,  ///< bonding points
};

struct WriteOptions {
    int sides = 8;     ///< of a tube
    bool back = false; ///< the drawing shows the technical back
};

/// By extension, upper or lower case; nothing for others.
std::optional<Format> formatOf(const std::filesystem::path& path);

/// Writes a shape; the extension of `path` chooses the format. Cancelled or failed, no file is left or
/// changed. Errors: KS0002, KS0009 (cancelled), KS0022 (format), KS0023 (too large for the format).
Result<Written> writeShape(const std::filesystem::path& path, const Shape& shape,
                           const WriteOptions& options = {}, const Progress& progress = {});

} // namespace knittsim::exports
