#pragma once

#include "core/formats/sintral/selection.h"
#include "core/machine/operation.h"

#include <optional>
#include <string>
#include <vector>

namespace knittsim::formats::sintral {

/// A number, or the value of a counter, with further ones added or taken away.
struct Expression {
    struct Term {
        int sign = 1;
        bool counter = false;
        int value = 0; ///< number, or which counter
    };
    std::vector<Term> terms;
};

enum class Comparison { Equal, Unequal, Less, LessOrEqual, Greater, GreaterOrEqual };

/// One word of a line.
struct Command {
    enum class Kind {
        Start,
        End,
        Direction,   ///< direction; nothing: either way
        System,      ///< one system works
        EmptyStroke, ///< S0, S0Y
        Systems,     ///< systems
        Carriers,    ///< numbers: the cycle of carriers, 0 for none
        Homes,       ///< numbers: carriers on the left, then from `value` on those on the right
        Rack,        ///< value: needles to the right, fraction
        Keep,        ///< text: kept, no effect on loops
        Unsimulated, ///< text: kept with a warning
        SkipBegin,   ///< text: what stands up to the end is not carried out
        SkipEnd,
        Repeat, ///< expression
        RepeatEnd,
        Set,           ///< value: counter, expression
        If,            ///< value: counter, comparison, expression; `negated`
        Goto,          ///< value: line
        Gosub,         ///< value and value2: lines
        JacquardStart, ///< value: which, value2: line
        UseJacquard,   ///< value: which
        Field,         ///< value and value2: columns
        PlaceField,    ///< value: needle
        Range,         ///< value and value2: needles
        StitchValue,   ///< value: entry, fraction: its value
    };
    Kind kind = Kind::Keep;
    int column = 1;
    std::string text;
    std::optional<machine::Direction> direction;
    SystemList systems;
    std::vector<int> numbers;
    Expression expression;
    Comparison comparison = Comparison::Equal;
    bool negated = false;
    int value = 0;
    int value2 = 0;
    double fraction = 0;
};

/// A line of the program.
struct Line {
    int number = -1; ///< its own number, -1: none
    int place = 0;   ///< 1-based in the file
    std::vector<Command> commands;
};

} // namespace knittsim::formats::sintral
