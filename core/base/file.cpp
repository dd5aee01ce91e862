#include "core/base/file.h"

#include "core/base/atomic_file.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

namespace knittsim {

namespace {

using FilePointer = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

Diagnostic failure(const char* id, const std::filesystem::path& path, int error) {
    return {id, Severity::Error, Place{.file = path.string()}, {std::strerror(error)}};
}

} // namespace

Result<std::string> readFile(const std::filesystem::path& path, std::size_t maxBytes) {
    std::error_code code;
    if (std::filesystem::is_directory(path, code)) {
        return failure("KS0001", path, EISDIR);
    }
    const FilePointer file(std::fopen(path.c_str(), "rb"), &std::fclose);
    if (!file) {
        return failure("KS0001", path, errno);
    }
    const Place place{.file = path.string()};
    const std::string limit = std::to_string(maxBytes);
    const std::uintmax_t size = std::filesystem::file_size(path, code);
    if (!code && size > maxBytes) {
        return Diagnostic{"KS0007", Severity::Error, place, {std::to_string(size), limit}};
    }
    std::string bytes;
    char block[65536];
    std::size_t count = 0;
    while ((count = std::fread(block, 1, sizeof block, file.get())) > 0) {
        if (bytes.size() + count > maxBytes) {
            return Diagnostic{"KS0007", Severity::Error, place, {"more than " + limit, limit}};
        }
        bytes.append(block, count);
    }
    if (std::ferror(file.get()) != 0) {
        return failure("KS0001", path, errno);
    }
    return bytes;
}

std::string lowerExtension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

std::vector<std::filesystem::path> jsonFiles(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> paths;
    std::error_code code;
    for (std::filesystem::directory_iterator entry(folder, code), end; !code && entry != end;
         entry.increment(code)) {
        const std::string name = entry->path().filename().string();
        if (name.ends_with(".json") && !name.ends_with(".schema.json")) {
            paths.push_back(entry->path());
        }
    }
    std::ranges::sort(paths);
    return paths;
}

Result<Written> writeFileAtomically(const std::filesystem::path& path, std::string_view bytes) {
    AtomicFile file(path);
    file.write(bytes);
    return file.commit();
}

} // namespace knittsim
