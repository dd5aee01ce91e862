#include "core/pattern/compile.h"

#include "core/pattern/course_compiler.h"

namespace knittsim::pattern {

Result<Compiled> compileCourses(const Chart& chart, const CompileOptions& options) {
    Diagnostics problems = check(chart);
    if (!problems.empty()) {
        return Result<Compiled>::failure(std::move(problems));
    }
    CourseCompiler compiler(chart, options);
    std::vector<machine::OperationIndex> ends;
    if (compiler.problems().empty()) {
        compiler.begin();
        for (int course = 0; course < chart.height(); ++course) {
            compiler.knit(course);
            ends.push_back(static_cast<machine::OperationIndex>(compiler.program().operations.size()));
        }
        compiler.end();
    }
    if (!compiler.problems().empty()) {
        return Result<Compiled>::failure(compiler.problems());
    }
    return Compiled{compiler.takeProgram(), std::move(ends)};
}

Result<machine::Program> compile(const Chart& chart, const CompileOptions& options) {
    Result<Compiled> compiled = compileCourses(chart, options);
    if (!compiled) {
        return Result<machine::Program>::failure(compiled.diagnostics());
    }
    return std::move(compiled.value().program);
}

} // namespace knittsim::pattern
