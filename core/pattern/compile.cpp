#include "core/pattern/compile.h"

#include "core/pattern/move_plan.h"
#include "core/pattern/program_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace knittsim::pattern {

namespace {

using machine::Bed;
using machine::CarrierIndex;
using machine::Direction;
using machine::Needle;
using machine::OperationKind;
using machine::Program;

/// One thing a carrier does on its way.
struct Work {
    OperationKind kind = OperationKind::Knit;
    Needle needle;
};

/// A yarn of the chart on the machine.
struct Feed {
    CarrierIndex carrier = 0;
    int firstCourse = -1; ///< -1: never used
    int lastCourse = -1;
    bool in = false;
    bool onHook = false;
    Direction next = Direction::Left; ///< where its next pass goes
};

class Compiler {
public:
    Compiler(const Chart& chart, const CompileOptions& options)
        : m_chart(chart), m_options(options), m_feeds(chart.yarns.size()), m_builder(m_program) {
        m_held[0].assign(static_cast<std::size_t>(chart.width), false);
        m_held[1] = m_held[0];
    }

    Result<Program> run();

private:
    void findCarriers();
    void findLifetimes();
    void writeHeader();

    void castOn();
    std::vector<Needle> castOnNeedles(Bed bed) const;
    void castOnPass(int yarn, const std::vector<Needle>& needles, std::size_t parity);

    void moveLoops(int course);
    void toBed(int wale, Bed bed);
    void prepareBeds(int course);
    void knitCourse(int course);
    std::vector<int> yarnsOf(int course) const;
    std::vector<Work> worksOf(int course, int yarn) const;
    void sortZones(std::vector<int>& yarns, int course) const;
    void addJoin(std::vector<Work>& works, int course, int yarn) const;
    void pass(int yarn, std::vector<Work> works);
    void releaseHook(int yarn);
    void takeOut(int course);
    void drop();

    bool hasBoth(int course) const;
    double rackOf(int course) const { return m_chart.course(course).rack + (hasBoth(course) ? 0.25 : 0.0); }
    void checkRack(int course, double rack);

    Needle needle(Bed bed, int wale) const { return {bed, wale + m_options.firstNeedle}; }
    int wale(Needle needle) const { return needle.index - m_options.firstNeedle; }
    std::vector<bool>::reference held(Bed bed, int wale) {
        return m_held[static_cast<std::size_t>(bed)][static_cast<std::size_t>(wale)];
    }
    bool held(Bed bed, int wale) const {
        return m_held[static_cast<std::size_t>(bed)][static_cast<std::size_t>(wale)];
    }
    Bed loopBed(int wale) const {
        return !held(Bed::Front, wale) && held(Bed::Rear, wale) ? Bed::Rear : Bed::Front;
    }
    Feed& feed(int yarn) { return m_feeds[static_cast<std::size_t>(yarn)]; }
    const Feed& feed(int yarn) const { return m_feeds[static_cast<std::size_t>(yarn)]; }
    void report(const char* id, int course, int wale, std::vector<std::string> arguments) {
        std::string place = wale < 0 ? std::string() : toString(needle(Bed::Front, wale));
        m_problems.push_back(
            {id, Severity::Error, Place{.course = course, .needle = std::move(place)}, std::move(arguments)});
    }

    const Chart& m_chart;
    const CompileOptions& m_options;
    std::vector<Feed> m_feeds;               ///< by chart yarn
    std::array<std::vector<bool>, 2> m_held; ///< by Bed (front, rear) and wale: a loop hangs there
    Program m_program;
    ProgramBuilder m_builder;
    Diagnostics m_problems;
};

Result<Program> Compiler::run() {
    findCarriers();
    findLifetimes();
    if (!m_problems.empty()) {
        return Result<Program>::failure(m_problems);
    }
    writeHeader();
    for (std::size_t y = 0; y < m_feeds.size(); ++y) {
        m_builder.colour(m_feeds[y].carrier, m_chart.yarns[y].colour);
    }
    for (int course = 0; course < m_chart.height(); ++course) {
        if (const auto number = m_chart.course(course).stitchNumber) {
            m_builder.stitchNumber(*number);
        }
        if (course == 0 && m_options.castOn == CastOn::Alternating) {
            castOn();
        }
        moveLoops(course);
        prepareBeds(course);
        knitCourse(course);
        takeOut(course);
    }
    m_builder.rack(0);
    if (m_options.ending == Ending::Dropped) {
        drop();
    }
    if (!m_problems.empty()) {
        return Result<Program>::failure(m_problems);
    }
    return std::move(m_program);
}

void Compiler::findCarriers() {
    const std::vector<std::string>& names = m_options.machine.carriers;
    for (std::size_t y = 0; y < m_feeds.size(); ++y) {
        const std::string& name = m_chart.yarns[y].carrier;
        const auto found = std::ranges::find(names, name);
        if (found == names.end()) {
            report("KS0008", -1, -1, {"carrier", name, fmt::format("{}", fmt::join(names, ", "))});
            continue;
        }
        const auto carrier = static_cast<CarrierIndex>(found - names.begin());
        const auto before = m_feeds.begin() + static_cast<std::ptrdiff_t>(y);
        if (std::any_of(m_feeds.begin(), before, [&](const Feed& f) { return f.carrier == carrier; })) {
            report("KS0505", -1, -1, {name});
        }
        m_feeds[y].carrier = carrier;
    }
}

void Compiler::findLifetimes() {
    for (int course = 0; course < m_chart.height(); ++course) {
        for (const int yarn : yarnsOf(course)) {
            Feed& f = feed(yarn);
            f.firstCourse = f.firstCourse < 0 ? course : f.firstCourse;
            f.lastCourse = course;
        }
    }
}

void Compiler::writeHeader() {
    machine::Header& header = m_program.header;
    header.machine = m_options.machine.id;
    header.gauge = m_options.machine.gauge;
    header.position = "Center";
    for (const std::string& name : m_options.machine.carriers) {
        header.carriers.push_back({name, static_cast<int>(header.carriers.size()), false, ""});
    }
    for (std::size_t y = 0; y < m_feeds.size(); ++y) {
        header.carriers[m_feeds[y].carrier].yarn = m_chart.yarns[y].libraryId;
    }
}

std::vector<Needle> Compiler::castOnNeedles(Bed bed) const {
    const Stitch own = bed == Bed::Front ? Stitch::Knit : Stitch::Purl;
    const int courses = m_chart.beds == BedUse::Double ? std::min(2, m_chart.height()) : 1;
    std::vector<Needle> needles;
    for (int w = 0; w < m_chart.width; ++w) {
        for (int course = 0; course < courses; ++course) {
            const Stitch stitch = m_chart.at(w, course).stitch;
            const bool plain = bed == Bed::Front && stitch != Stitch::Purl && stitch != Stitch::Empty;
            if (stitch == own || stitch == Stitch::Both || plain) {
                needles.push_back(needle(bed, w));
                break;
            }
        }
    }
    return needles;
}

void Compiler::castOnPass(int yarn, const std::vector<Needle>& needles, std::size_t parity) {
    std::vector<Work> works;
    for (std::size_t i = 0; i < needles.size(); ++i) {
        if ((needles.size() - 1 - i) % 2 == parity) {
            works.push_back({OperationKind::Tuck, needles[i]});
        }
    }
    pass(yarn, std::move(works));
}

void Compiler::castOn() {
    const std::vector<int> yarns = yarnsOf(0);
    if (yarns.empty()) {
        return;
    }
    // The yarn at the right end: it stands there when the first course begins.
    int yarn = yarns.front();
    for (int w = 0; w < m_chart.width; ++w) {
        yarn = isWorked(m_chart.at(w, 0).stitch) ? m_chart.at(w, 0).yarn : yarn;
    }
    m_builder.rack(rackOf(0));
    std::vector<Needle> front = castOnNeedles(Bed::Front);
    const std::vector<Needle> rear = castOnNeedles(Bed::Rear);
    if (m_chart.beds == BedUse::Double && !hasBoth(0)) {
        for (const std::size_t parity : {0U, 1U}) {
            castOnPass(yarn, front, parity);
            castOnPass(yarn, rear, parity);
        }
    } else {
        front.insert(front.end(), rear.begin(), rear.end());
        std::ranges::stable_sort(front, {}, [&](Needle n) { return positionPitches(n, rackOf(0)); });
        castOnPass(yarn, front, 0);
        castOnPass(yarn, front, 1);
    }
    releaseHook(yarn);
}

void Compiler::toBed(int wale, Bed bed) {
    const Bed other = bed == Bed::Front ? Bed::Rear : Bed::Front;
    if (held(other, wale)) {
        m_builder.rack(0);
        m_builder.transfer(needle(other, wale), needle(bed, wale));
        held(other, wale) = false;
        held(bed, wale) = true;
    }
}

void Compiler::moveLoops(int course) {
    const std::vector<LoopMove>& moves = m_chart.course(course).moves;
    std::vector<bool> leaves(static_cast<std::size_t>(m_chart.width), false);
    for (const LoopMove& move : moves) {
        leaves[static_cast<std::size_t>(move.from)] = true;
        if (!held(Bed::Front, move.from) && !held(Bed::Rear, move.from)) {
            report("KS0506", course, move.from, {std::to_string(move.from)});
            return;
        }
        toBed(move.from, Bed::Rear);
    }
    for (const LoopMove& move : moves) {
        if (!leaves[static_cast<std::size_t>(move.to)]) {
            toBed(move.to, Bed::Front);
        }
    }
    for (const MoveStep& step : planMoves(moves)) {
        checkRack(course, step.rack);
        m_builder.rack(step.rack);
        for (const LoopMove& move : step.moves) {
            m_builder.transfer(needle(Bed::Rear, move.from), needle(Bed::Front, move.to));
            held(Bed::Rear, move.from) = false;
            held(Bed::Front, move.to) = true;
        }
    }
}

void Compiler::prepareBeds(int course) {
    for (int w = 0; w < m_chart.width; ++w) {
        const Stitch stitch = m_chart.at(w, course).stitch;
        if (stitch == Stitch::Empty && (held(Bed::Front, w) || held(Bed::Rear, w))) {
            report("KS0508", course, w, {std::to_string(w)});
        }
        if (m_chart.beds == BedUse::Single && stitch == Stitch::Purl) {
            toBed(w, Bed::Rear);
        }
    }
    for (int w = 0; w < m_chart.width; ++w) {
        if (m_chart.beds == BedUse::Single && m_chart.at(w, course).stitch == Stitch::Knit) {
            toBed(w, Bed::Front);
        }
    }
}

void Compiler::knitCourse(int course) {
    checkRack(course, rackOf(course));
    m_builder.rack(rackOf(course));
    std::vector<int> yarns = yarnsOf(course);
    const bool intarsia = m_chart.course(course).colours == ColourMethod::Intarsia;
    if (intarsia) {
        sortZones(yarns, course);
    }
    for (const int yarn : yarns) {
        std::vector<Work> works = worksOf(course, yarn);
        if (intarsia) {
            addJoin(works, course, yarn);
        }
        pass(yarn, std::move(works));
        releaseHook(yarn);
    }
}

std::vector<int> Compiler::yarnsOf(int course) const {
    std::vector<bool> used(m_feeds.size(), false);
    for (int w = 0; w < m_chart.width; ++w) {
        const Cell cell = m_chart.at(w, course);
        if (isWorked(cell.stitch)) {
            used[cell.yarn] = true;
        }
    }
    std::vector<int> yarns;
    for (std::size_t y = 0; y < used.size(); ++y) {
        if (used[y]) {
            yarns.push_back(static_cast<int>(y));
        }
    }
    return yarns;
}

std::vector<Work> Compiler::worksOf(int course, int yarn) const {
    std::vector<Work> works;
    for (int w = 0; w < m_chart.width; ++w) {
        const Cell cell = m_chart.at(w, course);
        if (!isWorked(cell.stitch) || cell.yarn != yarn) {
            continue;
        }
        if (cell.stitch == Stitch::Knit || cell.stitch == Stitch::Both) {
            works.push_back({OperationKind::Knit, needle(Bed::Front, w)});
        }
        if (cell.stitch == Stitch::Purl || cell.stitch == Stitch::Both) {
            works.push_back({OperationKind::Knit, needle(Bed::Rear, w)});
        }
        if (cell.stitch == Stitch::Tuck || cell.stitch == Stitch::Miss) {
            const OperationKind kind =
                cell.stitch == Stitch::Tuck ? OperationKind::Tuck : OperationKind::Miss;
            works.push_back({kind, needle(loopBed(w), w)});
        }
    }
    const double rack = rackOf(course);
    std::ranges::stable_sort(works, {}, [&](const Work& work) { return positionPitches(work.needle, rack); });
    return works;
}

/// Zones in the way the carriers go, so that a yarn tucks on a wale before the next yarn knits it.
void Compiler::sortZones(std::vector<int>& yarns, int course) const {
    const auto key = [&](int yarn) {
        int first = 0;
        while (m_chart.at(first, course).yarn != yarn || !isWorked(m_chart.at(first, course).stitch)) {
            ++first;
        }
        const Direction direction = feed(yarn).next;
        return std::pair(sign(direction), sign(direction) * first);
    };
    std::ranges::sort(yarns, {}, key);
}

void Compiler::addJoin(std::vector<Work>& works, int course, int yarn) const {
    const Direction direction = feed(yarn).next;
    const int last = wale(direction == Direction::Right ? works.back().needle : works.front().needle);
    const int next = last + sign(direction);
    if (next < 0 || next >= m_chart.width || !isWorked(m_chart.at(next, course).stitch)) {
        return;
    }
    if (!held(Bed::Front, next) && !held(Bed::Rear, next)) {
        return;
    }
    const Work join{OperationKind::Tuck, needle(loopBed(next), next)};
    works.insert(direction == Direction::Right ? works.end() : works.begin(), join);
}

/// `works` from left to right, whatever way the carrier goes.
void Compiler::pass(int yarn, std::vector<Work> works) {
    if (works.empty()) {
        return;
    }
    Feed& f = feed(yarn);
    if (!f.in) {
        f.in = true;
        f.onHook = m_options.machine.insertingHook;
        m_builder.bringIn(f.carrier, f.onHook ? OperationKind::InHook : OperationKind::In);
    }
    if (f.next == Direction::Left) {
        std::ranges::reverse(works);
    }
    for (const Work& work : works) {
        m_builder.work(work.kind, f.next, work.needle, f.carrier);
        if (makesLoop(work.kind)) {
            held(work.needle.bed, wale(work.needle)) = true;
        }
    }
    f.next = opposite(f.next);
}

void Compiler::releaseHook(int yarn) {
    if (feed(yarn).onHook) {
        m_builder.releaseHook(feed(yarn).carrier);
        feed(yarn).onHook = false;
    }
}

void Compiler::takeOut(int course) {
    for (Feed& f : m_feeds) {
        if (f.in && f.lastCourse == course) {
            f.in = false;
            m_builder.takeOut(f.carrier,
                              m_options.machine.insertingHook ? OperationKind::OutHook : OperationKind::Out);
        }
    }
}

void Compiler::drop() {
    for (const Bed bed : {Bed::Front, Bed::Rear}) {
        for (int w = 0; w < m_chart.width; ++w) {
            if (held(bed, w)) {
                m_builder.drop(needle(bed, w));
            }
        }
    }
}

bool Compiler::hasBoth(int course) const {
    if (m_chart.beds == BedUse::Single) {
        return false;
    }
    for (int w = 0; w < m_chart.width; ++w) {
        if (m_chart.at(w, course).stitch == Stitch::Both) {
            return true;
        }
    }
    return false;
}

void Compiler::checkRack(int course, double rack) {
    const machine::MachineProfile& machine = m_options.machine;
    if (rack < machine.minRack || rack > machine.maxRack) {
        report("KS0507", course, -1,
               {fmt::format("{}", rack), fmt::format("{}", machine.minRack),
                fmt::format("{}", machine.maxRack)});
    }
}

} // namespace

Result<Program> compile(const Chart& chart, const CompileOptions& options) {
    Diagnostics problems = check(chart);
    if (!problems.empty()) {
        return Result<Program>::failure(std::move(problems));
    }
    return Compiler(chart, options).run();
}

} // namespace knittsim::pattern
