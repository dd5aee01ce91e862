#include "core/base/file.h"
#include "core/base/message_table.h"
#include "core/pattern/samples.h"

#include <cstdio>
#include <filesystem>

/// knittsim-make-samples FOLDER: writes FOLDER/ID.k for every sample.
int main(int count, char** arguments) {
    if (count != 2) {
        std::fprintf(stderr, "usage: knittsim-make-samples FOLDER\n");
        return 2;
    }
    const std::filesystem::path folder = arguments[1];
    for (const knittsim::pattern::Sample& sample : knittsim::pattern::samples()) {
        const auto written = knittsim::writeFileAtomically(folder / (sample.id + ".k"),
                                                           knittsim::pattern::sampleText(sample.id));
        for (const knittsim::Diagnostic& diagnostic : written.diagnostics()) {
            std::fprintf(stderr, "%s\n", knittsim::toLine(diagnostic).c_str());
        }
        if (!written) {
            return 2;
        }
    }
    return 0;
}
