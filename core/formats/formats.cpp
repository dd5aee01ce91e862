#include "core/formats/formats.h"

#include "core/base/file.h"
#include "core/base/message_table.h"
#include "core/base/text_check.h"
#include "core/formats/kcode/reader.h"
#include "core/formats/kcode/writer.h"
#include "core/formats/knitout/reader.h"
#include "core/formats/knitout/writer.h"
#include "core/formats/problems.h"
#include "core/formats/shima_dat/raster.h"
#include "core/formats/shima_dat/reader.h"
#include "core/formats/shima_dat/writer.h"
#include "core/formats/sintral/reader.h"
#include "core/formats/text.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace knittsim::formats {

namespace {

enum class Format { None, Knitout, ShimaDat, Kcode, Sintral };

struct Known {
    std::string_view mark; ///< extension, or first bytes of the file
    Format format;
    const char* name; ///< of a format that cannot be read
};

constexpr std::array kExtensions{
    Known{".k", Format::Knitout, ""},
    Known{".knitout", Format::Knitout, ""},
    Known{".dat", Format::ShimaDat, ""},
    Known{".kc", Format::Kcode, ""},
    Known{".sin", Format::Sintral, ""},
    Known{".jac", Format::None, "Stoll Jacquard without its .sin file"},
    Known{".setx", Format::None, "Stoll Setup"},
    Known{".set", Format::None, "Stoll Setup"},
    Known{".mdv", Format::None, "Stoll M1plus"},
    Known{".hpat", Format::None, "Stoll CREATE PLUS"},
    Known{".stp", Format::None, "DesignaKnit"},
    Known{".pat", Format::None, "DesignaKnit"},
    Known{".ks", Format::None, "KnitScript"},
    Known{".smobj", Format::None, "stitch mesh"},
};

constexpr std::array kSignatures{
    Known{";!knitout", Format::Knitout, ""},
    Known{"HOME\n", Format::Kcode, ""},
    Known{"HOME\r\n", Format::Kcode, ""},
    Known{"START\n", Format::Sintral, ""},
    Known{"START\r\n", Format::Sintral, ""},
    Known{"\x89PNG", Format::None, "PNG picture"},
    Known{"\xFF\xD8\xFF", Format::None, "JPEG picture"},
    Known{"GIF8", Format::None, "GIF picture"},
    Known{"BM", Format::None, "BMP picture"},
    Known{"%PDF", Format::None, "PDF document"},
    Known{"PK\x03\x04", Format::None, "ZIP archive"},
    Known{"\x1F\x8B", Format::None, "gzip archive"},
};

constexpr std::string_view kUndocumented = ".wkt";

Diagnostic failure(const char* id, const std::filesystem::path& path, std::string what) {
    return {id, Severity::Error, Place{.file = path.string()}, {std::move(what)}};
}

/// What the first bytes tell, or nothing.
std::optional<Known> knownByBytes(std::string_view bytes) {
    if (shima_dat::hasSignature(bytes)) {
        return Known{{}, Format::ShimaDat, ""};
    }
    for (const Known& known : kSignatures) {
        if (bytes.substr(0, known.mark.size()) == known.mark) {
            return known;
        }
    }
    return std::nullopt;
}

std::optional<Known> knownByExtension(const std::string& extension) {
    for (const Known& known : kExtensions) {
        if (extension == known.mark) {
            return known;
        }
    }
    return std::nullopt;
}

std::string nameOf(const std::optional<Known>& known, const std::string& extension) {
    if (known) {
        return known->name;
    }
    return extension.empty() ? "no extension, no known first bytes" : shown(extension);
}

/// The jacquard text of the same name, in small or capital letters; empty path when there is none.
std::filesystem::path jacquardBeside(std::filesystem::path path) {
    std::error_code error;
    for (const char* extension : {".jac", ".JAC", ".Jac"}) {
        if (std::filesystem::exists(path.replace_extension(extension), error)) {
            return path;
        }
    }
    return {};
}

Result<machine::Program> readSintral(std::string_view bytes, const std::filesystem::path& path) {
    const std::filesystem::path jacquard = jacquardBeside(path);
    if (jacquard.empty()) {
        return sintral::parse({bytes, path.string()}, {});
    }
    const Result<std::string> text = readFile(jacquard);
    if (!text) {
        return Result<machine::Program>::failure(text.diagnostics());
    }
    if (auto reason = whyNotText(text.value(), jacquard.string())) {
        return std::move(*reason);
    }
    return sintral::parse({bytes, path.string()}, {text.value(), jacquard.string()});
}

const char* describe(Format format) {
    switch (format) {
    case Format::Knitout:
        return "a knitout program";
    case Format::Kcode:
        return "Kniterate k-code";
    case Format::Sintral:
        return "a Stoll Sintral program";
    case Format::ShimaDat:
    case Format::None:
        break;
    }
    return "a Shima DAT picture";
}

Result<machine::Program> readAs(Format format, std::string_view bytes, const std::filesystem::path& path) {
    if (format != Format::ShimaDat) {
        if (auto reason = whyNotText(bytes, path.string())) {
            return std::move(*reason);
        }
    }
    switch (format) {
    case Format::Knitout:
        return knitout::parse(bytes, path.string());
    case Format::Kcode:
        return kcode::parse(bytes, path.string());
    case Format::Sintral:
        return readSintral(bytes, path);
    case Format::ShimaDat:
    case Format::None:
        break;
    }
    return shima_dat::parse(bytes, path.string());
}

/// For a file of which only its name says that it is of this format: errors without the warnings beside them,
/// and one finding instead of a list that is full.
Result<machine::Program> inShort(Result<machine::Program> result, Format format) {
    if (result) {
        return result;
    }
    Diagnostics errors = result.diagnostics();
    std::erase_if(errors, [](const Diagnostic& d) { return d.severity != Severity::Error; });
    if (std::ranges::count(errors, "KS0115", &Diagnostic::id) > 0) {
        const std::string first = causeText(errors.front());
        errors = {{"KS0127",
                   Severity::Error,
                   errors.front().place,
                   {describe(format), std::to_string(kMaxErrors), first}}};
    }
    return Result<machine::Program>::failure(std::move(errors));
}

} // namespace

Result<machine::Program> readProgram(const std::filesystem::path& path) {
    const Result<std::string> file = readFile(path);
    if (!file) {
        return Result<machine::Program>::failure(file.diagnostics());
    }
    const std::string_view bytes = file.value();
    const std::string extension = lowerExtension(path);
    std::optional<Known> known = knownByBytes(withoutByteOrderMark(bytes));
    const bool certain = known.has_value();
    if (!known && extension == kUndocumented) {
        return failure("KS0020", path, "WKT");
    }
    if (!known) {
        known = knownByExtension(extension);
    }
    if (!known || known->format == Format::None) {
        return failure("KS0006", path, nameOf(known, extension));
    }
    Result<machine::Program> result = readAs(known->format, bytes, path);
    return certain ? std::move(result) : inShort(std::move(result), known->format);
}

Result<std::string> writeProgram(const machine::Program& program, const std::filesystem::path& path) {
    const std::string extension = lowerExtension(path);
    const std::optional<Known> known = knownByExtension(extension);
    switch (known ? known->format : Format::None) {
    case Format::Knitout:
        return knitout::write(program);
    case Format::ShimaDat:
        return shima_dat::write(program);
    case Format::Kcode:
        return kcode::write(program, path.filename().string());
    case Format::Sintral:
    case Format::None:
        break;
    }
    return failure("KS0021", path, extension.empty() ? "no extension" : shown(extension));
}

} // namespace knittsim::formats
