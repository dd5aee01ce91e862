#pragma once

#include "core/formats/problems.h"
#include "core/machine/operation.h"

#include <optional>
#include <string_view>

namespace knittsim::formats::kcode {

/// What a bed does in a pass.
enum class BedWork { Knit, Tuck, Give, TakeLeft, TakeRight };

constexpr bool takes(BedWork work) {
    return work == BedWork::TakeLeft || work == BedWork::TakeRight;
}

/// The last line of a pass: ">> Kn-Kn 5 100 100".
struct Action {
    machine::Direction direction = machine::Direction::Right;
    BedWork front = BedWork::Knit;
    BedWork rear = BedWork::Knit;
    int carrier = 0; ///< 1 to 6, 0 for none
    double speed = 0;
    double roller = 0; ///< take-down
};

/// Nothing, and KS0108, when it is none.
std::optional<Action> parseAction(std::string_view line, int lineNumber, Problems& problems);

} // namespace knittsim::formats::kcode
