#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <string_view>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maxSize);

namespace {

/// Changes whole lines, so that most inputs stay programs and reach the machine and the fabric.
class LineMutator {
public:
    LineMutator(std::string_view text, unsigned seed) : m_random(seed) {
        while (!text.empty()) {
            const std::size_t end = text.find('\n');
            m_lines.emplace_back(text.substr(0, end));
            text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        }
        if (m_lines.size() < 2) {
            m_lines = {";!knitout-2", ";;Carriers: 1 2 3"};
        }
    }

    std::string run() {
        for (int i = 1 + below(4); i > 0; --i) {
            change();
        }
        std::string text;
        for (const std::string& line : m_lines) {
            text += line + '\n';
        }
        return text;
    }

private:
    int below(int count) { return static_cast<int>(m_random() % static_cast<unsigned>(count)); }
    auto place() { return m_lines.begin() + below(static_cast<int>(m_lines.size())); }

    /// Where a line may be put in: behind the first two, which hold magic and carriers.
    auto gap() { return m_lines.begin() + 2 + below(static_cast<int>(m_lines.size()) - 1); }

    void change() {
        switch (below(6)) {
        case 0:
            if (m_lines.size() > 2) {
                m_lines.erase(m_lines.begin() + 2 + below(static_cast<int>(m_lines.size()) - 2));
            }
            break;
        case 1:
            m_lines.insert(gap(), std::string(*place()));
            break;
        case 2:
            std::iter_swap(place(), place());
            break;
        default:
            m_lines.insert(gap(), operation());
            break;
        }
    }

    std::string needle() {
        constexpr std::array<const char*, 6> kBeds{"f", "b", "f", "b", "fs", "bs"};
        const int index = below(40) == 0 ? below(9000) - 4500 : below(6) - 1;
        return kBeds[static_cast<std::size_t>(below(6))] + std::to_string(index);
    }

    std::string direction() { return below(2) == 0 ? " + " : " - "; }
    std::string carriers() { return below(4) == 0 ? " 1 2" : ' ' + std::to_string(1 + below(3)); }

    std::string racking() {
        constexpr std::array<const char*, 6> kParts{"", "", "", ".25", ".5", ".75"};
        return std::to_string(below(7) - 3) + kParts[static_cast<std::size_t>(below(6))];
    }

    std::string operation() {
        constexpr std::array<const char*, 5> kYarnMoves{"knit", "knit", "tuck", "miss", "x-yarn-in"};
        constexpr std::array<const char*, 7> kCarrierMoves{"in",      "inhook", "releasehook", "out",
                                                           "outhook", "in",     "in"};
        const int what = below(20);
        if (what < 9) {
            return kYarnMoves[static_cast<std::size_t>(below(5))] + direction() + needle() + carriers();
        }
        if (what < 12) {
            return "xfer " + needle() + ' ' + needle();
        }
        if (what < 14) {
            const int index = below(5);
            return "split" + direction() + 'f' + std::to_string(index) + " b" + std::to_string(index) +
                   carriers();
        }
        if (what < 16) {
            return "rack " + racking();
        }
        if (what < 18) {
            return kCarrierMoves[static_cast<std::size_t>(below(7))] + carriers();
        }
        return what == 18 ? "drop " + needle() : "x-stitch-number " + std::to_string(below(120));
    }

    std::minstd_rand m_random;
    std::vector<std::string> m_lines;
};

} // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t maxSize,
                                               unsigned seed) {
    if (seed % 4 == 0) {
        return LLVMFuzzerMutate(data, size, maxSize);
    }
    const std::string text = LineMutator({reinterpret_cast<const char*>(data), size}, seed).run();
    const std::size_t count = std::min(text.size(), maxSize);
    std::memcpy(data, text.data(), count);
    return count;
}
