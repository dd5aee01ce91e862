#pragma once

#include "core/machine/needle.h"

#include <array>
#include <cstdint>
#include <initializer_list>
#include <span>

namespace knittsim::machine {

using CarrierIndex = std::uint8_t;   ///< index into Header::carriers
using OperationIndex = std::int32_t; ///< index into Program::operations

constexpr int kMaxCarriers = 64;      ///< carriers of one machine
constexpr int kMaxCarriersInSet = 15; ///< carriers of one operation

enum class Direction : std::int8_t { Left = -1, Right = +1 };

constexpr int sign(Direction direction) {
    return static_cast<int>(direction);
}
constexpr Direction opposite(Direction d) {
    return d == Direction::Left ? Direction::Right : Direction::Left;
}

/// Carriers of one operation in the order written (the leading carrier first). Fixed size, no allocation.
class CarrierSet {
public:
    CarrierSet() = default;
    CarrierSet(std::initializer_list<int> carriers) {
        for (const int carrier : carriers) {
            push(static_cast<CarrierIndex>(carrier));
        }
    }

    /// Returns false, and changes nothing, when the set is full.
    bool push(CarrierIndex carrier) {
        if (m_count == kMaxCarriersInSet) {
            return false;
        }
        m_carriers[m_count++] = carrier;
        return true;
    }

    bool contains(CarrierIndex carrier) const {
        for (const CarrierIndex c : *this) {
            if (c == carrier) {
                return true;
            }
        }
        return false;
    }

    int size() const { return m_count; }
    bool empty() const { return m_count == 0; }
    CarrierIndex operator[](int i) const { return m_carriers[static_cast<std::size_t>(i)]; }
    const CarrierIndex* begin() const { return m_carriers.data(); }
    const CarrierIndex* end() const { return m_carriers.data() + m_count; }

    bool operator==(const CarrierSet&) const = default;

private:
    std::array<CarrierIndex, kMaxCarriersInSet> m_carriers{};
    std::uint8_t m_count = 0;
};

/// Operations of knitout 2 (textiles-lab/knitout, version 2). Knit, Tuck and Split without carriers mean
/// Drop, Amiss and Xfer; readers turn them into these.
enum class OperationKind : std::uint8_t {
    In,           ///< carriers
    InHook,       ///< carriers
    ReleaseHook,  ///< carriers
    Out,          ///< carriers
    OutHook,      ///< carriers
    StitchSize,   ///< value = leading, value2 = tension (machine units)
    StitchNumber, ///< value = index of the stitch table (x-stitch-number)
    Rack,         ///< value = racking in pitches
    Knit,         ///< direction needle carriers
    Tuck,         ///< direction needle carriers
    Split,        ///< direction needle target carriers
    Drop,         ///< needle
    Amiss,        ///< needle
    Xfer,         ///< needle target
    Miss,         ///< direction needle carriers
    Pause,
    Colour,    ///< text = "#rrggbb", carriers (x-vis-color)
    YarnIn,    ///< direction needle carriers: the carriers stand there, in action (x-yarn-in)
    YarnOut,   ///< direction needle carriers: the carriers leave the action (x-yarn-out)
    Extension, ///< text = the whole operation; no effect
};

constexpr int kOperationKindCount = static_cast<int>(OperationKind::Extension) + 1;

/// "knit", "x-stitch-number", ...
const char* toString(OperationKind kind);

constexpr bool makesLoop(OperationKind kind) {
    return kind == OperationKind::Knit || kind == OperationKind::Tuck || kind == OperationKind::Split;
}

/// Operations that move the carriers along the bed.
constexpr bool carriesYarn(OperationKind kind) {
    return makesLoop(kind) || kind == OperationKind::Miss;
}

struct Operation {
    OperationKind kind = OperationKind::Pause;
    Direction direction = Direction::Right;
    CarrierSet carriers;
    Needle needle;
    Needle target; ///< Split, Xfer
    double value = 0;
    double value2 = 0;
    std::int32_t line = -1; ///< 1-based line of the source file
    std::int32_t text = -1; ///< index into Program::texts, or -1

    bool operator==(const Operation&) const = default;
};

} // namespace knittsim::machine
