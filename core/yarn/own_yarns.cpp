#include "core/yarn/own_yarns.h"

#include "core/base/file.h"
#include "core/yarn/yarn_library.h"

#include <system_error>

namespace knittsim::yarn {

namespace {

std::filesystem::path fileOf(const std::filesystem::path& folder, std::string_view id) {
    return folder / (idOf(id) + ".json");
}

} // namespace

std::string idOf(std::string_view name) {
    std::string id;
    for (const char c : name) {
        const bool capital = c >= 'A' && c <= 'Z';
        if (capital || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) {
            id += capital ? static_cast<char>(c - 'A' + 'a') : c;
        } else if (!id.empty() && id.back() != '-') {
            id += '-';
        }
    }
    while (!id.empty() && id.back() == '-') {
        id.pop_back();
    }
    return id.empty() ? "yarn" : id.substr(0, 60);
}

Diagnostics keepYarn(const std::filesystem::path& folder, const Yarn& yarn) {
    std::error_code ignored; // writing tells what is wrong
    std::filesystem::create_directories(folder, ignored);
    return writeFileAtomically(fileOf(folder, yarn.id), toJson(yarn)).diagnostics();
}

Result<std::vector<Yarn>> importYarns(const std::filesystem::path& file,
                                      const std::filesystem::path& folder) {
    Result<std::vector<Yarn>> read = readYarns(file);
    if (!read) {
        return read;
    }
    std::vector<Yarn> yarns = std::move(read).value();
    for (Yarn& yarn : yarns) {
        const std::string id = idOf(yarn.id);
        yarn.id = id;
        for (int i = 2; isOwn(folder, yarn.id); ++i) {
            yarn.id = id + '-' + std::to_string(i);
        }
        Diagnostics problems = keepYarn(folder, yarn);
        if (hasErrors(problems)) {
            return Result<std::vector<Yarn>>::failure(std::move(problems));
        }
    }
    return yarns;
}

bool isOwn(const std::filesystem::path& folder, std::string_view id) {
    std::error_code ignored;
    return std::filesystem::exists(fileOf(folder, id), ignored);
}

void forgetYarn(const std::filesystem::path& folder, std::string_view id) {
    std::error_code ignored;
    std::filesystem::remove(fileOf(folder, id), ignored);
}

} // namespace knittsim::yarn
