#include "core/machine/state.h"

#include <algorithm>
#include <bit>

namespace knittsim::machine {

std::vector<LoopIndex>& NeedleRow::edit(std::int32_t index) {
    if (m_needles.empty()) {
        m_first = index;
    }
    if (index < m_first) {
        m_needles.insert(m_needles.begin(), static_cast<std::size_t>(m_first - index), {});
        m_first = index;
    }
    if (index >= end()) {
        m_needles.resize(static_cast<std::size_t>(index - m_first) + 1);
    }
    return m_needles[static_cast<std::size_t>(index - m_first)];
}

bool NeedleRow::operator==(const NeedleRow& other) const {
    const std::int32_t from = std::min(first(), other.first());
    const std::int32_t to = std::max(end(), other.end());
    for (std::int32_t i = from; i < to; ++i) {
        if (!std::ranges::equal(at(i), other.at(i))) {
            return false;
        }
    }
    return true;
}

namespace {

/// FNV-1a over 64-bit words.
class Digest {
public:
    void add(std::uint64_t word) {
        for (int i = 0; i < 8; ++i) {
            m_value = (m_value ^ ((word >> (8 * i)) & 0xff)) * 0x100000001b3ULL;
        }
    }
    void add(std::int64_t word) { add(static_cast<std::uint64_t>(word)); }
    void add(std::int32_t word) { add(static_cast<std::int64_t>(word)); }
    void add(double number) { add(std::bit_cast<std::uint64_t>(number + 0.0)); }
    std::uint64_t value() const { return m_value; }

private:
    std::uint64_t m_value = 0xcbf29ce484222325ULL;
};

void addBed(Digest& digest, const NeedleRow& row) {
    for (std::int32_t i = row.first(); i < row.end(); ++i) {
        const auto loops = row.at(i);
        if (loops.empty()) {
            continue;
        }
        digest.add(i);
        for (const LoopIndex loop : loops) {
            digest.add(loop);
        }
        digest.add(-1);
    }
    digest.add(-2);
}

void addCarrier(Digest& digest, const CarrierState& carrier) {
    digest.add((carrier.in ? 4 : 0) + (carrier.placed ? 2 : 0) + (carrier.looped ? 1 : 0));
    digest.add(carrier.yarn);
    digest.add(carrier.fedMm);
    digest.add(carrier.wayPitches);
    digest.add(static_cast<int>(carrier.loopBed));
    if (carrier.placed) {
        digest.add(static_cast<std::int32_t>(carrier.place.needle.bed));
        digest.add(carrier.place.needle.index);
        digest.add(sign(carrier.place.side));
        digest.add(carrier.place.pitches);
    }
}

} // namespace

std::uint64_t digest(const MachineState& state) {
    Digest digest;
    digest.add(state.nextOperation);
    for (const NeedleRow& row : state.beds) {
        addBed(digest, row);
    }
    for (const CarrierState& carrier : state.carriers) {
        addCarrier(digest, carrier);
    }
    for (const CarrierIndex carrier : state.hook) {
        digest.add(static_cast<std::int32_t>(carrier));
    }
    digest.add(state.rack);
    digest.add(state.loopLengthMm);
    digest.add(state.loopCount);
    digest.add(state.yarnCount);
    return digest.value();
}

} // namespace knittsim::machine
