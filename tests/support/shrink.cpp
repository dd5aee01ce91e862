#include "tests/support/shrink.h"

#include "core/formats/knitout/writer.h"
#include "core/machine/timeline.h"

#include <algorithm>

namespace knittsim::test {

using machine::OperationIndex;
using machine::Program;

namespace {

Program without(const Program& program, OperationIndex first, OperationIndex count) {
    Program smaller = program;
    const auto begin = smaller.operations.begin() + first;
    smaller.operations.erase(begin, begin + count);
    return smaller;
}

class Shrinker {
public:
    Shrinker(Program program, const std::function<bool(const Program&)>& fails)
        : m_program(std::move(program)), m_fails(fails) {}

    Program run() {
        bool smaller = true;
        while (smaller) {
            smaller = removePasses();
            for (OperationIndex size = size0(); size > 0; size /= 2) {
                smaller = removeRuns(size) || smaller;
            }
        }
        return std::move(m_program);
    }

private:
    OperationIndex count() const { return static_cast<OperationIndex>(m_program.operations.size()); }
    OperationIndex size0() const { return std::max(1, count() / 2); }

    bool tryWithout(OperationIndex first, OperationIndex size) {
        Program smaller = without(m_program, first, size);
        if (!isValid(smaller) || !m_fails(smaller)) {
            return false;
        }
        m_program = std::move(smaller);
        return true;
    }

    /// From the end, so that the passes before keep their places.
    bool removePasses() {
        bool any = false;
        const std::vector<machine::Pass> passes = machine::findPasses(m_program);
        for (auto pass = passes.rbegin(); pass != passes.rend(); ++pass) {
            any = tryWithout(pass->first, pass->count) || any;
        }
        return any;
    }

    bool removeRuns(OperationIndex size) {
        bool any = false;
        for (OperationIndex first = std::max(0, count() - size); first >= 0; first -= size) {
            if (first + size <= count()) {
                any = tryWithout(first, size) || any;
            }
        }
        return any;
    }

    Program m_program;
    const std::function<bool(const Program&)>& m_fails;
};

} // namespace

bool isValid(const Program& program) {
    const machine::Timeline timeline(program, machine::genericProfile());
    return std::ranges::none_of(timeline.diagnostics(),
                                [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

Program shrink(Program program, const std::function<bool(const Program&)>& fails) {
    return Shrinker(std::move(program), fails).run();
}

std::string explainFailure(const Program& program, const Property& property) {
    if (property(program).empty()) {
        return {};
    }
    const Program least = shrink(program, [&](const Program& p) { return !property(p).empty(); });
    return property(least) + "\nThe smallest program that fails:\n" + formats::knitout::write(least);
}

} // namespace knittsim::test
