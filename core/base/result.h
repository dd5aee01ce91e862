#pragma once

#include "core/base/diagnostic.h"

#include <cassert>
#include <optional>
#include <utility>

namespace knittsim {

/// A value, or the reason why there is none. Diagnostics may accompany a value too (warnings).
/// A Result without a value always holds at least one error.
template<class T> class [[nodiscard]] Result {
public:
    Result(T value, Diagnostics diagnostics = {}) // NOLINT(google-explicit-constructor)
        : m_value(std::move(value)), m_diagnostics(std::move(diagnostics)) {}

    Result(Diagnostic error) : m_diagnostics{std::move(error)} { // NOLINT(google-explicit-constructor)
        assert(hasErrors(m_diagnostics));
    }

    static Result failure(Diagnostics diagnostics) {
        assert(hasErrors(diagnostics));
        Result result;
        result.m_diagnostics = std::move(diagnostics);
        return result;
    }

    explicit operator bool() const { return m_value.has_value(); }
    bool hasValue() const { return m_value.has_value(); }

    T& value() & { return *m_value; }
    const T& value() const& { return *m_value; }
    T&& value() && { return std::move(*m_value); }
    T* operator->() { return &*m_value; }
    const T* operator->() const { return &*m_value; }

    const Diagnostics& diagnostics() const { return m_diagnostics; }

private:
    Result() = default;

    std::optional<T> m_value;
    Diagnostics m_diagnostics;
};

} // namespace knittsim
