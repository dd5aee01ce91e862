#include "core/pattern/compile.h"

#include "core/pattern/cast_on.h"

#include <fmt/format.h>

#include <algorithm>

namespace knittsim::pattern {

namespace {

using machine::Bed;
using machine::Program;

class Compiler {
public:
    Compiler(const Chart& chart, const CompileOptions& options)
        : m_chart(chart), m_options(options), m_feeds(chart, options.machine, m_problems),
          m_held(chart.width), m_builder(m_program, options.firstNeedle) {}

    Result<Compiled> run();

private:
    void writeHeader();
    void moveLoops(int course);
    void prepareBeds(int course);
    void knitCourse(int course);
    void sortZones(std::vector<int>& yarns, int course) const;
    void drop();

    bool canMove(int course);
    void checkRack(int course, double rack);
    void report(const char* id, int course, int wale, std::vector<std::string> arguments);

    const Chart& m_chart;
    const CompileOptions& m_options;
    Diagnostics m_problems;
    Feeds m_feeds;
    HeldLoops m_held;
    Program m_program;
    ProgramBuilder m_builder;
    std::vector<machine::OperationIndex> m_courseEnds;
};

Result<Compiled> Compiler::run() {
    if (!m_problems.empty()) {
        return Result<Compiled>::failure(m_problems);
    }
    writeHeader();
    for (int course = 0; course < m_chart.height(); ++course) {
        if (const auto number = m_chart.course(course).stitchNumber) {
            m_builder.stitchNumber(*number);
        }
        if (course == 0 && m_options.castOn == CastOn::Alternating) {
            castOnAlternating(m_chart, m_feeds, m_held, m_builder);
        }
        moveLoops(course);
        prepareBeds(course);
        knitCourse(course);
        m_feeds.takeOut(course, m_builder);
        m_courseEnds.push_back(static_cast<machine::OperationIndex>(m_program.operations.size()));
    }
    m_builder.rack(0);
    if (m_options.ending == Ending::Dropped) {
        drop();
    }
    if (!m_problems.empty()) {
        return Result<Compiled>::failure(m_problems);
    }
    return Compiled{std::move(m_program), std::move(m_courseEnds)};
}

void Compiler::writeHeader() {
    machine::Header& header = m_program.header;
    header.machine = m_options.machine.id;
    header.gauge = m_options.machine.gauge;
    header.position = "Center";
    for (const std::string& name : m_options.machine.carriers) {
        header.carriers.push_back({name, static_cast<int>(header.carriers.size()), false, ""});
    }
    for (std::size_t y = 0; y < m_chart.yarns.size(); ++y) {
        const ChartYarn& yarn = m_chart.yarns[y];
        const machine::CarrierIndex carrier = m_feeds.carrier(static_cast<int>(y));
        header.carriers[carrier].yarn = yarn.libraryId;
        m_builder.colour(carrier, yarn.colour);
    }
}

void Compiler::moveLoops(int course) {
    if (canMove(course)) {
        m_held.move(m_chart.course(course).moves, m_builder);
    }
}

bool Compiler::canMove(int course) {
    const std::size_t before = m_problems.size();
    for (const LoopMove& move : m_chart.course(course).moves) {
        if (!m_held.any(move.from)) {
            report("KS0506", course, move.from, {std::to_string(move.from)});
        }
        checkRack(course, move.to - move.from);
    }
    return m_problems.size() == before;
}

void Compiler::prepareBeds(int course) {
    for (int wale = 0; wale < m_chart.width; ++wale) {
        if (m_chart.at(wale, course).stitch == Stitch::Empty && m_held.any(wale)) {
            report("KS0508", course, wale, {std::to_string(wale)});
        }
    }
    if (m_chart.beds == BedUse::Double) {
        return;
    }
    for (const auto& [stitch, bed] :
         {std::pair(Stitch::Purl, Bed::Rear), std::pair(Stitch::Knit, Bed::Front)}) {
        for (int wale = 0; wale < m_chart.width; ++wale) {
            if (m_chart.at(wale, course).stitch == stitch) {
                m_held.toBed(wale, bed, m_builder);
            }
        }
    }
}

void Compiler::knitCourse(int course) {
    const double rack = rackOf(m_chart, course);
    checkRack(course, rack);
    m_builder.rack(rack);
    std::vector<int> yarns = yarnsOf(m_chart, course);
    const bool intarsia = m_chart.course(course).colours == ColourMethod::Intarsia;
    if (intarsia) {
        sortZones(yarns, course);
    }
    for (const int yarn : yarns) {
        std::vector<Work> works = worksOf(m_chart, course, yarn, m_held);
        if (intarsia) {
            addJoin(works, m_chart, course, m_feeds.next(yarn), m_held);
        }
        for (const Work& work : works) {
            if (makesLoop(work.kind)) {
                m_held.add(work.needle);
            }
        }
        m_feeds.pass(yarn, std::move(works), m_builder);
        m_feeds.release(yarn, m_builder);
    }
}

/// Zones in the way the carriers go, so that a yarn tucks on a wale before the next yarn knits it.
void Compiler::sortZones(std::vector<int>& yarns, int course) const {
    std::ranges::sort(yarns, {}, [&](int yarn) {
        const int direction = sign(m_feeds.next(yarn));
        return std::pair(direction, direction * firstWaleOf(m_chart, course, yarn));
    });
}

void Compiler::drop() {
    for (const Bed bed : {Bed::Front, Bed::Rear}) {
        for (int wale = 0; wale < m_chart.width; ++wale) {
            if (m_held.has(bed, wale)) {
                m_builder.drop({bed, wale});
            }
        }
    }
}

void Compiler::checkRack(int course, double rack) {
    const machine::MachineProfile& machine = m_options.machine;
    if (rack < machine.minRack || rack > machine.maxRack) {
        report("KS0507", course, -1,
               {fmt::format("{}", rack), fmt::format("{}", machine.minRack),
                fmt::format("{}", machine.maxRack)});
    }
}

void Compiler::report(const char* id, int course, int wale, std::vector<std::string> arguments) {
    Place place{.course = course};
    if (wale >= 0) {
        place.needle = toString(machine::Needle{Bed::Front, wale + m_options.firstNeedle});
    }
    m_problems.push_back({id, Severity::Error, std::move(place), std::move(arguments)});
}

} // namespace

Result<Compiled> compileCourses(const Chart& chart, const CompileOptions& options) {
    Diagnostics problems = check(chart);
    if (!problems.empty()) {
        return Result<Compiled>::failure(std::move(problems));
    }
    return Compiler(chart, options).run();
}

Result<Program> compile(const Chart& chart, const CompileOptions& options) {
    Result<Compiled> compiled = compileCourses(chart, options);
    if (!compiled) {
        return Result<Program>::failure(compiled.diagnostics());
    }
    return std::move(compiled.value().program);
}

} // namespace knittsim::pattern
