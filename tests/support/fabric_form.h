#pragma once

#include "core/fabric/fabric.h"

#include <compare>
#include <string>
#include <vector>

namespace knittsim::test {

/// A loop by its place along its yarn, whatever its number in the program.
struct LoopName {
    int yarn = 0; ///< index into FabricForm::yarns
    int place = 0;
    auto operator<=>(const LoopName&) const = default;
};

/// A point along a yarn. A foot or head names its row of the bonding point table (rows are counted as they
/// are first met along the yarns), a crossing names the piece that it crosses.
struct Stop {
    LoopName loop;
    fabric::Role role = fabric::Role::Head;
    fabric::Side side = fabric::Side::Left; ///< not for floats
    fabric::Piece piece = fabric::Piece::LeftLeg;
    int entry = -1;
    LoopName crossed;
    fabric::Piece crossedPiece = fabric::Piece::LeftLeg;
    int front = 0;
    int sign = 0;
    auto operator<=>(const Stop&) const = default;
};

/// A loop and the loops it is joined with.
struct FormLoop {
    machine::Needle needle;
    machine::Direction direction = machine::Direction::Right;
    machine::OperationKind kind = machine::OperationKind::Knit;
    machine::Needle bound;
    fabric::Loop::End end = fabric::Loop::End::Held;
    bool onNeedle = false;
    std::vector<LoopName> parents; ///< in the order of the stack
    std::vector<LoopName> through; ///< drawn through it, from the foot up
    bool operator==(const FormLoop&) const = default;
};

struct FormYarn {
    int carrier = 0;
    std::vector<FormLoop> loops;
    std::vector<Stop> stops;
    bool operator==(const FormYarn&) const = default;
};

/// The topology of a fabric without the numbers of operations, loops, points and yarns, and without lengths
/// and courses (these follow from the passes in which the machine made them): two programs that make the same
/// fabric give the same form. Yarns stand in the order of their carriers.
struct FabricForm {
    std::vector<FormYarn> yarns;
    bool operator==(const FabricForm&) const = default;
};

FabricForm formOf(const fabric::Fabric& fabric);

/// As a mirror beside the machine shows it.
FabricForm mirrored(FabricForm form);

/// Seen from behind, by somebody who calls the rear bed the front one.
FabricForm turnedOver(FabricForm form);

/// Leaves out where loops were made and held and how: what a person who has only the fabric can see. What
/// stays is the bed on which a loop was drawn through others, that is the side to which it was pulled.
FabricForm withoutMachine(FabricForm form);

FabricForm withoutCrossings(FabricForm form);

/// Leaves out the crossings of floats.
FabricForm withoutFloats(FabricForm form);

/// Puts crossings that follow each other on one piece into a fixed order. Strands at the same place of the
/// bed (a stack, facing loops) have no order across; where it has to be chosen, a mirror may change it.
FabricForm withSortedCrossings(FabricForm form);

/// The first thing that differs, in words; nothing when the forms are equal.
std::string difference(const FabricForm& a, const FabricForm& b);

} // namespace knittsim::test
