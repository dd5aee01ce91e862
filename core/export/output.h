#pragma once

#include "core/base/atomic_file.h"
#include "core/base/progress.h"

#include <fmt/format.h>

#include <iterator>
#include <span>
#include <utility>

namespace knittsim::exports {

/// Thrown inside core/export when writing on is of no use; never leaves writeShape().
struct Stopped {};

/// A file that is being written. Nothing of it is left unless commit() is called.
class Output {
public:
    Output(const std::filesystem::path& path, const Progress& progress)
        : m_file(path), m_progress(progress) {}

    void write(std::string_view bytes) { m_file.write(bytes); }

    /// Formats and writes.
    template<class... T> void print(fmt::format_string<T...> pattern, T&&... values) {
        m_text.clear();
        fmt::format_to(std::back_inserter(m_text), pattern, std::forward<T>(values)...);
        write(m_text);
    }

    /// Plain values in the byte order of the machine, which has to be little-endian for the formats written
    /// here.
    template<class T> void writeRaw(std::span<const T> values) {
        write({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
    }

    /// To be called every some thousand values. Throws Stopped when the caller cancels or the disk is full.
    void advance(double share) {
        m_cancelled = m_cancelled || (m_progress && !m_progress(share));
        if (m_cancelled || !m_file.good()) {
            throw Stopped{};
        }
    }

    bool cancelled() const { return m_cancelled; }

    Result<Written> commit() { return m_file.commit(); }

    /// Both or none.
    static Result<Written> commitBoth(Output& first, Output& second) {
        return AtomicFile::commitBoth(first.m_file, second.m_file);
    }

private:
    AtomicFile m_file;
    const Progress& m_progress;
    std::string m_text;
    bool m_cancelled = false;
};

} // namespace knittsim::exports
