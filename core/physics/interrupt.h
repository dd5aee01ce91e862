#pragma once

#include <functional>

namespace knittsim::physics {

/// Thrown inside core/physics when the caller wants it to stop; never leaves Integrator::step.
struct Interrupted {};

/// The caller's wish to stop, asked between pieces of work of at most about 20 ms.
class Interrupt {
public:
    Interrupt() = default;
    explicit Interrupt(const std::function<bool()>* cancelled) : m_cancelled(cancelled) {}

    bool wanted() const { return m_cancelled != nullptr && *m_cancelled && (*m_cancelled)(); }

    /// Throws Interrupted when wanted.
    void check() const {
        if (wanted()) {
            throw Interrupted{};
        }
    }

private:
    const std::function<bool()>* m_cancelled = nullptr;
};

} // namespace knittsim::physics
