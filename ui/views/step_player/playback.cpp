#include "ui/views/step_player/playback.h"

#include <algorithm>
#include <array>

namespace knittsim::ui {

namespace {

constexpr std::array kSpeeds{0.25, 0.5, 1.0, 2.5, 5.0, 10.0, 25.0, 50.0, 100.0, 250.0, 500.0, 5000.0};

} // namespace

std::span<const double> Playback::speeds() {
    return kSpeeds;
}

void Playback::changeSpeed(int direction) {
    const auto found = std::lower_bound(kSpeeds.begin(), kSpeeds.end(), m_speed);
    const auto next =
        std::clamp<std::ptrdiff_t>(found - kSpeeds.begin() + direction, 0, std::ssize(kSpeeds) - 1);
    m_speed = kSpeeds[static_cast<std::size_t>(next)];
}

int Playback::advance(double milliseconds) {
    m_due += m_speed * std::min(milliseconds, 1000.0) / 1000.0;
    const int whole = static_cast<int>(m_due);
    m_due -= whole;
    return whole;
}

} // namespace knittsim::ui
