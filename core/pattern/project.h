#pragma once

#include "core/base/result.h"
#include "core/machine/profile_library.h"
#include "core/pattern/colourway.h"
#include "core/pattern/compile.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace knittsim::pattern {

/// What a designer keeps: the chart and how it is made into a program.
struct Project {
    Chart chart;
    CastOn castOn = CastOn::Alternating;
    Ending ending = Ending::Held;
    std::string machine;            ///< id of a machine profile; empty: generic
    int firstNeedle = kFirstNeedle; ///< of wale 0
    Colourways colourways = {};

    bool operator==(const Project&) const = default;
};

/// A project file (.knitt) is JSON with a line for each course, so that a version control shows what changed:
///
///     knitt      3, the version of the format
///     thumbnail  a small PNG in base64 for lists of files, may be missing (since version 2)
///     view       the camera on the fabric in base64, may be missing (since version 3)
///     machine    id of a machine profile, may be missing
///     cast_on    "open" or "alternating"
///     ending     "held" or "dropped"
///     beds       "single" or "double"
///     wales      number of wales
///     first_needle  of wale 0; missing: 1 (since version 2)
///     yarns      list of {carrier, colour "#rrggbb", library_id}
///     colourway  which of the colourways the yarns are, from 0; missing with these (since version 2)
///     colourways list of {name, yarns as above}, may be missing (since version 2)
///     courses    from the first one knitted to the last; each
///         stitches   a letter for each wale from the left: k knit, p purl, b both, t tuck, m miss, r rest,
///                    . empty; since version 3 f knit in front, tuck behind; g tuck in front, knit behind;
///                    u tuck on both, q rear tuck, n rear miss, d drop
///         yarns      a digit 0-9 a-z for each wale, or a single one for all
///         moves      pairs [from, to] of wales, may be missing
///         colours    "float", "intarsia", "birdseye" or "ladder" (the last two since version 3); missing:
///         float rack       pitches; missing: 0 stitch     stitch number from here on; may be missing program
///         how a program from outside knits the course (ProgramCourse); may be missing
///             stitches, yarns, moves  what it makes, as above
///             loops       a hexadecimal digit for each wale: 1 front, 2 rear, 4 and 8 the sliders hold loops
///                         before
///             in          digits of the yarns in action before
///             rack        before
///             operations  lines of knitout; needles are wales, carriers the digits of yarns
///     shape      the fabric at rest: x, y and z of each entry of its bonding point table, in micrometres;
///     may
///                be missing (since version 4)
///
/// Files of version 1 have neither thumbnail nor colourways. Before version 3 a tuck or miss of a chart on
/// two beds was on the rear bed where only that held a loop; such cells are read as rear tuck and rear miss.
constexpr int kProjectVersion = 4;
constexpr std::string_view kProjectExtension = ".knitt";

/// What is shown beside the chart; empty: none.
struct ProjectLook {
    std::string thumbnail = {};    ///< base64
    std::string view = {};         ///< base64
    std::vector<float> shape = {}; ///< of the fabric at rest: 3 per entry of the bonding point table, mm
};

std::string writeProject(const Project& project, const ProjectLook& look = {});

/// Thumbnail and view of a project file (not the shape), without reading the chart.
ProjectLook readLook(const std::filesystem::path& path);

/// Errors: KS0003 to KS0005 with the place in the JSON, KS0509 for a version that is newer than this program,
/// KS0501 and KS0503. A chart with stitches or yarns that cannot be knitted is read all the same.
/// `shape`: gets that of ProjectLook, where it is not null.
Result<Project> readProject(std::string_view text, const std::string& file,
                            std::vector<float>* shape = nullptr);

/// Errors: those of readFile and of above.
Result<Project> readProjectFile(const std::filesystem::path& path, std::vector<float>* shape = nullptr);

/// By its extension, in whatever case.
bool isProjectFile(const std::filesystem::path& path);

/// How the project is compiled: on the machine that it names, else on the one that files without a name get.
CompileOptions optionsOf(const Project& project, const machine::ProfileLibrary& machines);

/// The program of a file: machine data of any format, or that of a chart, on the machine that it names.
/// Errors: those of formats::readProgram, of above and of compile().
Result<machine::Program> readAnyProgram(const std::filesystem::path& path);

} // namespace knittsim::pattern
