#pragma once

#include "core/base/diagnostic.h"
#include "core/yarn/yarn.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace knittsim::pattern {

/// What the needles of one cell do.
enum class Stitch : std::uint8_t {
    Knit,     ///< stitch on the front bed
    Purl,     ///< stitch on the rear bed
    Both,     ///< stitch on both needles of the wale (BedUse::Double only, as all that names two beds)
    Tuck,     ///< yarn laid into the hook: on the bed that holds the loop, with two beds on the front bed
    Miss,     ///< the yarn passes, the loop is held; on the bed of Tuck
    Rest,     ///< the loop is held and the yarn does not come here (short rows)
    Empty,    ///< no fabric here
    KnitTuck, ///< stitch on the front bed, tuck on the rear bed
    TuckKnit, ///< tuck on the front bed, stitch on the rear bed
    TuckBoth, ///< tuck on both beds
    RearTuck, ///< tuck on the rear bed
    RearMiss, ///< the yarn passes the needle of the rear bed
    Drop,     ///< the loops of the wale fall off before the course; no yarn comes here
};
constexpr int kStitches = 13;

constexpr bool isWorked(Stitch stitch) {
    return stitch != Stitch::Rest && stitch != Stitch::Empty && stitch != Stitch::Drop;
}

/// Both needles of the wale take yarn.
constexpr bool isOnBothBeds(Stitch stitch) {
    return stitch == Stitch::Both || stitch == Stitch::KnitTuck || stitch == Stitch::TuckKnit ||
           stitch == Stitch::TuckBoth;
}

/// Only a chart with BedUse::Double has it.
constexpr bool needsTwoBeds(Stitch stitch) {
    return isOnBothBeds(stitch) || stitch == Stitch::RearTuck || stitch == Stitch::RearMiss;
}

struct Cell {
    Stitch stitch = Stitch::Knit;
    std::uint8_t yarn = 0; ///< index into Chart::yarns

    bool operator==(const Cell&) const = default;
};

/// A loop goes to another wale of the front bed, over the rear bed. On an occupied wale it is stacked on the
/// loops there.
struct LoopMove {
    int from = 0;
    int to = 0;

    bool operator==(const LoopMove&) const = default;
};

enum class ColourMethod : std::uint8_t {
    Float,      ///< every yarn passes over the whole course and floats where another one knits
    Intarsia,   ///< every yarn stays in its zone and tucks on the first wale of the next zone
    Birdseye,   ///< as Float, and every yarn knits every second needle of the rear bed (backing.h)
    LadderBack, ///< as Float, and every fourth needle of the rear bed knits a yarn that is not shown there
};
constexpr int kColourMethods = 4;

/// The rear bed knits a back; BedUse::Double only.
constexpr bool isBacked(ColourMethod method) {
    return method == ColourMethod::Birdseye || method == ColourMethod::LadderBack;
}

struct ProgramCourse;

struct Course {
    /// Done at once before the course is knitted. Of two loops that cross, the one listed first lies in
    /// front.
    std::vector<LoopMove> moves;
    ColourMethod colours = ColourMethod::Float;
    int rack = 0; ///< pitches; BedUse::Double only. A quarter is added where both needles of a wale work
    std::optional<double> stitchNumber; ///< from this course on; nothing: as before
    /// How a program from outside knits this course, where a chart cannot say it (program_course.h); else
    /// null.
    std::shared_ptr<const ProgramCourse> program = {};

    bool operator==(const Course& other) const; ///< of values, not of pointers
};

struct ChartYarn {
    std::string carrier; ///< name of the machine's carrier
    yarn::Colour colour;
    std::string libraryId; ///< id in the yarn library, may be empty

    bool operator==(const ChartYarn&) const = default;
};

enum class BedUse : std::uint8_t {
    Single, ///< a wale has one loop; it is transferred when its next stitch is on the other bed
    Double, ///< every wale has its own needle on each bed; nothing is transferred (tubes, all-needle ribs)
};

/// A pattern: wales across (0 = left), courses up (0 = knitted first). Plain value.
struct Chart {
    Chart() = default;
    /// All cells are `stitch` with yarn 0.
    Chart(int wales, int courses, Stitch stitch = Stitch::Knit);

    Cell& at(int wale, int course) { return cells[index(wale, course)]; }
    const Cell& at(int wale, int course) const { return cells[index(wale, course)]; }
    Course& course(int c) { return courses[static_cast<std::size_t>(c)]; }
    const Course& course(int c) const { return courses[static_cast<std::size_t>(c)]; }
    int height() const { return static_cast<int>(courses.size()); }

    int width = 0;
    BedUse beds = BedUse::Single;
    std::vector<ChartYarn> yarns;
    std::vector<Cell> cells; ///< course after course, width cells each
    std::vector<Course> courses;

    bool operator==(const Chart&) const = default;

private:
    std::size_t index(int wale, int course) const {
        return static_cast<std::size_t>(course) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(wale);
    }
};

/// Largest width and height of a chart.
constexpr int kMaxWales = 2000;
constexpr int kMaxCourses = 20'000;
constexpr std::size_t kMaxChartYarns = 36; ///< as many as a project file can tell apart

/// What is wrong with the chart itself, whatever the machine: KS0501 to KS0504.
Diagnostics check(const Chart& chart);

enum class Front : std::uint8_t { Left, Right };

/// Moves of a cable: `left` wales from `wale` on change places with the `right` wales beside them.
/// `front` tells which of the two groups passes in front: Front::Right is the usual left cross, Front::Left
/// the right cross.
std::vector<LoopMove> cross(int wale, int left, int right, Front front);

} // namespace knittsim::pattern
