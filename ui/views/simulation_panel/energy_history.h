#pragma once

#include "core/simulation/frame.h"

#include <cstdint>
#include <vector>

namespace knittsim::ui {

struct EnergySample {
    std::int64_t step = 0;
    simulation::Energies energies; ///< uJ
    double residual = 1;
};

/// The course of a run. When it is full every second sample goes, so that the whole run stays visible at half
/// the resolution; the newest sample is always kept.
class EnergyHistory {
public:
    static constexpr std::size_t kCapacity = 1024;

    void clear();
    void add(const EnergySample& sample);

    const std::vector<EnergySample>& samples() const { return m_samples; }
    bool empty() const { return m_samples.empty(); }

private:
    std::vector<EnergySample> m_samples;
    std::uint64_t m_stride = 1; ///< of so many added samples one is kept
    std::uint64_t m_added = 0;
};

} // namespace knittsim::ui
