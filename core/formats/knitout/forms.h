#pragma once

#include "core/machine/operation.h"

#include <array>
#include <string_view>

namespace knittsim::formats::knitout {

/// What stands at one place of an operation.
enum class Argument : char {
    None = 0,
    Direction, ///< '+' or '-'
    Needle,
    Target,   ///< second needle
    Carriers, ///< none or more names, up to the end
    Racking,
    TableIndex, ///< index of a stitch table, or one letter A..Z for 10..35
    Leading,
    Tension,
    ColourCode, ///< #rrggbb, also without '#' or as #rgb
    Message,    ///< free text up to the end
};

/// How one kind of operation is written. The reader and the writer share the table.
struct Form {
    std::string_view name;
    machine::OperationKind kind;
    std::array<Argument, 4> arguments;

    bool isExtension() const { return name.substr(0, 2) == "x-"; }
};

constexpr auto kForms = [] {
    using enum machine::OperationKind;
    using enum Argument;
    // The most frequent ones first: the reader goes through the table for every line.
    return std::to_array<Form>({
        {"knit", Knit, {Direction, Needle, Carriers}},
        {"xfer", Xfer, {Needle, Target}},
        {"tuck", Tuck, {Direction, Needle, Carriers}},
        {"miss", Miss, {Direction, Needle, Carriers}},
        {"split", Split, {Direction, Needle, Target, Carriers}},
        {"rack", Rack, {Racking}},
        {"drop", Drop, {Needle}},
        {"amiss", Amiss, {Needle}},
        {"in", In, {Carriers}},
        {"inhook", InHook, {Carriers}},
        {"releasehook", ReleaseHook, {Carriers}},
        {"out", Out, {Carriers}},
        {"outhook", OutHook, {Carriers}},
        {"stitch", StitchSize, {Leading, Tension}},
        {"pause", Pause, {Message}},
        {"x-stitch-number", StitchNumber, {TableIndex}},
        {"x-vis-color", Colour, {ColourCode, Carriers}},
        {"x-yarn-in", YarnIn, {Direction, Needle, Carriers}},
        {"x-yarn-out", YarnOut, {Direction, Needle, Carriers}},
    });
}();

/// Every kind but Extension has a form.
constexpr const Form* findForm(machine::OperationKind kind) {
    for (const Form& form : kForms) {
        if (form.kind == kind) {
            return &form;
        }
    }
    return nullptr;
}

constexpr const Form* findForm(std::string_view name) {
    for (const Form& form : kForms) {
        if (form.name == name) {
            return &form;
        }
    }
    return nullptr;
}

} // namespace knittsim::formats::knitout
