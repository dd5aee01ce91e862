#include "core/formats/kcode/sizes.h"

#include "core/formats/kcode/layout.h"

#include <algorithm>

namespace knittsim::formats::kcode {

static_assert(kWrittenNeedles == 253);

void SizeLine::set(int needle, int size) {
    if (size >= 0) {
        m_sizes[static_cast<std::size_t>(needle)] = size;
    }
}

std::string SizeLine::text(machine::Direction direction, int none) const {
    std::array<int, 253> sizes = m_sizes;
    // From where the carriage ends back to where it begins: each takes over the size met before.
    const auto fill = [](auto begin, auto end) {
        const auto first = std::find_if(begin, end, [](int size) { return size >= 0; });
        int size = first == end ? -1 : *first;
        for (auto at = begin; at != end; ++at) {
            size = *at >= 0 ? *at : size;
            *at = size;
        }
    };
    if (direction == machine::Direction::Right) {
        fill(sizes.rbegin(), sizes.rend());
    } else {
        fill(sizes.begin(), sizes.end());
    }
    std::string line;
    const auto sign = [&](int size) { return signOf(size < 0 ? none : size); };
    line.append(kMargin, sign(sizes.front()));
    for (const int size : sizes) {
        line += sign(size);
    }
    line.append(kMargin, sign(sizes.back()));
    return line;
}

} // namespace knittsim::formats::kcode
