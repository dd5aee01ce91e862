// What must hold for every valid program. A failure shows the smallest program that fails.

#include "core/fabric/fabric_builder.h"
#include "core/formats/knitout/writer.h"
#include "tests/support/fabric_form.h"
#include "tests/support/for_random_programs.h"
#include "tests/support/rewrite_program.h"

#include <gmock/gmock.h>

namespace knittsim::fabric {
namespace {

using machine::Program;
using test::FabricForm;
using test::formOf;
using test::forRandomPrograms;

constexpr int kPrograms = 300;

Fabric knitted(const Program& program) {
    return buildFabric(machine::Timeline(program, machine::genericProfile()));
}

/// Of diagrams that differ by third Reidemeister moves the books keep any one.
FabricForm form(const Program& program) {
    return withSortedCrossings(formOf(knitted(program)));
}

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
    forRandomPrograms(kPrograms, {.seed = 1000, .operations = 150},
                      unchangedBy(test::Nothing::RackThereAndBack));
}

TEST(Invariants, ARackInStepsIsTheRack) {
    forRandomPrograms(kPrograms, {.seed = 1000, .operations = 150}, unchangedBy(test::Nothing::RackInSteps));
}

TEST(Invariants, ATransferThereAndBackIsNothing) {
    forRandomPrograms(kPrograms, {.seed = 1000, .operations = 150},
                      unchangedBy(test::Nothing::TransferThereAndBack));
}

TEST(Invariants, AMissThereAndBackIsNothing) {
    forRandomPrograms(kPrograms, {.seed = 1000, .operations = 150},
                      unchangedBy(test::Nothing::MissThereAndBack));
}

TEST(Invariants, ADropOfAnEmptyNeedleIsNothing) {
    forRandomPrograms(kPrograms, {.seed = 1000, .operations = 150},
                      unchangedBy(test::Nothing::DropOfNothing));
}

TEST(Invariants, TheOrderOfIndependentOperationsDoesNotMatter) {
    forRandomPrograms(kPrograms, {.seed = 1000, .operations = 150}, [](const Program& program) {
        return difference(form(program), form(test::withSwaps(program, 300, 7)));
    });
}

TEST(Invariants, AMirroredProgramMakesTheMirroredFabric) {
    forRandomPrograms(kPrograms, {.seed = 1000, .operations = 150}, [](const Program& program) {
        return difference(withSortedCrossings(mirrored(form(program))), form(test::mirrored(program)));
    });
}

TEST(Invariants, TheTurnedProgramMakesTheFabricSeenFromTheBack) {
    forRandomPrograms(kPrograms, {.operations = 150, .maxRack = 0, .quarterRacks = false},
                      [](const Program& program) {
                          return difference(withSortedCrossings(turnedOver(form(program))),
                                            form(test::turnedOver(program)));
                      });
}

} // namespace
} // namespace knittsim::fabric
