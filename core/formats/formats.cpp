#include "core/formats/formats.h"

#include "core/base/file.h"
#include "core/formats/knitout/reader.h"
#include "core/formats/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace knittsim::formats {

namespace {

struct Known {
    std::string_view mark; ///< extension, or first bytes of the file
    const char* name;
};

constexpr std::array<std::string_view, 2> kKnitoutExtensions{".k", ".knitout"};

constexpr std::array kOtherExtensions{
    Known{".dat", "Shima DAT"},      Known{".kc", "Kniterate k-code"},    Known{".sin", "Stoll Sintral"},
    Known{".jac", "Stoll Jacquard"}, Known{".setx", "Stoll Setup"},       Known{".set", "Stoll Setup"},
    Known{".mdv", "Stoll M1plus"},   Known{".hpat", "Stoll CREATE PLUS"}, Known{".stp", "DesignaKnit"},
    Known{".pat", "DesignaKnit"},    Known{".ks", "KnitScript"},          Known{".smobj", "stitch mesh"},
};

constexpr std::array kSignatures{
    Known{"\x89PNG", "PNG picture"},   Known{"\xFF\xD8\xFF", "JPEG picture"},
    Known{"GIF8", "GIF picture"},      Known{"BM", "BMP picture"},
    Known{"%PDF", "PDF document"},     Known{"PK\x03\x04", "ZIP archive"},
    Known{"\x1F\x8B", "gzip archive"}, Known{"HOME\n", "Kniterate k-code"},
};

constexpr std::string_view kMagic = ";!knitout";

std::string lowerExtension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

/// Shima DAT: two little-endian numbers of fixed value at 8 and 16, and a header and palette of 0x600 bytes.
bool looksLikeShimaDat(std::string_view bytes) {
    constexpr std::string_view kThousand("\xE8\x03", 2);
    return bytes.size() > 0x600 && bytes.substr(8, 2) == kThousand && bytes.substr(16, 2) == kThousand;
}

/// Name of a foreign format that the first bytes tell, or nothing.
std::string nameByBytes(std::string_view bytes) {
    if (looksLikeShimaDat(bytes)) {
        return "Shima DAT";
    }
    for (const Known& known : kSignatures) {
        if (bytes.substr(0, known.mark.size()) == known.mark) {
            return known.name;
        }
    }
    return {};
}

std::string nameByExtension(const std::string& extension) {
    for (const Known& known : kOtherExtensions) {
        if (extension == known.mark) {
            return known.name;
        }
    }
    return extension.empty() ? "no extension, no known first bytes" : shown(extension);
}

} // namespace

Result<machine::Program> readProgram(const std::filesystem::path& path) {
    const Result<std::string> file = readFile(path);
    if (!file) {
        return Result<machine::Program>::failure(file.diagnostics());
    }
    const std::string_view bytes = file.value();
    const std::string extension = lowerExtension(path);
    std::string foreign = nameByBytes(bytes);
    const bool named = std::find(kKnitoutExtensions.begin(), kKnitoutExtensions.end(), extension) !=
                       kKnitoutExtensions.end();
    if (foreign.empty() && (named || bytes.substr(0, kMagic.size()) == kMagic)) {
        return knitout::parse(bytes, path.string());
    }
    if (foreign.empty()) {
        foreign = nameByExtension(extension);
    }
    return Diagnostic{"KS0006", Severity::Error, Place{.file = path.string()}, {std::move(foreign)}};
}

} // namespace knittsim::formats
