#include "tests/support/compare_programs.h"

#include <algorithm>

namespace knittsim::test {

namespace {

std::string textOf(const machine::Program& program, const machine::Operation& op) {
    return op.text < 0 ? std::string() : program.texts[static_cast<std::size_t>(op.text)];
}

bool sameOperation(const machine::Program& a, const machine::Program& b, std::size_t index) {
    machine::Operation left = a.operations[index];
    machine::Operation right = b.operations[index];
    if (textOf(a, left) != textOf(b, right)) {
        return false;
    }
    left.line = right.line = -1;
    left.text = right.text = -1;
    return left == right;
}

} // namespace

std::string difference(const machine::Program& a, const machine::Program& b) {
    if (!(a.header == b.header)) {
        return "headers differ";
    }
    if (a.sourceComments != b.sourceComments) {
        return "source comments differ";
    }
    const std::size_t common = std::min(a.operations.size(), b.operations.size());
    for (std::size_t i = 0; i < common; ++i) {
        if (!sameOperation(a, b, i)) {
            return "operation " + std::to_string(i) + " differs (" + machine::toString(a.operations[i].kind) +
                   ", " + machine::toString(b.operations[i].kind) + ")";
        }
    }
    if (a.operations.size() != b.operations.size()) {
        return std::to_string(a.operations.size()) + " and " + std::to_string(b.operations.size()) +
               " operations";
    }
    return {};
}

} // namespace knittsim::test
