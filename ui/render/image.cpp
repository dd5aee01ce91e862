#include "ui/render/image.h"

#include <cstring>
#include <png.h>

namespace knittsim::render {

namespace {

Diagnostic failure(std::string_view id, const std::filesystem::path& path, std::string reason) {
    return {.id = std::string(id), .place = {.file = path.string()}, .arguments = {std::move(reason)}};
}

png_image describe(const Image& image) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = PNG_FORMAT_RGBA;
    return png;
}

} // namespace

Result<std::string> encodePng(const Image& image) {
    png_image png = describe(image);
    png_alloc_size_t size = 0;
    if (image.pixels.empty() ||
        !png_image_write_get_memory_size(png, size, 0, image.pixels.data(), 0, nullptr)) {
        return failure("KS0404", {}, image.pixels.empty() ? "it has no pixels" : png.message);
    }
    std::string bytes(size, '\0');
    if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr)) {
        return failure("KS0404", {}, png.message);
    }
    bytes.resize(size);
    return bytes;
}

Result<Written> writePng(const std::filesystem::path& path, const Image& image) {
    const Result<std::string> bytes = encodePng(image);
    if (!bytes) {
        return Result<Written>::failure(bytes.diagnostics());
    }
    return writeFileAtomically(path, bytes.value());
}

Result<Image> readPng(const std::filesystem::path& path) {
    const Result<std::string> bytes = readFile(path);
    if (!bytes) {
        return Result<Image>::failure(bytes.diagnostics());
    }
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_memory(&png, bytes->data(), bytes->size())) {
        return failure("KS0405", path, png.message);
    }
    png.format = PNG_FORMAT_RGBA;
    Image image{static_cast<int>(png.width), static_cast<int>(png.height), {}};
    image.pixels.resize(PNG_IMAGE_SIZE(png));
    if (!png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr)) {
        return failure("KS0405", path, png.message);
    }
    return image;
}

} // namespace knittsim::render
