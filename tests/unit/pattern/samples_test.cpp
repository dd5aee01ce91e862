#include "core/base/file.h"
#include "core/formats/knitout/reader.h"
#include "core/pattern/samples.h"
#include "core/yarn/yarn_library.h"
#include "knitted.h"

#include <cmath>
#include <map>
#include <set>

namespace knittsim::pattern {
namespace {

using machine::Bed;
using machine::CarrierIndex;
using machine::Direction;
using machine::Loop;
using machine::LoopIndex;
using machine::Needle;
using machine::Operation;
using machine::OperationKind;
using machine::Program;
using machine::Timeline;
using ::testing::AllOf;
using ::testing::Each;
using ::testing::Ge;
using ::testing::IsEmpty;
using ::testing::Le;
using ::testing::SizeIs;
using ::testing::UnorderedElementsAreArray;

const std::filesystem::path kResources = std::filesystem::path(KNITTSIM_SOURCE_DIR) / "resources";

class EverySample : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Samples, EverySample, ::testing::ValuesIn([] {
                             std::vector<std::string> ids;
                             for (const Sample& sample : samples()) {
                                 ids.push_back(sample.id);
                             }
                             return ids;
                         }()),
                         [](const auto& info) {
                             std::string name = info.param;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

TEST_P(EverySample, FileInResourcesIsWhatTheCompilerMakes) {
    const Result<std::string> file = readFile(kResources / "patterns" / (GetParam() + ".k"));
    ASSERT_TRUE(file);
    EXPECT_EQ(file.value(), sampleText(GetParam()));
}

TEST_P(EverySample, ReaderFindsNothingWrongAndTheSameOperations) {
    const Result<Program> read = formats::knitout::parse(sampleText(GetParam()), GetParam());
    ASSERT_TRUE(read);
    EXPECT_THAT(read.diagnostics(), IsEmpty());
    std::vector<Operation> operations = read.value().operations;
    for (Operation& operation : operations) {
        operation.line = -1;
    }
    EXPECT_EQ(operations, makeSample(GetParam()).operations);
    EXPECT_EQ(read.value().header, makeSample(GetParam()).header);
}

TEST_P(EverySample, MachineFindsNothingWrong) {
    const Program program = makeSample(GetParam());
    const machine::MachineProfile machine = machine::genericProfile();
    const Timeline timeline = knitted(program);
    for (const Operation& operation : program.operations) {
        if (operation.kind == OperationKind::Rack) {
            EXPECT_THAT(operation.value, AllOf(Ge(machine.minRack), Le(machine.maxRack)));
        }
    }
    for (machine::OperationIndex k = 0; k <= timeline.operationCount(); k += 7) {
        const machine::MachineState state = timeline.stateAfter(k);
        for (const Bed bed : {Bed::Front, Bed::Rear}) {
            for (int needle = 0; needle < 40; ++needle) {
                EXPECT_THAT(state.loopsOn({bed, needle}),
                            SizeIs(Le(static_cast<std::size_t>(machine.maxLoopsOnNeedle))));
            }
        }
    }
    for (const machine::CarrierState& carrier : timeline.finalState().carriers) {
        EXPECT_FALSE(carrier.in);
    }
}

TEST_P(EverySample, MakesTheLoopsOfItsChart) {
    const Chart chart = sampleChart(GetParam());
    std::size_t expected = 0;
    for (const Cell& cell : chart.cells) {
        expected += cell.stitch == Stitch::Both                            ? 2
                    : isWorked(cell.stitch) && cell.stitch != Stitch::Miss ? 1
                                                                           : 0;
    }
    std::size_t wales = 0; // that the cast-on is for
    for (int wale = 0; wale < chart.width; ++wale) {
        wales += chart.at(wale, 0).stitch != Stitch::Empty ? 1 : 0;
    }
    const std::size_t castOn = chart.beds == BedUse::Double ? 2 * wales : wales;
    std::size_t joins = 0;
    const Program program = makeSample(GetParam());
    if (GetParam() == "intarsia") {
        // Two joins in every course of three zones; the cast-on and the chart have no other tuck beyond
        // `wales`.
        joins = static_cast<std::size_t>(count(program, OperationKind::Tuck)) - castOn;
        EXPECT_EQ(joins, 2U * 30U);
    }
    EXPECT_THAT(knitted(program).loops().loops, SizeIs(castOn + expected + joins));
}

TEST_P(EverySample, NoLoopIsLostOnTheWay) {
    const Timeline timeline = knitted(makeSample(GetParam()));
    std::set<LoopIndex> caught;
    for (std::size_t i = 0; i < timeline.loops().loops.size(); ++i) {
        const auto parents = timeline.loops().parentsOf(static_cast<LoopIndex>(i));
        caught.insert(parents.begin(), parents.end());
    }
    for (const Bed bed : {Bed::Front, Bed::Rear}) {
        for (int needle = 0; needle < 40; ++needle) {
            const auto held = timeline.finalState().loopsOn({bed, needle});
            caught.insert(held.begin(), held.end());
        }
    }
    EXPECT_EQ(caught.size(), timeline.loops().loops.size());
}

TEST_P(EverySample, NamesYarnsOfTheLibraryAndDifferentColours) {
    const Result<yarn::YarnLibrary> library = yarn::YarnLibrary::read(kResources / "yarns");
    ASSERT_TRUE(library);
    const Chart chart = sampleChart(GetParam());
    std::set<std::vector<int>> colours;
    for (const ChartYarn& y : chart.yarns) {
        EXPECT_NE(library.value().find(y.libraryId), nullptr) << y.libraryId;
        colours.insert({y.colour.r, y.colour.g, y.colour.b});
    }
    EXPECT_THAT(colours, SizeIs(chart.yarns.size()));
}

TEST(Samples, FolderHoldsTheSamplesAndNothingElse) {
    std::vector<std::string> expected;
    for (const Sample& sample : samples()) {
        expected.push_back(sample.id + ".k");
        EXPECT_FALSE(sample.title.empty() || sample.description.empty());
    }
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(kResources / "patterns")) {
        if (entry.path().extension() == ".k") {
            found.push_back(entry.path().filename().string());
        }
    }
    EXPECT_THAT(found, UnorderedElementsAreArray(expected));
    EXPECT_GE(found.size(), 14U);
}

TEST(Samples, UnknownIdGivesNothing) {
    EXPECT_TRUE(sampleText("no-such-sample").empty());
    EXPECT_TRUE(makeSample("no-such-sample").operations.empty());
}

/// Longest way of each carrier between two of its stitches, in pitches.
double longestWay(const Program& program) {
    std::map<CarrierIndex, double> last;
    double longest = 0;
    double rack = 0;
    for (const Operation& op : program.operations) {
        rack = op.kind == OperationKind::Rack ? op.value : rack;
        if (op.kind == OperationKind::InHook) {
            last.erase(op.carriers[0]);
        }
        if (!makesLoop(op.kind)) {
            continue;
        }
        const double at = positionPitches(op.needle, rack);
        if (const auto before = last.find(op.carriers[0]); before != last.end()) {
            longest = std::max(longest, std::abs(at - before->second));
        }
        last[op.carriers[0]] = at;
    }
    return longest;
}

TEST(Samples, YarnsTakeNoLongWays) {
    for (const char* id : {"plain", "rib-1x1", "cable-left", "cable-braid", "lace", "transfer-demo"}) {
        EXPECT_LE(longestWay(makeSample(id)), 2) << id;
    }
    EXPECT_EQ(longestWay(makeSample("float-jacquard")), 6) << "floats behind at most five needles";
    EXPECT_LE(longestWay(makeSample("intarsia")), 3) << "every carrier stays in its zone";
    EXPECT_LE(longestWay(makeSample("short-rows")), 2) << "the carrier turns where it tucks";
}

TEST(Samples, JacquardGivesEveryNeedleOneYarnACourse) {
    const Chart chart = sampleChart("float-jacquard");
    const Program program = makeSample("float-jacquard");
    std::vector<const Operation*> knits;
    for (const Operation& op : program.operations) {
        if (op.kind == OperationKind::Knit) {
            knits.push_back(&op);
        }
    }
    const auto wales = static_cast<std::size_t>(chart.width);
    ASSERT_EQ(knits.size(), chart.cells.size());
    for (std::size_t course = 0; course < chart.courses.size(); ++course) {
        std::map<int, CarrierIndex> byWale;
        for (std::size_t i = 0; i < wales; ++i) {
            const Operation& op = *knits[course * wales + i];
            byWale[op.needle.index - 1] = op.carriers[0];
        }
        ASSERT_EQ(byWale.size(), wales);
        for (const auto& [wale, carrier] : byWale) {
            const Cell& cell = chart.at(wale, static_cast<int>(course));
            EXPECT_EQ(program.header.carriers[carrier].name, chart.yarns[cell.yarn].carrier);
        }
    }
}

TEST(Samples, TubeRunsRoundWithoutATransfer) {
    const Program program = makeSample("tube");
    EXPECT_EQ(count(program, OperationKind::Xfer), 0);
    for (const Operation& op : program.operations) {
        if (makesLoop(op.kind)) {
            EXPECT_EQ(op.direction, op.needle.bed == Bed::Front ? Direction::Left : Direction::Right);
        }
    }
}

TEST(Samples, LaceHasAnEyeletForEveryStackedLoop) {
    const Timeline timeline = knitted(makeSample("lace"));
    int eyelets = 0;
    int doubles = 0;
    int triples = 0;
    for (const Loop& loop : timeline.loops().loops) {
        if (loop.kind == OperationKind::Knit) {
            eyelets += loop.parentCount == 0 ? 1 : 0;
            doubles += loop.parentCount == 2 ? 1 : 0;
            triples += loop.parentCount == 3 ? 1 : 0;
        }
    }
    // 3 repeats across and 3 up, 4 pairs each; the last pair stacks three loops.
    EXPECT_EQ(eyelets, 3 * 3 * 4 * 2);
    EXPECT_EQ(triples, 3 * 3);
    EXPECT_EQ(doubles + 2 * triples, eyelets);
}

TEST(Samples, TransferDemoNarrowsByOneWaleASide) {
    const Timeline timeline = knitted(makeSample("transfer-demo"));
    int held = 0;
    for (int needle = 1; needle <= 28; ++needle) {
        held += static_cast<int>(timeline.finalState().loopsOn({Bed::Front, needle}).size());
    }
    EXPECT_EQ(held, 28 - 2 * 8);
}

TEST(Samples, CablesCrossInOppositeOrder) {
    const auto firstRack = [](const char* id) {
        for (const Operation& op : makeSample(id).operations) {
            if (op.kind == OperationKind::Rack) {
                return op.value;
            }
        }
        return 0.0;
    };
    EXPECT_EQ(firstRack("cable-left"), -2);
    EXPECT_EQ(firstRack("cable-right"), 2);
}

} // namespace
} // namespace knittsim::pattern
