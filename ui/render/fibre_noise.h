#pragma once

#include <cstdint>
#include <vector>

namespace knittsim::render {

constexpr int kNoiseSize = 128;

/// kNoiseSize x kNoiseSize texels of two bytes that repeat seamlessly: fine streaks that look like fibres,
/// stretched along x, and soft spots for colour that changes along a yarn. The same on every call.
std::vector<std::uint8_t> makeFibreNoise();

} // namespace knittsim::render
