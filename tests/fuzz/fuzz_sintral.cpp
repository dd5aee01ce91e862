#include "core/formats/sintral/reader.h"
#include "tests/fuzz/checks.h"

#include <cstdint>
#include <string_view>

/// Any bytes, of which those behind the first '@' are the jacquard text: the reader gives findings or a
/// program, which survives writing and the machine. Programs that repeat themselves to a great length are
/// only read.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace knittsim;
    constexpr std::size_t kLongest = 20'000;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const std::size_t at = bytes.find('@');
    const std::string_view jacquard =
        at == std::string_view::npos ? std::string_view() : bytes.substr(at + 1);
    auto result = formats::sintral::parse({bytes.substr(0, at), "fuzz.sin"}, {jacquard, "fuzz.jac"});
    test::checkReading(result);
    if (result && result.value().operations.size() < kLongest) {
        test::checkWriters(result.value());
        test::checkMachineAndFabric(std::move(result).value());
    }
    return 0;
}
