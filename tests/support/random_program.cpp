#include "tests/support/random_program.h"

#include <array>
#include <cstdlib>
#include <map>
#include <random>
#include <utility>

namespace knittsim::test {

using machine::Bed;
using machine::CarrierIndex;
using machine::CarrierSet;
using machine::Direction;
using machine::Needle;
using machine::Operation;
using machine::OperationKind;
using machine::Program;

namespace {

class Generator {
public:
    explicit Generator(const RandomProgramOptions& options)
        : m_options(options), m_random(options.seed),
          m_in(static_cast<std::size_t>(options.carriers), false) {}

    Program run() {
        for (int i = 0; i < m_options.carriers; ++i) {
            m_program.header.carriers.push_back({std::to_string(i + 1), i, false, {}});
        }
        knitPass();
        while (static_cast<int>(m_program.operations.size()) < m_options.operations) {
            turn();
        }
        rackTo(0);
        for (int i = 0; i < m_options.carriers; ++i) {
            if (m_in[static_cast<std::size_t>(i)]) {
                Operation& op = add(OperationKind::Out);
                op.carriers.push(static_cast<CarrierIndex>(i));
            }
        }
        return std::move(m_program);
    }

private:
    /// 0 <= result < count. Not std::uniform_int_distribution, whose results differ between libraries.
    int below(int count) { return static_cast<int>(m_random() % static_cast<std::uint32_t>(count)); }
    bool chance(int percent) { return below(100) < percent; }

    Operation& add(OperationKind kind) {
        m_program.operations.emplace_back().kind = kind;
        return m_program.operations.back();
    }

    int& loops(Needle needle) { return m_loops[needle]; }

    bool aligned() const { return m_rack == static_cast<int>(m_rack); }

    Needle facing(Needle needle) const {
        const int rack = static_cast<int>(m_rack);
        return needle.bed == Bed::Front ? Needle{Bed::Rear, needle.index - rack}
                                        : Needle{Bed::Front, needle.index + rack};
    }

    bool canTransfer(Needle needle) {
        return m_options.transfers && m_options.rearBed && aligned() &&
               loops(needle) + loops(facing(needle)) <= m_options.maxLoops;
    }

    void turn() {
        const int what = below(100);
        if (what < 60) {
            knitPass();
        } else if (what < 80 && m_options.transfers && m_options.rearBed) {
            transfers();
        } else if (what < 90 && m_options.rearBed) {
            rackTo(chance(40) ? 0.0 : randomRack());
        } else if (what < 93 && m_options.drops) {
            drop();
        } else if (what < 97 && m_options.extensions) {
            extension();
        } else {
            knitPass();
        }
    }

    double randomRack() {
        const int whole = below(2 * m_options.maxRack + 1) - m_options.maxRack;
        constexpr std::array<double, 3> kParts{0.25, 0.5, 0.75};
        const bool room = whole < m_options.maxRack;
        return whole + (m_options.quarterRacks && room && chance(40)
                            ? kParts[static_cast<std::size_t>(below(3))]
                            : 0);
    }

    void rackTo(double rack) {
        if (rack != m_rack) {
            add(OperationKind::Rack).value = rack;
            m_rack = rack;
        }
    }

    CarrierSet randomCarriers() {
        CarrierSet set;
        set.push(static_cast<CarrierIndex>(below(m_options.carriers)));
        if (m_options.carriers > 1 && chance(15)) {
            const int second = (set[0] + 1 + below(m_options.carriers - 1)) % m_options.carriers;
            set.push(static_cast<CarrierIndex>(second));
        }
        for (const CarrierIndex carrier : set) {
            if (!m_in[carrier]) {
                add(OperationKind::In).carriers.push(carrier);
                m_in[carrier] = true;
            }
        }
        return set;
    }

    void knitPass() {
        const CarrierSet carriers = randomCarriers();
        const Direction direction = chance(50) ? Direction::Right : Direction::Left;
        const int first = m_options.firstNeedle + below(m_options.width);
        const int room = direction == Direction::Right ? m_options.firstNeedle + m_options.width - first
                                                       : first - m_options.firstNeedle + 1;
        const int length = 1 + below(room);
        const int bed = m_options.rearBed ? below(3) : 0; // front, rear, both
        for (int i = 0; i < length; ++i) {
            const int index = first + i * machine::sign(direction);
            if (bed == 2) {
                // At a whole racking facing needles are worked in turn, else in the order they lie.
                const bool frontFirst = !aligned() ? direction == Direction::Right : chance(50);
                stitch({frontFirst ? Bed::Front : Bed::Rear, index}, direction, carriers);
                if (!aligned()) {
                    stitch({frontFirst ? Bed::Rear : Bed::Front, index}, direction, carriers);
                }
            } else {
                stitch({bed == 0 ? Bed::Front : Bed::Rear, index}, direction, carriers);
            }
        }
    }

    OperationKind randomStitch(Needle needle, int yarns) {
        const int what = below(100);
        if (what < 70) {
            return OperationKind::Knit;
        }
        if (what < 82 && loops(needle) + yarns <= m_options.maxLoops) {
            return OperationKind::Tuck;
        }
        if (what < 88 && canTransfer(needle)) {
            return OperationKind::Split;
        }
        return what < 95 ? OperationKind::Miss : OperationKind::Knit;
    }

    void stitch(Needle needle, Direction direction, const CarrierSet& carriers) {
        const OperationKind kind = randomStitch(needle, carriers.size());
        Operation& op = add(kind);
        op.direction = direction;
        op.needle = needle;
        op.carriers = carriers;
        if (kind == OperationKind::Split) {
            op.target = facing(needle);
            loops(op.target) += loops(needle);
        }
        if (kind == OperationKind::Tuck) {
            loops(needle) += carriers.size();
        } else if (kind != OperationKind::Miss) {
            loops(needle) = carriers.size();
        }
    }

    Needle randomNeedle() {
        return {m_options.rearBed && chance(50) ? Bed::Rear : Bed::Front,
                m_options.firstNeedle + below(m_options.width)};
    }

    void transfers() {
        rackTo(below(2 * m_options.maxRack + 1) - m_options.maxRack);
        const int count = 1 + below(4);
        for (int i = 0; i < count; ++i) {
            const Needle from = randomNeedle();
            if (loops(from) > 0 && canTransfer(from)) {
                Operation& op = add(OperationKind::Xfer);
                op.needle = from;
                op.target = facing(from);
                loops(op.target) += std::exchange(loops(from), 0);
            }
        }
        if (chance(70)) {
            rackTo(0);
        }
    }

    void drop() {
        const Needle needle = randomNeedle();
        if (loops(needle) > 0) {
            add(OperationKind::Drop).needle = needle;
            loops(needle) = 0;
        }
    }

    void extension() {
        const int what = below(3);
        if (what == 0) {
            add(OperationKind::StitchNumber).value = below(100);
            return;
        }
        m_program.texts.emplace_back(what == 1 ? "#26c6f6" : "x-test-note " + std::to_string(below(100)));
        Operation& op = add(what == 1 ? OperationKind::Colour : OperationKind::Extension);
        op.text = static_cast<std::int32_t>(m_program.texts.size()) - 1;
        if (what == 1) {
            op.carriers.push(static_cast<CarrierIndex>(below(m_options.carriers)));
        }
    }

    RandomProgramOptions m_options;
    std::mt19937 m_random;
    Program m_program;
    std::map<Needle, int> m_loops;
    std::vector<bool> m_in;
    double m_rack = 0;
};

} // namespace

Program randomProgram(const RandomProgramOptions& options) {
    return Generator(options).run();
}

} // namespace knittsim::test
