#include "core/formats/shima_dat/reader.h"
#include "tests/fuzz/checks.h"

#include <cstdint>
#include <string_view>

/// Any bytes: the reader gives findings or a program, which survives writing and the machine.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace knittsim;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    auto result = formats::shima_dat::parse(bytes, "fuzz.dat");
    test::checkReading(result);
    if (result) {
        test::checkWriters(result.value());
        test::checkMachineAndFabric(std::move(result).value());
    }
    return 0;
}
