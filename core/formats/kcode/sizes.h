#pragma once

#include "core/machine/operation.h"

#include <array>
#include <string>

namespace knittsim::formats::kcode {

/// Stitch sizes of one bed. Needles without one get that of the next one in the direction of the stroke, so
/// that the cams move once and in time.
class SizeLine {
public:
    SizeLine() { m_sizes.fill(-1); }

    /// A negative size leaves the needle as it is.
    void set(int needle, int size);

    /// The line with its margins; `none` everywhere when no needle has a size.
    std::string text(machine::Direction direction, int none) const;

private:
    std::array<int, 253> m_sizes;
};

} // namespace knittsim::formats::kcode
