#include "ui/views/simulation_panel/energy_history.h"

namespace knittsim::ui {

void EnergyHistory::clear() {
    m_samples.clear();
    m_stride = 1;
    m_added = 0;
}

void EnergyHistory::add(const EnergySample& sample) {
    // The last sample stands for "now" and gives way to the next one unless its number is a multiple of the
    // stride.
    const bool replaceNewest = !m_samples.empty() && (m_added - 1) % m_stride != 0;
    if (replaceNewest) {
        m_samples.back() = sample;
    } else {
        m_samples.push_back(sample);
    }
    ++m_added;
    if (m_samples.size() < kCapacity) {
        return;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < m_samples.size(); i += 2) {
        m_samples[kept++] = m_samples[i];
    }
    m_samples.resize(kept);
    m_samples.push_back(sample);
    m_stride *= 2;
}

} // namespace knittsim::ui
