#include "core/base/message_table.h"
#include "core/pattern/project.h"
#include "tests/fuzz/checks.h"

#include <cstdint>
#include <string_view>

/// Any bytes: a project file gives findings or a chart, which is the same when it is written and read again,
/// and whose program, where it has one, can be knitted.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace knittsim;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    std::vector<float> shape;
    const auto project = pattern::readProject(bytes, "fuzz.knitt", &shape);
    for (const Diagnostic& problem : project.diagnostics()) {
        test::require(findMessage(problem.id) != nullptr, problem.id + " is in the table");
    }
    test::require(project || !project.diagnostics().empty(), "what is not read has a reason");
    if (!project) {
        return 0;
    }
    const std::string text = pattern::writeProject(project.value(), {.shape = shape});
    std::vector<float> sameShape;
    const auto again = pattern::readProject(text, "again.knitt", &sameShape);
    test::require(again.hasValue(), "written text opens:\n" + text);
    test::require(again.value() == project.value(), "round trip:\n" + text);
    test::require(sameShape.size() == shape.size(), "round trip of the shape");
    auto program = pattern::compile(project.value().chart, {.firstNeedle = project.value().firstNeedle});
    if (program) {
        test::checkMachineAndFabric(std::move(program).value());
    }
    return 0;
}
