#include "core/base/file.h"
#include "core/base/message_table.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

/// Runs a fuzz target over every file of the folders and files named, without a fuzzer.
int main(int argumentCount, char** arguments) {
    namespace fs = std::filesystem;
    std::vector<fs::path> files;
    for (int i = 1; i < argumentCount; ++i) {
        if (!fs::is_directory(arguments[i])) {
            files.emplace_back(arguments[i]);
            continue;
        }
        for (const auto& entry : fs::recursive_directory_iterator(arguments[i])) {
            if (entry.is_regular_file()) {
                files.push_back(entry.path());
            }
        }
    }
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
        const auto bytes = knittsim::readFile(file);
        if (!bytes) {
            std::fprintf(stderr, "%s\n", knittsim::toLine(bytes.diagnostics().front()).c_str());
            return 2;
        }
        std::printf("%s\n", file.c_str());
        std::fflush(stdout);
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.value().data()),
                               bytes.value().size());
    }
    std::printf("%zu files\n", files.size());
    return files.empty() ? 2 : 0;
}
