#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace knittsim::formats::sintral {

enum class Need { None, Knit, Tuck };

/// Which needles of one bed work in a system: R, P, 0, D with a pattern, or symbols of the jacquard.
struct Selection {
    enum class Kind { None, Knit, Tuck, Pattern, Symbols };
    Kind kind = Kind::None;
    std::string text;    ///< pattern of I and '.', or symbols that are selected
    bool others = false; ///< selected are the symbols that are not in `text`
    std::string tucks;   ///< symbols that tuck
    int stitch = 0;      ///< entry of the stitch table (NP), 0: none named

    bool usesSymbols() const { return kind == Kind::Symbols; }

    /// What the needle does; `symbol` is that of the jacquard, 0 where it has none.
    Need at(int needle, char symbol) const;
};

/// One entry of S:, which one system carries out.
struct SystemEntry {
    enum class Kind { Stitch, ToRear, ToFront, Both };
    Kind kind = Kind::Stitch;
    Selection front;
    Selection rear;
};

/// What stands between 'S:' and ';'.
struct SystemList {
    int rowStep = 0;    ///< from <1+> or <1->: rows of the jacquard to go on
    bool field = false; ///< <A> stands at the beginning
    std::vector<SystemEntry> entries;
};

/// Nothing, and `wrong` the part that is not understood.
std::optional<SystemList> parseSystems(std::string_view text, std::string_view& wrong);

} // namespace knittsim::formats::sintral
