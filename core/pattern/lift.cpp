#include "core/pattern/lift.h"

#include "core/formats/formats.h"
#include "core/machine/profile_library.h"
#include "core/pattern/backed_cells.h"
#include "core/pattern/course_compiler.h"
#include "core/pattern/course_works.h"
#include "core/pattern/program_courses.h"
#include "core/yarn/yarn_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>

namespace knittsim::pattern {

using machine::Operation;
using machine::OperationKind;

namespace {

/// Same for the machine, whatever stands in the parts that this kind does not use.
bool isSame(const Operation& a, const Operation& b) {
    return a.kind == b.kind && a.carriers == b.carriers && a.value == b.value && a.value2 == b.value2 &&
           (!namesNeedle(a.kind) || a.needle == b.needle) && (!namesTarget(a.kind) || a.target == b.target) &&
           (!machine::carriesYarn(a.kind) || a.direction == b.direction) && a.text < 0 && b.text < 0;
}

/// A chart for one reading of the program.
class Reading {
public:
    Reading(const LiftInput& input, const machine::MachineProfile& machine, const CourseRules& rules,
            Ending ending, ColourMethod first)
        : m_input(input), m_segments(coursesOf(input, rules)), m_backed(rules.backing), m_preferred(first) {
        m_project.castOn = rules.castOn ? CastOn::Alternating : CastOn::Open;
        m_project.ending = ending;
        m_options = {.castOn = m_project.castOn, .ending = ending, .firstNeedle = 0, .machine = machine};
        Chart& chart = m_project.chart;
        chart = Chart(input.wales, static_cast<int>(m_segments.size()));
        chart.beds = rules.doubleBeds ? BedUse::Double : BedUse::Single;
        chart.yarns = input.yarns;
        for (int c = 0; c < chart.height(); ++c) {
            const ProgramSegment& segment = segmentOf(c);
            std::ranges::copy(segment.cells, chart.cells.begin() + std::ptrdiff_t{c} * chart.width);
            chart.course(c).moves = segment.moves.front();
            chart.course(c).rack = rules.doubleBeds ? static_cast<int>(std::floor(segment.rack)) : 0;
            chart.course(c).stitchNumber = segment.stitchNumber;
        }
        for (const Diagnostic& problem : check(chart)) {
            m_illFormed.insert(problem.place.course);
        }
    }

    int courses() const { return m_project.chart.height(); }
    const std::vector<int>& kept() const { return m_kept; }
    /// The cast-on is that of the first two courses as they have turned out.
    bool holds() const {
        if (!castsOnForTwo() || keepsProgram(m_project.chart.course(0))) {
            return true;
        }
        CourseCompiler compiler(m_project.chart, m_options);
        compiler.begin();
        return saysNow(compiler, compiler.mark(), 0, false);
    }
    /// The first back that the chart has; Float: none.
    ColourMethod backing() const {
        const auto& all = m_project.chart.courses;
        const auto found = std::ranges::find_if(all, isBacked, &Course::colours);
        return found == all.end() ? ColourMethod::Float : found->colours;
    }
    Project takeProject() { return std::move(m_project); }

    void verify() {
        CourseCompiler compiler(m_project.chart, m_options);
        compiler.begin();
        for (int c = 0; c < courses(); ++c) {
            const auto mark = compiler.mark();
            const bool last = c + 1 == courses();
            if (!says(compiler, mark, c, last)) {
                compiler.rewind(mark);
                keep(compiler, c, last ? m_input.operations.size() : segmentOf(c).end);
                compiler.knit(c);
                m_project.ending = last ? Ending::Held : m_project.ending; // the course has the end in it
            }
        }
    }

private:
    const ProgramSegment& segmentOf(int c) const { return m_segments[static_cast<std::size_t>(c)]; }

    /// The chart says this course, one way or the other.
    bool says(CourseCompiler& compiler, const CourseCompiler::Mark& mark, int c, bool last) {
        if (m_illFormed.contains(c)) {
            take(c, ColourMethod::Float, segmentOf(c).moves.front());
            return false;
        }
        for (const ColourMethod colours : methodsFor(c)) {
            for (const std::vector<LoopMove>& moves : segmentOf(c).moves) {
                take(c, colours, moves);
                if (c == 0 && castsOnForTwo() ? saysFirst(compiler, mark)
                                              : saysNow(compiler, mark, c, last)) {
                    m_preferred = isBacked(colours) ? colours : m_preferred;
                    return true;
                }
            }
        }
        take(c, ColourMethod::Float, segmentOf(c).moves.front());
        return false;
    }

    /// The cast-on makes loops for the second course too, which is not known yet.
    bool castsOnForTwo() const {
        return m_project.castOn == CastOn::Alternating && m_project.chart.beds == BedUse::Double &&
               courses() > 1;
    }

    bool saysFirst(CourseCompiler& compiler, const CourseCompiler::Mark& mark) {
        const std::vector<ColourMethod> methods = methodsFor(1);
        return std::ranges::any_of(methods, [&](ColourMethod second) {
            take(1, second, segmentOf(1).moves.front());
            return saysNow(compiler, mark, 0, false);
        });
    }

    /// The back that was there last comes first: of one yarn alone a stitch on both beds looks like it.
    std::vector<ColourMethod> methodsFor(int c) const {
        std::vector<ColourMethod> methods{ColourMethod::Float};
        if (segmentOf(c).joins || yarnsOf(m_project.chart, c).size() > 1) {
            methods.push_back(ColourMethod::Intarsia);
        }
        if (m_backed) {
            for (const ColourMethod method : {ColourMethod::Birdseye, ColourMethod::LadderBack}) {
                methods.insert(m_preferred == method ? methods.begin() : methods.end(), method);
            }
        }
        return methods;
    }

    /// Stitches of the rear bed behind those of the front bed are the back, where there is one.
    void take(int c, ColourMethod colours, const std::vector<LoopMove>& moves) {
        Chart& chart = m_project.chart;
        chart.course(c).colours = colours;
        chart.course(c).moves = moves;
        const std::vector<Cell>& cells = segmentOf(c).cells;
        if (isBacked(colours)) {
            takeBacked(chart, c, cells, rearYarns(segmentOf(c)));
        } else {
            std::ranges::copy(cells, chart.cells.begin() + std::ptrdiff_t{c} * chart.width);
        }
    }

    /// By wale, a bit for each yarn that the rear bed knits.
    std::vector<std::uint64_t> rearYarns(const ProgramSegment& segment) const {
        std::vector<std::uint64_t> yarns(static_cast<std::size_t>(m_project.chart.width));
        for (std::size_t i = segment.first; i < segment.end; ++i) {
            const Operation& op = m_input.operations[i];
            const bool inside = op.needle.index >= 0 && op.needle.index < m_project.chart.width;
            if (op.kind == OperationKind::Knit && op.needle.bed == machine::Bed::Rear && inside &&
                op.carriers.size() == 1) {
                yarns[static_cast<std::size_t>(op.needle.index)] |= std::uint64_t{1} << op.carriers[0];
            }
        }
        return yarns;
    }

    bool saysNow(CourseCompiler& compiler, const CourseCompiler::Mark& mark, int c, bool last) const {
        compiler.rewind(mark);
        compiler.knit(c);
        if (last) {
            compiler.end();
        }
        return compiler.problems().size() == mark.problems &&
               matches(compiler, mark.operations, segmentOf(c).first,
                       last ? m_input.operations.size() : segmentOf(c).end);
    }

    bool matches(const CourseCompiler& compiler, std::size_t from, std::size_t first, std::size_t end) const {
        const std::vector<Operation>& made = compiler.program().operations;
        if (made.size() - from != end - first) {
            return false;
        }
        for (std::size_t i = first; i < end; ++i) {
            Operation own = m_input.operations[i];
            own.carriers = compiler.feeds().carriersOf(own.carriers);
            if (!isSame(own, made[from + i - first])) {
                return false;
            }
        }
        return true;
    }

    void keep(const CourseCompiler& compiler, int c, std::size_t end) {
        Chart& chart = m_project.chart;
        const ProgramSegment& segment = segmentOf(c);
        auto program = std::make_shared<ProgramCourse>();
        for (std::size_t i = segment.first; i < end; ++i) {
            Operation op = m_input.operations[i];
            if (op.text >= 0) {
                program->texts.push_back((*m_input.texts)[static_cast<std::size_t>(op.text)]);
                op.text = static_cast<std::int32_t>(program->texts.size()) - 1;
            }
            program->operations.push_back(op);
        }
        program->cells = segment.cells;
        program->moves = segment.moves.front();
        for (int wale = 0; wale < chart.width; ++wale) {
            program->loops.push_back(compiler.held().bedsOf(wale));
        }
        for (int yarn = 0; yarn < compiler.feeds().count(); ++yarn) {
            if (compiler.feeds().isIn(yarn)) {
                program->in.push_back(static_cast<std::uint8_t>(yarn));
            }
        }
        program->rack = compiler.rack();
        chart.course(c).program = std::move(program);
        m_kept.push_back(c);
    }

    const LiftInput& m_input;
    std::vector<ProgramSegment> m_segments;
    Project m_project;
    CompileOptions m_options;
    std::set<int> m_illFormed; ///< courses that no chart for these beds can have
    std::vector<int> m_kept;   ///< courses
    bool m_backed;             ///< the rear bed may knit a back
    ColourMethod m_preferred;  ///< of those that fit
};

/// What a program has that asks for another reading.
struct Signs {
    bool tucksFirst = false;
    bool misses = false;
    bool bothBeds = false;
    bool drops = false; ///< at the end
};

Signs signsOf(const LiftInput& input) {
    Signs signs;
    HeldLoops held(input.wales);
    bool first = true;
    double rack = 0;
    for (const Operation& op : input.operations) {
        rack = op.kind == OperationKind::Rack ? op.value : rack;
        if (machine::carriesYarn(op.kind)) {
            signs.tucksFirst = signs.tucksFirst || (first && op.kind == OperationKind::Tuck);
            first = false;
            signs.misses = signs.misses || op.kind == OperationKind::Miss;
            signs.drops = false;
            signs.bothBeds = signs.bothBeds || rack != 0;
        }
        held.apply(op);
        signs.bothBeds =
            signs.bothBeds || (machine::makesLoop(op.kind) && (held.bedsOf(op.needle.index) & 3U) == 3);
        signs.drops = signs.drops || op.kind == OperationKind::Drop;
    }
    return signs;
}

std::vector<bool> choices(bool first, bool other) {
    return other ? std::vector<bool>{first, !first} : std::vector<bool>{first};
}

/// Nothing: it has too many courses.
std::optional<Reading> readAs(const LiftInput& input, const machine::MachineProfile& machine,
                              const CourseRules& rules, Ending ending) {
    std::optional<Reading> reading;
    const auto readWith = [&](ColourMethod back) {
        reading.emplace(input, machine, rules, ending, back);
        if (reading->courses() <= kMaxCourses) {
            reading->verify();
        }
    };
    readWith(ColourMethod::Float);
    if (const ColourMethod back = reading->backing(); back != ColourMethod::Float) {
        readWith(back); // courses below the first that is surely a back may be one, too
    }
    if (reading->courses() > kMaxCourses || !reading->holds()) {
        return std::nullopt;
    }
    return reading;
}

/// The reading that leaves the fewest courses unsaid; of those the one with the fewest courses.
std::optional<Reading> bestReading(const LiftInput& input, const machine::MachineProfile& machine) {
    const Signs signs = signsOf(input);
    std::optional<Reading> best;
    const auto consider = [&](const CourseRules& rules) {
        auto reading = readAs(input, machine, rules, signs.drops ? Ending::Dropped : Ending::Held);
        if (reading && (!best || std::pair(reading->kept().size(), reading->courses()) <
                                     std::pair(best->kept().size(), best->courses()))) {
            best.emplace(std::move(*reading));
        }
    };
    for (const bool doubleBeds : choices(false, signs.bothBeds)) {
        for (const bool castOn : choices(signs.tucksFirst, signs.tucksFirst)) {
            for (const bool missesWork : choices(true, signs.misses)) {
                for (const bool zones : choices(true, true)) {
                    for (const bool backing : choices(false, doubleBeds)) {
                        consider({castOn, missesWork, zones, backing, doubleBeds});
                    }
                    if (best && best->kept().empty()) {
                        return best;
                    }
                }
            }
        }
    }
    return best;
}

/// "1, 3 to 7, 12", counted from 1.
std::string rangesText(const std::vector<int>& courses) {
    std::string text;
    for (std::size_t i = 0; i < courses.size();) {
        std::size_t end = i + 1;
        while (end < courses.size() && courses[end] == courses[end - 1] + 1) {
            ++end;
        }
        text += fmt::format("{}{}", text.empty() ? "" : ", ", courses[i] + 1);
        if (end > i + 1) {
            text += fmt::format(" to {}", courses[end - 1] + 1);
        }
        i = end;
        if (text.size() > 60 && i < courses.size()) {
            return text + ", ...";
        }
    }
    return text;
}

} // namespace

Result<Lifted> lift(const machine::Program& program, const machine::MachineProfile& machine,
                    const std::vector<machine::CarrierYarn>& yarns) {
    Result<LiftInput> input = liftInput(program, machine, yarns);
    if (!input) {
        return Result<Lifted>::failure(input.diagnostics());
    }
    std::optional<Reading> reading = bestReading(input.value(), machine);
    if (!reading) {
        return Diagnostic{"KS0510",
                          Severity::Error,
                          Place{.file = program.file},
                          {fmt::format("more than {} courses", kMaxCourses), fmt::format("{}", kMaxCourses)}};
    }
    Lifted lifted;
    lifted.notes = input.value().notes;
    lifted.kept = static_cast<int>(reading->kept().size());
    if (lifted.kept > 0) {
        lifted.notes.push_back(
            {"KS0511",
             Severity::Info,
             Place{.file = program.file, .course = reading->kept().front()},
             {std::to_string(lifted.kept), std::to_string(reading->courses()), rangesText(reading->kept())}});
    }
    lifted.project = reading->takeProject();
    lifted.project.machine = machine.id;
    lifted.project.firstNeedle = input.value().firstNeedle;
    return lifted;
}

Result<Project> readAnyProject(const std::filesystem::path& path) {
    if (isProjectFile(path)) {
        return readProjectFile(path);
    }
    const Result<machine::Program> program = formats::readProgram(path);
    if (!program) {
        return Result<Project>::failure(program.diagnostics());
    }
    Diagnostics ignored; // whoever chooses the machine to check it on hears of them
    const auto machines = machine::ProfileLibrary::read(machine::profileFolders(), ignored);
    const auto machine = machine::chooseProfile(program.value(), machines);
    const auto yarns = machine::carrierYarns(program.value(), yarn::YarnLibrary({}), yarn::defaultYarn());
    Result<Lifted> lifted =
        lift(program.value(), machine ? machine.value() : machine::genericProfile(), yarns);
    if (!lifted) {
        return Result<Project>::failure(lifted.diagnostics());
    }
    return Result<Project>(std::move(lifted.value().project), std::move(lifted.value().notes));
}

} // namespace knittsim::pattern
