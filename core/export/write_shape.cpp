#include "core/export/write_shape.h"

#include "core/base/file.h"
#include "core/export/writers.h"

#include <algorithm>
#include <array>
#include <bit>

static_assert(std::endian::native == std::endian::little, "binary formats are written as they lie in memory");

namespace knittsim::exports {

namespace {

struct Extension {
    std::string_view text;
    Format format;
};
constexpr std::array kExtensions{Extension{".obj", Format::Obj}, Extension{".gltf", Format::Gltf},
                                 Extension{".glb", Format::Glb}, Extension{".bcc", Format::Bcc},
                                 Extension{".svg", Format::Svg}, Extension{".csv", Format::Csv}};

constexpr float kTubeTolerance = 0.08F; ///< radii

Diagnostic failure(const char* id, const std::filesystem::path& path,
                   std::vector<std::string> arguments = {}) {
    return {.id = id, .place = {.file = path.string()}, .arguments = std::move(arguments)};
}

/// Both files or none.
Result<Written> writeObjFiles(Output& out, const std::filesystem::path& path, const Shape& shape,
                              const WriteOptions& options, const Progress& progress) {
    const std::filesystem::path materialsPath = std::filesystem::path(path).replace_extension(".mtl");
    Output materials(materialsPath, progress);
    writeObj(out, materials, materialsPath.filename().string(), shape, options);
    return Output::commitBoth(materials, out);
}

Result<Written> write(Output& out, const std::filesystem::path& path, Format format, const Shape& shape,
                      const WriteOptions& options, const Progress& progress) {
    switch (format) {
    case Format::Obj:
        return writeObjFiles(out, path, shape, options, progress);
    case Format::Gltf:
    case Format::Glb:
        if (!writeGltf(out, shape, options, format == Format::Glb)) {
            return failure("KS0023", path, {"4 GiB"});
        }
        break;
    case Format::Bcc:
        writeBcc(out, shape);
        break;
    case Format::Svg:
        writeSvg(out, shape, options);
        break;
    case Format::Csv:
        writePointsCsv(out, shape);
        break;
    }
    return out.commit();
}

} // namespace

std::optional<Format> formatOf(const std::filesystem::path& path) {
    const std::string extension = lowerExtension(path);
    const auto* found = std::ranges::find(kExtensions, extension, &Extension::text);
    return found != kExtensions.end() ? std::optional(found->format) : std::nullopt;
}

geometry::TubeMesh tubeOf(const Shape& shape, const geometry::YarnCurves::Range& yarn,
                          const WriteOptions& options) {
    const auto radius = 0.5F * static_cast<float>(shape.materials[yarn.carrier].diameterMm);
    return geometry::makeTube(geometry::thinned(nodesOf(shape, yarn), kTubeTolerance * radius), radius,
                              options.sides);
}

Result<Written> writeShape(const std::filesystem::path& path, const Shape& shape, const WriteOptions& options,
                           const Progress& progress) {
    const std::optional<Format> format = formatOf(path);
    if (!format) {
        return failure("KS0022", path, {path.extension().string()});
    }
    Output out(path, progress);
    try {
        return write(out, path, *format, shape, options, progress);
    } catch (const Stopped&) {
        return out.cancelled() ? failure("KS0009", path) : out.commit(); // which says what is wrong
    }
}

} // namespace knittsim::exports
