#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace knittsim::exports {

/// Bytes as letters (RFC 4648), piece by piece: three bytes become four signs.
class Base64 {
public:
    /// The signs of all threes that are complete; valid until the next call.
    const std::string& put(std::string_view bytes) {
        m_signs.clear();
        for (const char c : bytes) {
            m_held = m_held << 8 | static_cast<std::uint8_t>(c);
            if (++m_count == 3) {
                emit(4);
            }
        }
        return m_signs;
    }

    /// The last signs, filled up to four.
    const std::string& finish() {
        m_signs.clear();
        if (m_count > 0) {
            const int missing = 3 - m_count;
            m_held <<= 8 * missing;
            emit(4 - missing);
            m_signs.append(static_cast<std::size_t>(missing), '=');
        }
        return m_signs;
    }

private:
    void emit(int signs) {
        constexpr std::string_view kSigns =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        for (int i = 0; i < signs; ++i) {
            m_signs += kSigns[m_held >> (18 - 6 * i) & 63];
        }
        m_held = 0;
        m_count = 0;
    }

    std::string m_signs;
    std::uint32_t m_held = 0;
    int m_count = 0;
};

} // namespace knittsim::exports
