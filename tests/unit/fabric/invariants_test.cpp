// What must hold for every valid program. A failure shows the smallest program that fails.

#include "core/fabric/fabric_builder.h"
#include "core/formats/knitout/writer.h"
#include "tests/support/build.h"
#include "tests/support/fabric_form.h"
#include "tests/support/for_random_programs.h"
#include "tests/support/rewrite_program.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>

namespace knittsim::fabric {
namespace {

using machine::OperationKind;
using machine::Program;
using test::FabricForm;
using test::formOf;
using test::forRandomPrograms;
using test::KnownSeed;

constexpr int kPrograms = 100;

Fabric knitted(const Program& program) {
    return buildFabric(machine::Timeline(program, machine::genericProfile()));
}

/// Of diagrams that differ by third Reidemeister moves the books keep any one.
FabricForm form(const Program& program) {
    return withSortedCrossings(formOf(knitted(program)));
}

constexpr const char* kFree =
    "loops that faced each other from the beginning go past each other when a yarn has "
    "met them one by one";
constexpr const char* kOneByOne = "yarns that wait on one side of a needle are passed one by one";
constexpr const char* kBoth = "a third move in front of one strand and behind another";
constexpr const char* kKnownSide =
    "loops that came to face each other are passed in the order in which they stand";
constexpr const char* kSplit = "a loop parts from the one that was drawn through it in a split";
constexpr const char* kStack = "loops of a stack are passed back in their order";
constexpr const char* kMeet = "loops that part and meet again with nothing between are as if they had not";
constexpr const char* kLong = "more than 32 passings on one float";

/// The program with something in it that does nothing makes the same fabric, wherever it is put in. Small
/// programs are tried more often, so that shrinking finds the place again.
test::Property unchangedBy(test::Nothing nothing) {
    return [nothing](const Program& program) {
        const FabricForm plain = form(program);
        const std::uint32_t tries = program.operations.size() < 50 ? 200 : 8;
        for (std::uint32_t seed = 0; seed < tries; ++seed) {
            const Program changed = test::with(nothing, program, seed);
            const std::string failure = difference(plain, form(changed));
            if (!failure.empty()) {
                return failure + "\nWith:\n" + formats::knitout::write(changed);
            }
        }
        return std::string();
    };
}

TEST(Invariants, ARackThereAndBackIsNothing) {
    forRandomPrograms(kPrograms, {.operations = 150}, unchangedBy(test::Nothing::RackThereAndBack));
}

TEST(Invariants, ARackInStepsIsTheRack) {
    forRandomPrograms(kPrograms, {.operations = 150}, unchangedBy(test::Nothing::RackInSteps));
}

TEST(Invariants, ATransferThereAndBackIsNothing) {
    constexpr KnownSeed kKnown[] = {{360, kFree},  {194, "a tuck beside a loop that stands on a known side"},
                                    {520, kStack}, {800, kSplit},
                                    {923, kSplit}, {5488, kLong}};
    forRandomPrograms(kPrograms, {.operations = 150}, unchangedBy(test::Nothing::TransferThereAndBack),
                      kKnown);
}

TEST(Invariants, ATransferBeforeItsOppositeIsNothing) {
    forRandomPrograms(kPrograms, {.operations = 150}, unchangedBy(test::Nothing::TransferBeforeItsOpposite));
}

/// All but where the machine made it.
TEST(Invariants, ATuckIsATuckOnTheOtherBedTransferred) {
    forRandomPrograms(kPrograms, {.operations = 150}, [](const Program& program) {
        const FabricForm plain = withSortedCrossings(withoutMachine(formOf(knitted(program))));
        for (std::uint32_t seed = 0; seed < 8; ++seed) {
            const Program changed = test::withTuckFromTheOtherBed(program, seed);
            const FabricForm other = withSortedCrossings(withoutMachine(formOf(knitted(changed))));
            const std::string failure = difference(plain, other);
            if (!failure.empty()) {
                return failure + "\nWith:\n" + formats::knitout::write(changed);
            }
        }
        return std::string();
    });
}

TEST(Invariants, AMissThereAndBackIsNothing) {
    constexpr KnownSeed kKnown[] = {{72, kFree},       {360, kFree},      {1918, kFree},      {2113, kFree},
                                    {4981, kFree},     {672, kKnownSide}, {3178, kKnownSide}, {3723, kBoth},
                                    {4869, kOneByOne}, {5596, kOneByOne}, {5674, kBoth},      {509, kSplit},
                                    {4791, kStack},    {3097, kMeet},     {91, kLong}};
    forRandomPrograms(kPrograms, {.operations = 150}, unchangedBy(test::Nothing::MissThereAndBack), kKnown);
}

TEST(Invariants, ADropOfAnEmptyNeedleIsNothing) {
    forRandomPrograms(kPrograms, {.operations = 150}, unchangedBy(test::Nothing::DropOfNothing));
}

TEST(Invariants, TheOrderOfIndependentOperationsDoesNotMatter) {
    forRandomPrograms(kPrograms, {.operations = 150}, [](const Program& program) {
        return difference(form(program), form(test::withSwaps(program, 300, 7)));
    });
}

/// One course on both beds, the carriers taken out, and the transfers, racks and drops of `program`: no yarn
/// hangs in the way.
Program onlyLoops(const Program& program) {
    Program loops = test::program("in 1\nin 2\n" + test::pass("tuck", 'f', -4, 7, 1, 2) +
                                  test::pass("tuck", 'b', 7, -4, 2, 3) + "out 1\nout 2\n");
    for (const machine::Operation& op : program.operations) {
        if (op.kind == OperationKind::Rack || op.kind == OperationKind::Xfer ||
            op.kind == OperationKind::Drop) {
            loops.operations.push_back(op);
        }
    }
    return loops;
}

TEST(Invariants, MirroredTransfersMakeTheMirroredFabric) {
    forRandomPrograms(kPrograms, {.operations = 600}, [](const Program& program) {
        const Program loops = onlyLoops(program);
        return difference(withSortedCrossings(mirrored(form(loops))), form(test::mirrored(loops)));
    });
}

TEST(Invariants, TurnedTransfersMakeTheFabricSeenFromTheBack) {
    forRandomPrograms(kPrograms, {.operations = 600}, [](const Program& program) {
        const Program loops = onlyLoops(program);
        return difference(withSortedCrossings(turnedOver(form(loops))), form(test::turnedOver(loops)));
    });
}

TEST(Invariants, AMirroredProgramMakesTheMirroredFabric) {
    forRandomPrograms(20 * kPrograms, {.operations = 150}, [](const Program& program) {
        return difference(withSortedCrossings(mirrored(form(program))), form(test::mirrored(program)));
    });
}

/// Without racking: carriers rest with respect to the front bed while the rear bed racks, so that seen from
/// behind their yarns pass other loops on the way.
TEST(Invariants, TheTurnedProgramMakesTheFabricSeenFromTheBack) {
    forRandomPrograms(kPrograms, {.operations = 150, .maxRack = 0, .quarterRacks = false},
                      [](const Program& program) {
                          return difference(withSortedCrossings(turnedOver(form(program))),
                                            form(test::turnedOver(program)));
                      });
}

/// With racking and stacks, while no yarn hangs between the needles that move.
TEST(Invariants, TheTurnedProgramMakesTheFabricSeenFromTheBackWithRacks) {
    forRandomPrograms(2 * kPrograms, {.operations = 150}, [](const Program& all) {
        const Program program = test::withCarriersAsideAtRacks(all);
        return difference(withSortedCrossings(turnedOver(form(program))), form(test::turnedOver(program)));
    });
}

TEST(Invariants, LoopsAreConserved) {
    forRandomPrograms(kPrograms, {.operations = 300}, [](const Program& program) -> std::string {
        const machine::Timeline timeline(program, machine::genericProfile());
        const Fabric fabric = buildFabric(timeline);
        std::vector<int> places(fabric.loops.size(), 0);
        for (const auto& row : timeline.finalState().beds) {
            for (std::int32_t needle = row.first(); needle < row.end(); ++needle) {
                for (const LoopIndex loop : row.at(needle)) {
                    ++places[static_cast<std::size_t>(loop)];
                }
            }
        }
        for (std::size_t i = 0; i < fabric.loops.size(); ++i) {
            const auto index = static_cast<LoopIndex>(i);
            const Loop& loop = fabric.loops[i];
            const bool held = places[i] == 1;
            const bool bound = !fabric.drawnThrough(index).empty();
            const bool dropped = loop.end == Loop::End::Dropped;
            if (places[i] > 1 || held != loop.onNeedle || bound != (loop.end == Loop::End::Bound) ||
                (!held && !bound && !dropped) || (held && dropped)) {
                return "loop " + std::to_string(i) + " is lost or in two places";
            }
            for (const LoopIndex child : fabric.drawnThrough(index)) {
                if (std::ranges::count(fabric.made.parentsOf(child), index) != 1) {
                    return "loop " + std::to_string(child) + " is not drawn through its parent once";
                }
            }
        }
        return {};
    });
}

/// All yarn that the machine fed lies in the fabric, but for the one loose leg at either end of a yarn.
TEST(Invariants, YarnIsConserved) {
    forRandomPrograms(kPrograms, {.operations = 300}, [](const Program& program) -> std::string {
        const Fabric fabric = knitted(program);
        for (const Yarn& yarn : fabric.yarns) {
            const auto first = fabric.lengths.begin() + yarn.first;
            const double sum = std::accumulate(first, first + yarn.count, 0.0);
            double longest = 0;
            for (const machine::Loop& loop : fabric.made.loops) {
                longest = std::max(longest, loop.lengthMm);
            }
            if (yarn.lengthMm < sum - 1e-9 || yarn.lengthMm - sum > 2 * kLegShare * longest + 1e-9 ||
                std::any_of(first, first + yarn.count, [](double length) { return length < 0; })) {
                return "yarn of carrier " + std::to_string(yarn.carrier + 1) + ": " +
                       std::to_string(yarn.lengthMm) + " mm fed, " + std::to_string(sum) + " mm laid";
            }
        }
        return {};
    });
}

TEST(Invariants, EveryCrossingIsOnePlaceOfTwoStrands) {
    forRandomPrograms(kPrograms, {.operations = 300}, [](const Program& program) -> std::string {
        const Fabric fabric = knitted(program);
        for (std::size_t i = 0; i < fabric.crossings.size(); ++i) {
            const Crossing& crossing = fabric.crossings[i];
            const BondingPoint& over = fabric.points[static_cast<std::size_t>(crossing.over)];
            const BondingPoint& under = fabric.points[static_cast<std::size_t>(crossing.under)];
            const auto number = static_cast<std::int32_t>(i);
            if (over.entry != under.entry || over.crossing != number || under.crossing != number ||
                over.front != 1 || under.front != -1 || crossing.over == crossing.under ||
                fabric.at(over.entry).size() != 2) {
                return "crossing " + std::to_string(i);
            }
        }
        return {};
    });
}

} // namespace
} // namespace knittsim::fabric
