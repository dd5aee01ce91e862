#include "core/pattern/course_compiler.h"

#include "core/pattern/cast_on.h"
#include "core/pattern/program_works.h"

#include <fmt/format.h>

#include <algorithm>

namespace knittsim::pattern {

using machine::Bed;

CourseCompiler::CourseCompiler(const Chart& chart, const CompileOptions& options)
    : m_chart(chart), m_options(options), m_feeds(chart, options.machine, m_problems), m_held(chart.width),
      m_builder(m_program, options.firstNeedle) {}

void CourseCompiler::knit(int course) {
    if (keepsProgram(m_chart.course(course))) {
        knitAsInProgram(course);
        return;
    }
    if (const auto number = m_chart.course(course).stitchNumber) {
        m_builder.stitchNumber(*number);
    }
    if (course == 0 && m_options.castOn == CastOn::Alternating) {
        castOnAlternating(m_chart, m_feeds, m_held, m_builder);
    }
    moveLoops(course, m_chart.course(course).moves);
    dropLoops(course);
    prepareBeds(course);
    knitCourse(course);
    m_feeds.takeOut(course, m_builder);
}

void CourseCompiler::knitAsInProgram(int course) {
    const ProgramCourse& program = *m_chart.course(course).program;
    ProgramWorks works(m_chart, course, m_feeds, m_held, m_builder);
    works.meetProgram();
    if (const std::vector<LoopMove> added = addedMoves(m_chart.course(course)); !added.empty()) {
        moveLoops(course, added);
        m_builder.rack(program.rack);
    }
    dropLoops(course);
    checkEmpty(course);
    works.knit();
    m_feeds.takeOut(course, m_builder, yarnsOf(program));
}

void CourseCompiler::end() {
    const bool byProgram = m_chart.height() > 0 && keepsProgram(m_chart.courses.back());
    if (!byProgram) {
        m_builder.rack(0);
    }
    if (m_options.ending == Ending::Dropped) {
        dropWhere([](int) { return true; });
    }
}

CourseCompiler::Mark CourseCompiler::mark() const {
    return {
        m_held,           m_feeds, m_builder.setting(), m_program.operations.size(), m_program.texts.size(),
        m_problems.size()};
}

void CourseCompiler::rewind(const Mark& mark) {
    m_held = mark.held;
    m_feeds = mark.feeds;
    m_builder.rewind(mark.setting);
    m_program.operations.resize(mark.operations);
    m_program.texts.resize(mark.texts);
    m_problems.resize(mark.problems);
}

void CourseCompiler::begin() {
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

void CourseCompiler::moveLoops(int course, const std::vector<LoopMove>& moves) {
    if (canMove(course, moves)) {
        m_held.move(moves, m_builder);
    }
}

bool CourseCompiler::canMove(int course, const std::vector<LoopMove>& moves) {
    const std::size_t before = m_problems.size();
    for (const LoopMove& move : moves) {
        if (!m_held.any(move.from)) {
            report("KS0506", course, move.from, {std::to_string(move.from)});
        }
        checkRack(course, move.to - move.from);
    }
    return m_problems.size() == before;
}

void CourseCompiler::dropLoops(int course) {
    dropWhere([&](int wale) {
        return m_chart.at(wale, course).stitch == Stitch::Drop && !isAsInProgram(m_chart, wale, course);
    });
}

void CourseCompiler::dropWhere(const std::function<bool(int wale)>& falls) {
    for (const Bed bed : {Bed::Front, Bed::Rear}) {
        for (int wale = 0; wale < m_chart.width; ++wale) {
            if (falls(wale)) {
                m_held.drop({bed, wale}, m_builder);
            }
        }
    }
}

void CourseCompiler::checkEmpty(int course) {
    for (int wale = 0; wale < m_chart.width; ++wale) {
        if (m_chart.at(wale, course).stitch == Stitch::Empty && m_held.any(wale) &&
            !isAsInProgram(m_chart, wale, course)) {
            report("KS0508", course, wale, {std::to_string(wale)});
        }
    }
}

void CourseCompiler::prepareBeds(int course) {
    checkEmpty(course);
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

void CourseCompiler::knitCourse(int course) {
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
void CourseCompiler::sortZones(std::vector<int>& yarns, int course) const {
    std::ranges::sort(yarns, {}, [&](int yarn) {
        const int direction = sign(m_feeds.next(yarn));
        return std::pair(direction, direction * firstWaleOf(m_chart, course, yarn));
    });
}

void CourseCompiler::checkRack(int course, double rack) {
    const machine::MachineProfile& machine = m_options.machine;
    if (rack < machine.minRack || rack > machine.maxRack) {
        report("KS0507", course, -1,
               {fmt::format("{}", rack), fmt::format("{}", machine.minRack),
                fmt::format("{}", machine.maxRack)});
    }
}

void CourseCompiler::report(const char* id, int course, int wale, std::vector<std::string> arguments) {
    Place place{.course = course};
    if (wale >= 0) {
        place.needle = toString(machine::Needle{Bed::Front, wale + m_options.firstNeedle});
    }
    m_problems.push_back({id, Severity::Error, std::move(place), std::move(arguments)});
}

} // namespace knittsim::pattern
