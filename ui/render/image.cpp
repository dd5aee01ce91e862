#include "ui/render/image.h"

#include "core/base/atomic_file.h"

#include <csetjmp>
#include <cstring>
#include <png.h>

namespace knittsim::render {

namespace {

Diagnostic failure(std::string_view id, const std::filesystem::path& path, std::string reason) {
    return {.id = std::string(id), .place = {.file = path.string()}, .arguments = {std::move(reason)}};
}

/// What libpng hands from call to call.
struct Job {
    AtomicFile& file;
    std::string error;
};

extern "C" {
void writeBytes(png_structp png, png_bytep bytes, png_size_t count) {
    static_cast<Job*>(png_get_io_ptr(png))->file.write({reinterpret_cast<const char*>(bytes), count});
}
void flushNothing(png_structp) {}
[[noreturn]] void takeError(png_structp png, png_const_charp message) {
    static_cast<Job*>(png_get_error_ptr(png))->error = message;
    png_longjmp(png, 1);
}
void dropWarning(png_structp, png_const_charp) {}
}

enum class Outcome : std::uint8_t { Done, Failed, Cancelled };

/// Jumps out of libpng on errors, so nothing here may need a destructor.
Outcome writeRows(png_structp png, png_infop info, const Image& image, const Progress& progress) {
    if (setjmp(png_jmpbuf(png)) != 0) {
        return Outcome::Failed;
    }
    constexpr int kRowsBetweenReports = 64;
    constexpr int kFast = 3; // of 9: hardly larger, three times as fast
    png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
                 PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_compression_level(png, kFast);
    png_write_info(png, info);
    for (int y = 0; y < image.height; ++y) {
        if (y % kRowsBetweenReports == 0 && progress &&
            !progress(static_cast<double>(y) / static_cast<double>(image.height))) {
            return Outcome::Cancelled;
        }
        png_write_row(png, image.at(0, y));
    }
    png_write_end(png, info);
    return Outcome::Done;
}

} // namespace

Result<Written> writePng(const std::filesystem::path& path, const Image& image, const Progress& progress) {
    if (image.pixels.empty()) {
        return failure("KS0404", {}, "it has no pixels");
    }
    AtomicFile file(path);
    Job job{file, {}};
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &job, takeError, dropWarning);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    Outcome outcome = Outcome::Failed;
    if (info != nullptr) {
        png_set_write_fn(png, &job, writeBytes, flushNothing);
        outcome = writeRows(png, info, image, progress);
    }
    png_destroy_write_struct(&png, &info);
    switch (outcome) {
    case Outcome::Done:
        break;
    case Outcome::Failed:
        return failure("KS0404", path, job.error);
    case Outcome::Cancelled:
        return Diagnostic{.id = "KS0009", .place = {.file = path.string()}, .arguments = {}};
    }
    return file.commit();
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
