#pragma once

#include "core/machine/operation.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace knittsim::machine {

/// One yarn carrier of the machine. `rail` counts from the front; several carriers may share a rail.
struct Carrier {
    std::string name;
    int rail = 0;
    bool parksRight = false;
    std::string yarn; ///< text of ';;Yarn-NAME:', may be empty

    bool operator==(const Carrier&) const = default;
};

struct Header {
    int version = 2;
    std::vector<Carrier> carriers;
    std::string machine;                                     ///< ';;Machine:', may be empty
    std::optional<double> gauge;                             ///< needles per inch
    std::string position;                                    ///< Left, Center, Right, Keep, or empty
    std::optional<int> width;                                ///< needles per bed
    std::vector<std::pair<std::string, std::string>> others; ///< further headers, in order

    bool operator==(const Header&) const = default;
};

/// Machine data of any format with the meaning of knitout 2. Plain value; no operation is checked against a
/// machine.
struct Program {
    std::string file; ///< where it was read from, may be empty
    Header header;
    std::vector<Operation> operations;
    std::vector<std::string> texts; ///< texts of operations (extensions, colours)
    std::vector<std::pair<OperationIndex, std::string>> sourceComments; ///< ';!source:' kept word for word

    /// Index of the carrier with this name, or nothing.
    std::optional<CarrierIndex> findCarrier(const std::string& name) const;
};

/// A carriage pass: neighbouring operations of one carrier set in one direction whose needles advance in that
/// direction. Operations without yarn between them (transfers, racks) end the pass.
struct Pass {
    OperationIndex first = 0;
    OperationIndex count = 0;
    Direction direction = Direction::Right;
    CarrierSet carriers;
};

/// Passes in the order of the program. Operations that carry no yarn belong to no pass.
std::vector<Pass> findPasses(const Program& program);

} // namespace knittsim::machine
