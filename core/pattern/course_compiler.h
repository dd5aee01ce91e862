#pragma once

#include "core/pattern/compile.h"
#include "core/pattern/feeds.h"
#include "core/pattern/program_course.h"

#include <functional>

namespace knittsim::pattern {

/// Makes the program of a chart, course by course from the first one: begin(), knit() of each, end(). Whoever
/// calls it may change a course before it is knitted. The chart must be well formed (check()); both must
/// outlive the compiler.
class CourseCompiler {
public:
    CourseCompiler(const Chart& chart, const CompileOptions& options);

    const Diagnostics& problems() const { return m_problems; }
    const machine::Program& program() const { return m_program; }
    machine::Program takeProgram() { return std::move(m_program); }
    const HeldLoops& held() const { return m_held; }
    const Feeds& feeds() const { return m_feeds; }
    double rack() const { return m_builder.setting().rack; }

    void begin(); ///< header and colours
    void knit(int course);
    void end();

    /// The state between two courses, to come back to.
    struct Mark {
        HeldLoops held;
        Feeds feeds;
        ProgramBuilder::Setting setting;
        std::size_t operations = 0;
        std::size_t texts = 0;
        std::size_t problems = 0;
    };
    Mark mark() const;
    void rewind(const Mark& mark);

private:
    void knitAsInProgram(int course);
    void moveLoops(int course, const std::vector<LoopMove>& moves);
    bool canMove(int course, const std::vector<LoopMove>& moves);
    void dropLoops(int course);
    void dropWhere(const std::function<bool(int wale)>& falls);
    void checkEmpty(int course);
    void prepareBeds(int course);
    void knitCourse(int course);
    void sortZones(std::vector<int>& yarns, int course) const;
    void checkRack(int course, double rack);
    void report(const char* id, int course, int wale, std::vector<std::string> arguments);

    const Chart& m_chart;
    const CompileOptions& m_options;
    Diagnostics m_problems;
    Feeds m_feeds;
    HeldLoops m_held;
    machine::Program m_program;
    ProgramBuilder m_builder;
};

} // namespace knittsim::pattern
