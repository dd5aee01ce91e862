#pragma once

#include "core/base/result.h"
#include "core/machine/program.h"

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace knittsim::lesson {

/// Words in one or more languages; English is always there.
struct Words {
    std::map<std::string, std::string> byLanguage; ///< key: "en", "de", ...

    /// In this language ("de", also "de_AT"), else in English.
    const std::string& in(std::string_view language) const;

    bool operator==(const Words&) const = default;
};

/// A place in a program. It means the moment after an operation.
struct Where {
    enum class Kind { Operation, Line, Course, Nth, End } kind = Kind::Operation;
    int number = 0; ///< operations done; line; courses done; which one of `operation`; unused
    machine::OperationKind operation = machine::OperationKind::Knit; ///< Nth

    bool operator==(const Where&) const = default;
};

/// What a class should look at.
enum class Look { Beds, Fabric, Chart, Source };

struct Stop {
    Where at;
    Words title;
    Words text;
    Look look = Look::Beds;

    bool operator==(const Stop&) const = default;
};

struct Lesson {
    std::string id; ///< name of the file without ".json"
    Words title;
    Words summary;
    std::string sample;         ///< id of a sample, or empty
    std::filesystem::path file; ///< the program, where there is no sample
    std::vector<Stop> stops;    ///< one or more

    bool operator==(const Lesson&) const = default;
};

/// One lesson; `file` names it in messages and says where its program lies. Errors: those of parseJson();
/// KS0004, KS0005 for wrong and missing values, with their lines.
Result<Lesson> parseLesson(std::string_view text, const std::filesystem::path& file);
Result<Lesson> readLesson(const std::filesystem::path& file);

/// All lessons of a folder by file name; problems of single ones are added to `problems`.
std::vector<Lesson> readLessons(const std::filesystem::path& folder, Diagnostics& problems);

/// Operations done at a place; `courseEnds`: operations done after each course. What the program does not
/// have means its end.
machine::OperationIndex stepOf(const Where& where, const machine::Program& program,
                               std::span<const machine::OperationIndex> courseEnds);

} // namespace knittsim::lesson
