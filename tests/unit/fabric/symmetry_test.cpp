#include "core/fabric/fabric_builder.h"
#include "tests/support/random_program.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <ostream>
#include <tuple>

namespace knittsim::fabric {
namespace {

using machine::Bed;

Bed otherBed(Bed bed) {
    switch (bed) {
    case Bed::Front:
        return Bed::Rear;
    case Bed::Rear:
        return Bed::Front;
    case Bed::FrontSlider:
        return Bed::RearSlider;
    case Bed::RearSlider:
        break;
    }
    return Bed::FrontSlider;
}

/// The program as a person on the left hand side of a mirror would write it.
machine::Program mirrored(machine::Program program) {
    for (machine::Operation& op : program.operations) {
        op.direction = opposite(op.direction);
        op.needle.index = -op.needle.index;
        op.target.index = -op.target.index;
        if (op.kind == machine::OperationKind::Rack) {
            op.value = -op.value;
        }
    }
    return program;
}

/// The program for somebody who stands behind the machine and calls the rear bed the front one.
machine::Program turnedOver(machine::Program program) {
    int lastRail = 0;
    for (const machine::Carrier& carrier : program.header.carriers) {
        lastRail = std::max(lastRail, carrier.rail);
    }
    for (machine::Carrier& carrier : program.header.carriers) {
        carrier.rail = lastRail - carrier.rail;
    }
    for (machine::Operation& op : program.operations) {
        op.direction = opposite(op.direction);
        op.needle = {otherBed(op.needle.bed), -op.needle.index};
        op.target = {otherBed(op.target.bed), -op.target.index};
    }
    return program;
}

Fabric build(machine::Program program) {
    return buildFabric(machine::Timeline(std::move(program), machine::genericProfile()));
}

struct Seen {
    LoopIndex over;
    bool overRight;
    LoopIndex under;
    bool underRight;
    int sign;
    auto operator<=>(const Seen&) const = default;

    friend std::ostream& operator<<(std::ostream& out, const Seen& s) {
        return out << s.over << (s.overRight ? 'r' : 'l') << " over " << s.under << (s.underRight ? 'r' : 'l')
                   << (s.sign > 0 ? '+' : '-');
    }
};

bool onLeg(const Fabric& fabric, PointIndex point) {
    const LoopIndex index = fabric.points[static_cast<std::size_t>(point)].loop;
    const Loop& loop = fabric.loops[static_cast<std::size_t>(index)];
    const auto [first, last] = std::minmax({loop.footLeft, loop.footRight});
    return loop.footLeft >= 0 && first < point && point < last;
}

/// Crossings in a fixed order. `legsOnly` leaves out those with floats. Leaves the exact leg out for floats.
std::vector<Seen> crossings(const Fabric& fabric, bool legsOnly) {
    std::vector<Seen> seen;
    for (const Crossing& crossing : fabric.crossings) {
        if (legsOnly && !(onLeg(fabric, crossing.over) && onLeg(fabric, crossing.under))) {
            continue;
        }
        const BondingPoint& over = fabric.points[static_cast<std::size_t>(crossing.over)];
        const BondingPoint& under = fabric.points[static_cast<std::size_t>(crossing.under)];
        const auto right = [&](PointIndex p, const BondingPoint& point) {
            return onLeg(fabric, p) && point.side == Side::Right;
        };
        seen.push_back(
            {over.loop, right(crossing.over, over), under.loop, right(crossing.under, under), crossing.sign});
    }
    std::ranges::sort(seen);
    return seen;
}

/// What stands in one list only.
std::vector<Seen> unmatched(const std::vector<Seen>& a, const std::vector<Seen>& b) {
    std::vector<Seen> only;
    std::ranges::set_symmetric_difference(a, b, std::back_inserter(only));
    return only;
}

/// Leaves out crossings that come once with each sign: where a float hangs between, the books keep both.
std::vector<Seen> net(std::vector<Seen> crossings) {
    std::vector<Seen> left;
    for (const Seen& s : crossings) {
        Seen inverse = s;
        inverse.sign = -s.sign;
        if (const auto found = std::ranges::find(left, inverse); found != left.end()) {
            left.erase(found);
        } else {
            left.push_back(s);
        }
    }
    std::ranges::sort(left);
    return left;
}

class Symmetry : public testing::TestWithParam<unsigned> {
protected:
    machine::Program m_program =
        test::randomProgram({.seed = GetParam(), .operations = 1200, .drops = false});
};

TEST_P(Symmetry, TheMirroredProgramHasMirroredCrossings) {
    const Fabric fabric = build(m_program);
    const Fabric other = build(mirrored(m_program));
    ASSERT_EQ(fabric.crossings.size(), other.crossings.size());
    std::vector<Seen> expected;
    for (Seen s : crossings(fabric, true)) {
        expected.push_back({s.over, !s.overRight, s.under, !s.underRight, -s.sign});
    }
    std::ranges::sort(expected);
    EXPECT_THAT(unmatched(crossings(other, true), expected), testing::IsEmpty());
}

TEST_P(Symmetry, FromBehindTheSameLoopsCross) {
    const Fabric fabric = build(m_program);
    const Fabric other = build(turnedOver(m_program));
    EXPECT_EQ(fabric.points.size() - fabric.crossings.size() * 2,
              other.points.size() - other.crossings.size() * 2);
    std::vector<Seen> expected;
    for (Seen s : crossings(fabric, true)) {
        expected.push_back({s.under, !s.underRight, s.over, !s.overRight, s.sign});
    }
    std::ranges::sort(expected);
    EXPECT_THAT(unmatched(net(crossings(other, true)), net(expected)), testing::IsEmpty());
}

TEST_P(Symmetry, TheMirroredProgramTakesTheSameYarn) {
    // Not so from behind: carriers rest with respect to the front bed while the rear bed racks.
    const Fabric fabric = build(m_program);
    const Fabric other = build(mirrored(m_program));
    ASSERT_EQ(fabric.yarns.size(), other.yarns.size());
    for (std::size_t y = 0; y < fabric.yarns.size(); ++y) {
        EXPECT_NEAR(fabric.yarns[y].lengthMm, other.yarns[y].lengthMm, 1e-6);
    }
}

TEST_P(Symmetry, BothStrandsOfACrossingShareItsPlace) {
    const Fabric fabric = build(m_program);
    for (std::size_t i = 0; i < fabric.crossings.size(); ++i) {
        const BondingPoint& over = fabric.points[static_cast<std::size_t>(fabric.crossings[i].over)];
        const BondingPoint& under = fabric.points[static_cast<std::size_t>(fabric.crossings[i].under)];
        ASSERT_EQ(over.entry, under.entry);
        ASSERT_EQ(over.crossing, static_cast<std::int32_t>(i));
        ASSERT_EQ(under.crossing, static_cast<std::int32_t>(i));
        ASSERT_EQ(over.front - under.front, 2);
        ASSERT_NE(fabric.crossings[i].over, fabric.crossings[i].under);
    }
}

TEST_P(Symmetry, LengthsAddUpToTheYarnFed) {
    const Fabric fabric = build(m_program);
    for (const Yarn& yarn : fabric.yarns) {
        double fed = 0;
        for (const machine::Loop& loop : fabric.made.loops) {
            if (loop.carrier == yarn.carrier) {
                fed += loop.lengthMm;
            }
        }
        const auto first = fabric.lengths.begin() + yarn.first;
        const double sum = std::accumulate(first, first + yarn.count, 0.0);
        EXPECT_LE(sum, yarn.lengthMm + 1e-9);
        EXPECT_GE(yarn.lengthMm - sum, 0);
        EXPECT_LE(yarn.lengthMm - sum, 20.0) << "only the ends are loose";
        EXPECT_GT(fed, 0);
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Symmetry, testing::Range(1U, 13U));

} // namespace
} // namespace knittsim::fabric
