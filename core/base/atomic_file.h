#pragma once

#include "core/base/file.h"

#include <string>

namespace knittsim {

/// A file that appears under its name only when all of it is there: it is written beside it and renamed at
/// the end. Without commit() nothing is left. A symbolic link stays one: its target is replaced.
class AtomicFile {
public:
    explicit AtomicFile(const std::filesystem::path& path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Bytes are collected; does nothing any more after an error.
    void write(std::string_view bytes);

    /// False as soon as something went wrong: writing on is of no use.
    bool good() const { return m_error == 0; }

    /// Puts the file in its place; once, at the end. Errors: KS0002.
    Result<Written> commit();

    /// Two files that belong together: both get into their places, or what was there before stays. Errors:
    /// KS0002, of the one that fails.
    static Result<Written> commitBoth(AtomicFile& first, AtomicFile& second);

private:
    void flush();
    void finish();   ///< all bytes are on the disk, under the temporary name
    void putThere(); ///< under the name that is wanted
    Result<Written> result() const;
    void check(bool fine);

    std::filesystem::path m_path;
    std::string m_temporary;
    std::string m_buffer;
    int m_descriptor = -1;
    int m_error = 0; ///< errno of the first failure
};

} // namespace knittsim
