#include "core/base/file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>
#include <unistd.h>

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

Result<Written> writeFileAtomically(const std::filesystem::path& wanted, std::string_view bytes) {
    // A symbolic link stays one: its target is replaced.
    std::error_code code;
    const std::filesystem::path path =
        std::filesystem::is_symlink(wanted, code) ? std::filesystem::weakly_canonical(wanted, code) : wanted;
    std::string temporary = path.string() + ".XXXXXX";
    const int descriptor = ::mkstemp(temporary.data());
    if (descriptor < 0) {
        return failure("KS0002", path, errno);
    }
    int error = 0;
    std::size_t done = 0;
    while (done < bytes.size() && error == 0) {
        const ssize_t count = ::write(descriptor, bytes.data() + done, bytes.size() - done);
        if (count < 0 && errno != EINTR) {
            error = errno;
        }
        done += count > 0 ? static_cast<std::size_t>(count) : 0;
    }
    if (error == 0 && ::fsync(descriptor) != 0) {
        error = errno;
    }
    if (::close(descriptor) != 0 && error == 0) {
        error = errno;
    }
    if (error == 0) {
        using std::filesystem::perms;
        const auto status = std::filesystem::status(path, code);
        const perms mode = std::filesystem::exists(status) ? status.permissions()
                                                           : perms::owner_read | perms::owner_write |
                                                                 perms::group_read | perms::others_read;
        std::filesystem::permissions(temporary, mode, code);
        std::filesystem::rename(temporary, path, code);
        error = code.value();
    }
    if (error != 0) {
        ::unlink(temporary.c_str());
        return failure("KS0002", path, error);
    }
    return Written{};
}

} // namespace knittsim
