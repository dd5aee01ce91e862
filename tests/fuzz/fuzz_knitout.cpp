#include "core/formats/knitout/reader.h"
#include "tests/fuzz/checks.h"

#include <cstdint>
#include <string_view>

/// Any bytes: the reader gives findings or a program; every program survives writing, the machine and the
/// fabric.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace knittsim;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    auto result = formats::knitout::parse(text, "fuzz.k");
    test::checkReading(result);
    if (result) {
        test::checkWriters(result.value());
        test::checkMachineAndFabric(std::move(result).value());
    }
    return 0;
}
