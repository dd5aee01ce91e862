#include "core/base/atomic_file.h"

#include <cerrno>
#include <cstring>
#include <system_error>
#include <unistd.h>

namespace knittsim {

namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 18;

std::filesystem::path targetOf(const std::filesystem::path& path) {
    std::error_code code;
    return std::filesystem::is_symlink(path, code) ? std::filesystem::weakly_canonical(path, code) : path;
}

/// Those of the file that is replaced, else the usual ones.
std::filesystem::perms permissionsFor(const std::filesystem::path& path) {
    using std::filesystem::perms;
    std::error_code code;
    const auto status = std::filesystem::status(path, code);
    return std::filesystem::exists(status)
               ? status.permissions()
               : perms::owner_read | perms::owner_write | perms::group_read | perms::others_read;
}

} // namespace

AtomicFile::AtomicFile(const std::filesystem::path& path)
    : m_path(targetOf(path)), m_temporary(m_path.string() + ".XXXXXX") {
    m_descriptor = ::mkstemp(m_temporary.data());
    check(m_descriptor >= 0);
}

AtomicFile::~AtomicFile() {
    if (m_descriptor >= 0) {
        ::close(m_descriptor);
        ::unlink(m_temporary.c_str());
    }
}

void AtomicFile::check(bool fine) {
    if (!fine && m_error == 0) {
        m_error = errno;
    }
}

void AtomicFile::write(std::string_view bytes) {
    if (!good()) {
        return;
    }
    m_buffer += bytes;
    if (m_buffer.size() >= kBufferBytes) {
        flush();
    }
}

void AtomicFile::flush() {
    std::size_t done = 0;
    while (done < m_buffer.size() && good()) {
        const ssize_t count = ::write(m_descriptor, m_buffer.data() + done, m_buffer.size() - done);
        check(count >= 0 || errno == EINTR);
        done += count > 0 ? static_cast<std::size_t>(count) : 0;
    }
    m_buffer.clear();
}

void AtomicFile::finish() {
    flush();
    if (m_descriptor < 0) {
        return;
    }
    check(!good() || ::fsync(m_descriptor) == 0);
    check(::close(m_descriptor) == 0);
    m_descriptor = -1;
    if (good()) {
        std::error_code code;
        std::filesystem::permissions(m_temporary, permissionsFor(m_path), code);
    }
}

void AtomicFile::putThere() {
    if (good()) {
        std::error_code code;
        std::filesystem::rename(m_temporary, m_path, code);
        m_error = code.value();
    }
    if (!good()) {
        ::unlink(m_temporary.c_str());
    }
}

Result<Written> AtomicFile::result() const {
    if (!good()) {
        return Diagnostic{
            "KS0002", Severity::Error, Place{.file = m_path.string()}, {std::strerror(m_error)}};
    }
    return Written{};
}

Result<Written> AtomicFile::commit() {
    finish();
    putThere();
    return result();
}

Result<Written> AtomicFile::commitBoth(AtomicFile& first, AtomicFile& second) {
    first.finish();
    second.finish();
    if (!first.good() || !second.good()) {
        ::unlink(first.m_temporary.c_str());
        ::unlink(second.m_temporary.c_str());
        return first.good() ? second.result() : first.result();
    }
    // Another name of what the first one replaces, for the case that the second one finds no place.
    const std::filesystem::path before = first.m_temporary + ".before";
    std::error_code code;
    if (std::filesystem::is_regular_file(first.m_path, code)) {
        std::filesystem::copy_file(first.m_path, before, code);
    }
    first.putThere();
    if (first.good()) {
        second.putThere();
    } else {
        ::unlink(second.m_temporary.c_str());
    }
    if (first.good() && !second.good()) {
        if (std::filesystem::exists(before, code)) {
            std::filesystem::rename(before, first.m_path, code);
        } else {
            ::unlink(first.m_path.c_str());
        }
    }
    std::filesystem::remove(before, code);
    return first.good() ? second.result() : first.result();
}

} // namespace knittsim
