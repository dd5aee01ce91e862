#pragma once

#include <chrono>
#include <functional>

namespace knittsim::cli {

/// Says when the time is over.
class Deadline {
public:
    explicit Deadline(double mostSeconds)
        : m_start(std::chrono::steady_clock::now()), m_mostSeconds(mostSeconds),
          m_late([this] { return seconds() > m_mostSeconds; }) {}
    Deadline(const Deadline&) = delete;
    Deadline& operator=(const Deadline&) = delete;

    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
    }
    const std::function<bool()>& late() const { return m_late; }

private:
    std::chrono::steady_clock::time_point m_start;
    double m_mostSeconds;
    std::function<bool()> m_late;
};

} // namespace knittsim::cli
