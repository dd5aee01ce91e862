#include "core/base/file.h"
#include "core/formats/knitout/reader.h"
#include "core/pattern/catalogue.h"
#include "core/pattern/chart_edit.h"
#include "core/pattern/lift.h"
#include "core/pattern/move_plan.h"
#include "core/pattern/program_course.h"
#include "core/pattern/sample_charts.h"
#include "core/pattern/samples.h"
#include "core/pattern/swatch.h"
#include "core/yarn/yarn_library.h"
#include "knitted.h"
#include "tests/support/for_random_programs.h"
#include "tests/support/machine_data.h"
#include "tests/support/temporary_folder.h"

namespace knittsim::pattern {
namespace {

using machine::Operation;
using machine::OperationKind;
using machine::Program;

std::vector<machine::CarrierYarn> yarnsFor(const Program& program) {
    return machine::carrierYarns(program, yarn::YarnLibrary({}), yarn::defaultYarn());
}

Lifted lifted(const Program& program) {
    Result<Lifted> result = lift(program, machine::genericProfile(), yarnsFor(program));
    EXPECT_TRUE(result) << (result.diagnostics().empty() ? "" : result.diagnostics()[0].id);
    return result ? std::move(result).value() : Lifted{};
}

CompileOptions optionsFor(const Project& project) {
    return {.castOn = project.castOn,
            .ending = project.ending,
            .firstNeedle = project.firstNeedle,
            .machine = machine::genericProfile()};
}

/// Yarns of cells without yarn mean nothing, moves are done in the order of their plan.
Chart plainWords(Chart chart) {
    for (Cell& cell : chart.cells) {
        cell.yarn = isWorked(cell.stitch) ? cell.yarn : std::uint8_t{0};
    }
    for (Course& course : chart.courses) {
        std::vector<LoopMove> moves;
        for (const MoveStep& step : planMoves(course.moves)) {
            moves.insert(moves.end(), step.moves.begin(), step.moves.end());
        }
        course.moves = std::move(moves);
    }
    return chart;
}

class LiftedSample : public ::testing::TestWithParam<std::string> {};

std::vector<std::string> sampleIds() {
    std::vector<std::string> ids;
    for (const Sample& sample : samples()) {
        ids.push_back(sample.id);
    }
    return ids;
}

INSTANTIATE_TEST_SUITE_P(All, LiftedSample, ::testing::ValuesIn(sampleIds()), [](const auto& info) {
    std::string name = info.param;
    std::erase(name, '-');
    return name;
});

TEST_P(LiftedSample, IsTheVeryChart) {
    const Lifted back = lifted(makeSample(GetParam()));
    EXPECT_EQ(back.kept, 0) << (back.notes.empty() ? "" : back.notes[0].arguments[2]);
    const Chart expected = plainWords(sampleChart(GetParam()));
    const Chart found = plainWords(back.project.chart);
    EXPECT_EQ(found.width, expected.width);
    ASSERT_EQ(found.height(), expected.height());
    EXPECT_EQ(found.beds, expected.beds);
    EXPECT_EQ(found.yarns, expected.yarns);
    EXPECT_EQ(found.cells, expected.cells);
    EXPECT_EQ(found.courses, expected.courses);
    EXPECT_EQ(back.project.castOn, CastOn::Alternating);
    EXPECT_EQ(back.project.firstNeedle, kFirstNeedle);
}

/// What the machine is told, as knitout: without header, colours before the first stitch, and rackings and
/// stitch numbers that change nothing.
std::string ordersOf(const Program& program) {
    std::istringstream text(formats::knitout::write(program));
    std::string orders;
    std::string rack = "rack 0";
    std::string number;
    bool begun = false;
    for (std::string line; std::getline(text, line);) {
        begun = begun || line.rfind("knit ", 0) == 0 || line.rfind("tuck ", 0) == 0 ||
                line.rfind("miss ", 0) == 0 || line.rfind("split ", 0) == 0;
        if (line[0] == ';' || (!begun && line.rfind("x-vis-color", 0) == 0)) {
            continue;
        }
        for (const auto& [word, last] : {std::pair{"rack ", &rack}, {"x-stitch-number ", &number}}) {
            if (line.rfind(word, 0) == 0) {
                line = std::exchange(*last, line) == line ? std::string() : line;
            }
        }
        if (line.rfind("x-stitch-size ", 0) == 0 || line.rfind("stitch ", 0) == 0) {
            number.clear();
        }
        orders += line.empty() ? line : line + '\n';
    }
    return orders;
}

/// What is wrong with lifting a program and compiling it again on a machine with its carriers, or nothing.
std::string liftsAndComesBack(const Program& program) {
    machine::MachineProfile machine = machine::genericProfile();
    machine.carriers.clear();
    for (const machine::Carrier& carrier : program.header.carriers) {
        machine.carriers.push_back(carrier.name);
    }
    const auto back = lift(program, machine, yarnsFor(program));
    if (!back) {
        return back.diagnostics()[0].id == "KS0512" ? "" : "not lifted: " + back.diagnostics()[0].id;
    }
    CompileOptions options = optionsFor(back.value().project);
    options.machine = machine;
    const auto again = compile(back.value().project.chart, options);
    if (!again) {
        return "not compiled: " + again.diagnostics()[0].id;
    }
    const std::string expected = ordersOf(program);
    const std::string found = ordersOf(again.value());
    const auto differ = std::ranges::mismatch(found, expected);
    const auto around = [](const std::string& text, auto at) {
        const auto offset = static_cast<std::size_t>(at - text.begin());
        return text.substr(offset < 60 ? 0 : offset - 60, 120);
    };
    return found == expected ? ""
                             : "came back as\n" + around(found, differ.in1) + "\ninstead of\n" +
                                   around(expected, differ.in2);
}

TEST(Lift, AnyProgramComesBackAsItIs) {
    test::forRandomPrograms(150, {.operations = 120}, liftsAndComesBack);
    test::forRandomPrograms(50, {.operations = 120, .rearBed = false}, liftsAndComesBack);
}

TEST(Lift, AProjectFileKeepsWhatAChartCannotSay) {
    test::forRandomPrograms(40, {.operations = 120}, [](const Program& program) -> std::string {
        const auto back = lift(program, machine::genericProfile(), yarnsFor(program));
        if (!back) {
            return {};
        }
        const Project& project = back.value().project;
        const auto read = readProject(writeProject(project), "kept.knitt");
        if (!read) {
            return "not read: " + read.diagnostics()[0].id + ' ' + read.diagnostics()[0].arguments[0];
        }
        return read.value() == project ? "" : "another project";
    });
}

Program programOf(const std::string& text) {
    const auto program =
        formats::knitout::parse(";!knitout-2\n;;Carriers: 1 2 3 4 5 6 7 8 9 10\n" + text, "text.k");
    EXPECT_TRUE(program);
    return program ? program.value() : Program{};
}

// Course 2 has a pause, which no stitch says.
const char* const kPause = "inhook 1\n"
                           "knit - f4 1\nknit - f3 1\nknit - f2 1\nknit - f1 1\nreleasehook 1\n"
                           "pause look\nknit + f1 1\nknit + f2 1\nknit + f3 1\nknit + f4 1\n"
                           "knit - f4 1\nknit - f3 1\nknit - f2 1\nknit - f1 1\nouthook 1\n";

TEST(Lift, SaysWhichCoursesAreKeptAsTheyAre) {
    const Lifted back = lifted(programOf(kPause));
    EXPECT_EQ(back.project.chart.height(), 3);
    EXPECT_EQ(back.kept, 1);
    ASSERT_EQ(back.notes.size(), 1U);
    EXPECT_EQ(back.notes[0].id, "KS0511");
    EXPECT_EQ(back.notes[0].arguments[2], "2");
    EXPECT_EQ(back.project.chart.at(1, 1).stitch, Stitch::Knit);
}

TEST(Lift, AChangedCellTakesThePlaceOfItsOperationsAndTheOthersStay) {
    Lifted back = lifted(programOf(kPause));
    back.project.chart.at(1, 1).stitch = Stitch::Purl;
    const Program program = compiled(back.project.chart, optionsFor(back.project));
    const std::string orders = ordersOf(program);
    EXPECT_NE(orders.find("pause look\nxfer f2 b2\nknit + f1 1\nknit + b2 1\nknit + f3 1\nknit + f4 1\n"),
              std::string::npos)
        << orders;
    // The course above is knitted on the front bed again.
    EXPECT_NE(orders.find("xfer b2 f2\nknit - f4 1"), std::string::npos) << orders;
    knitted(program);
}

TEST(Lift, ACellChangedBackIsAsInTheProgram) {
    Lifted back = lifted(programOf(kPause));
    const Program before = compiled(back.project.chart, optionsFor(back.project));
    back.project.chart.at(1, 1).stitch = Stitch::Tuck;
    EXPECT_NE(ordersOf(compiled(back.project.chart, optionsFor(back.project))), ordersOf(before));
    back.project.chart.at(1, 1).stitch = Stitch::Knit;
    EXPECT_EQ(ordersOf(compiled(back.project.chart, optionsFor(back.project))), ordersOf(before));
}

TEST(Lift, AnotherYarnInAKeptCourseComesInAndGoesOut) {
    Lifted back = lifted(programOf(kPause));
    back.project.chart.yarns.push_back({"2", {}, ""});
    back.project.chart.at(2, 1).yarn = 1;
    const Program program = compiled(back.project.chart, optionsFor(back.project));
    const machine::Timeline timeline = knitted(program);
    EXPECT_FALSE(timeline.finalState().carriers[1].in);
    EXPECT_NE(ordersOf(program).find("inhook 2\nknit - f3 2\nreleasehook 2\nouthook 2\n"), std::string::npos)
        << ordersOf(program);
}

TEST(Lift, WalesPutInAndTakenOutLeaveTheRestOfTheProgram) {
    Lifted back = lifted(programOf(kPause));
    const std::string before = ordersOf(compiled(back.project.chart, optionsFor(back.project)));
    insertWales(back.project.chart, 2, 3);
    knitted(compiled(back.project.chart, optionsFor(back.project)));
    removeWales(back.project.chart, 2, 3);
    EXPECT_EQ(ordersOf(compiled(back.project.chart, optionsFor(back.project))), before);
}

TEST(Lift, ProgramsThatNoChartCanShowAreRefusedWithTheReason) {
    const auto idOf = [](const Program& program) {
        const auto result = lift(program, machine::genericProfile(), yarnsFor(program));
        return result ? std::string() : result.diagnostics()[0].id;
    };
    EXPECT_EQ(idOf(programOf("")), "KS0512");
    EXPECT_EQ(idOf(programOf("drop f4\n")), "KS0512");
    EXPECT_EQ(idOf(programOf("inhook 1\nknit - f3000 1\nknit - f1 1\n")), "KS0510");
}

TEST(Lift, CarriersThatTheMachineHasNotGetOthersAndAWord) {
    const auto program =
        formats::knitout::parse(";!knitout-2\n;;Carriers: A\nin A\nknit - f2 A\nknit - f1 A\nout A\n", "a.k");
    ASSERT_TRUE(program);
    const Lifted back = lifted(program.value());
    ASSERT_FALSE(back.notes.empty());
    EXPECT_EQ(back.notes[0].id, "KS0513");
    EXPECT_EQ(back.project.chart.yarns[0].carrier, machine::genericProfile().carriers[0]);
    compiled(back.project.chart, optionsFor(back.project));
}

TEST(Lift, FilesOfEveryKindBecomeProjects) {
    const std::filesystem::path patterns =
        std::filesystem::path(KNITTSIM_SOURCE_DIR) / "resources" / "patterns";
    const auto lace = readAnyProject(patterns / "lace.k");
    ASSERT_TRUE(lace);
    EXPECT_EQ(plainWords(lace.value().chart).courses, plainWords(sampleChart("lace")).courses);
    const test::TemporaryFolder folder;
    const std::filesystem::path file = folder / "lifted_lace.knitt";
    ASSERT_TRUE(writeFileAtomically(file, writeProject(lace.value())));
    const auto again = readAnyProject(file);
    ASSERT_TRUE(again);
    EXPECT_EQ(again.value(), lace.value());
    EXPECT_EQ(readAnyProject(patterns / "missing.k").diagnostics()[0].id, "KS0001");
}

TEST(Lift, RealProgramsComeBackAsTheyAre) {
    const std::filesystem::path folder = test::machineData();
    if (!std::filesystem::exists(folder)) {
        GTEST_SKIP() << "no machine data in " << folder;
    }
    int count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string extension = entry.path().extension().string();
        if (!entry.is_regular_file() || (extension != ".k" && extension != ".knitout") ||
            entry.file_size() > 600'000) {
            continue;
        }
        const auto program = formats::knitout::read(entry.path());
        if (!program) {
            continue;
        }
        EXPECT_EQ(liftsAndComesBack(program.value()), "") << entry.path();
        ++count;
    }
    EXPECT_GT(count, 0);
}

} // namespace
} // namespace knittsim::pattern
