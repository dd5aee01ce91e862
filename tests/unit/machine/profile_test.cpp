#include "core/machine/profile.h"

#include <gmock/gmock.h>

#include <cmath>

namespace knittsim::machine {
namespace {

using ::testing::SizeIs;

const std::filesystem::path kFolder = std::filesystem::path(KNITTSIM_SOURCE_DIR) / "resources/machines";

const std::string kGood = R"({
    "id": "own", "name": "Own machine", "gauge_needles_per_inch": 12, "needles_per_bed": 300, "bed_gap_mm": 5,
    "rack": {"min": -4, "max": 6, "fractions": [0, 0.5]}, "carriers": ["1", "2"], "sliders": false,
    "inserting_hook": true, "hook_blocks_needles": 3, "carrier_stop_pitches": 1.5, "max_loops_on_needle": 4, "default_loop_length_mm": 5.5,
    "stitch_table": [{"number": 10, "loop_length_mm": 4}, {"number": 20, "loop_length_mm": 6}],
    "limits": {"float_mm": 30, "float_needles": 9, "held_passes": 7, "tucks_on_needle": 2, "stretch": 1.5}})";

std::string replaced(std::string text, const std::string& old, const std::string& now) {
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return text.replace(at, old.size(), now);
}

/// The one problem as "id key".
std::string problemOf(const std::string& old, const std::string& now) {
    const Result<MachineProfile> result = parseMachineProfile(replaced(kGood, old, now), "own.json");
    EXPECT_FALSE(result);
    EXPECT_THAT(result.diagnostics(), SizeIs(1));
    const Diagnostic& problem = result.diagnostics().front();
    return problem.id + ' ' + problem.arguments.at(0);
}

TEST(Profile, ReadsEveryKey) {
    const Result<MachineProfile> result = parseMachineProfile(kGood, "own.json");
    ASSERT_TRUE(result);
    const MachineProfile& profile = result.value();
    EXPECT_EQ(profile.id, "own");
    EXPECT_EQ(profile.name, "Own machine");
    EXPECT_DOUBLE_EQ(profile.pitchMm(), 25.4 / 12);
    EXPECT_EQ(profile.needlesPerBed, 300);
    EXPECT_EQ(profile.bedGapMm, 5);
    EXPECT_EQ(profile.minRack, -4);
    EXPECT_EQ(profile.maxRack, 6);
    EXPECT_EQ(profile.rackFractions, (std::vector<double>{0, 0.5}));
    EXPECT_EQ(profile.carriers, (std::vector<std::string>{"1", "2"}));
    EXPECT_FALSE(profile.sliders);
    EXPECT_TRUE(profile.insertingHook);
    EXPECT_EQ(profile.maxLoopsOnNeedle, 4);
    EXPECT_EQ(profile.defaultLoopLengthMm, 5.5);
    EXPECT_THAT(profile.stitchTable, SizeIs(2));
    EXPECT_EQ(profile.hookBlocksNeedles, 3);
    EXPECT_EQ(profile.carrierStopPitches, 1.5);
    EXPECT_EQ(profile.limits, (ProfileLimits{30, 9, 7, 2, 1.5}));
    EXPECT_DOUBLE_EQ(profile.bedLengthMm(), 635) << "300 needles of 12 to the inch";
}

TEST(Profile, TheSpeedIsAssumedUnlessTheProfileNamesIt) {
    EXPECT_TRUE(parseMachineProfile(kGood, "own.json")->speed.assumed);
    const std::string limits = "\"limits\"";
    const std::string speed =
        R"("speed": {"knit_m_per_s": 1.2, "transfer_m_per_s": 0.4, "turn_s": 0}, "limits")";
    const auto own = parseMachineProfile(replaced(kGood, limits, speed), "own.json");
    ASSERT_TRUE(own);
    EXPECT_EQ(own.value().speed, (ProfileSpeed{1.2, 0.4, 0, false}));
    EXPECT_EQ(
        problemOf(limits, R"("speed": {"knit_m_per_s": 0, "transfer_m_per_s": 1, "turn_s": 0}, "limits")"),
        "KS0004 speed.knit_m_per_s");
}

TEST(Profile, AWayTakesYarnBeyondThePlainSinker) {
    MachineProfile profile;
    profile.gauge = 25.4; // pitch 1 mm
    profile.bedGapMm = 3;
    EXPECT_DOUBLE_EQ(profile.extraYarnMm(1, false), 0); // the sinker of a plain loop
    EXPECT_DOUBLE_EQ(profile.extraYarnMm(0.5, false), 0);
    EXPECT_DOUBLE_EQ(profile.extraYarnMm(5, false), 4);
    EXPECT_DOUBLE_EQ(profile.extraYarnMm(4, true), 4); // the hypotenuse of 4 and 3
    EXPECT_DOUBLE_EQ(profile.extraYarnMm(0, true), 2); // straight across
}

TEST(Profile, LoopLengthIsLinearBetweenEntriesAndConstantOutside) {
    const Result<MachineProfile> result = parseMachineProfile(kGood, "own.json");
    ASSERT_TRUE(result);
    EXPECT_DOUBLE_EQ(result.value().loopLengthMm(0), 4);
    EXPECT_DOUBLE_EQ(result.value().loopLengthMm(10), 4);
    EXPECT_DOUBLE_EQ(result.value().loopLengthMm(12.5), 4.5);
    EXPECT_DOUBLE_EQ(result.value().loopLengthMm(20), 6);
    EXPECT_DOUBLE_EQ(result.value().loopLengthMm(99), 6);
    MachineProfile bare = result.value();
    bare.stitchTable.clear();
    EXPECT_DOUBLE_EQ(bare.loopLengthMm(15), 5.5);
}

TEST(Profile, WrongValuesAreNamed) {
    EXPECT_EQ(problemOf("\"gauge_needles_per_inch\": 12", "\"gauge_needles_per_inch\": 0"),
              "KS0004 gauge_needles_per_inch");
    EXPECT_EQ(problemOf("\"needles_per_bed\": 300,", ""), "KS0005 needles_per_bed");
    EXPECT_EQ(problemOf("\"min\": -4", "\"min\": 1"), "KS0004 rack.min");
    EXPECT_EQ(problemOf("[0, 0.5]", "[0.5]"), "KS0004 rack.fractions");
    EXPECT_EQ(problemOf("[0, 0.5]", "[0, 1.5]"), "KS0004 rack.fractions");
    EXPECT_EQ(problemOf("[\"1\", \"2\"]", "[\"1\", \"1\"]"), "KS0004 carriers");
    EXPECT_EQ(problemOf("[\"1\", \"2\"]", "[]"), "KS0004 carriers");
    EXPECT_EQ(problemOf("\"sliders\": false", "\"sliders\": 0"), "KS0004 sliders");
    EXPECT_EQ(problemOf("\"number\": 20", "\"number\": 10"), "KS0004 stitch_table.1.number");
    EXPECT_EQ(problemOf("\"loop_length_mm\": 6", "\"length\": 6, \"loop_length_mm\": 6"),
              "KS0004 stitch_table.1.length");
    EXPECT_EQ(problemOf("\"id\"", "\"colour\": 1, \"id\""), "KS0004 colour");
    EXPECT_EQ(problemOf("\"id\"", "\"bed_length_mm\": 700, \"id\""), "KS0004 bed_length_mm");
    EXPECT_EQ(problemOf("\"id\"", "\"machine_names\": [\"*\"], \"id\""), "KS0004 machine_names");
    EXPECT_EQ(problemOf("\"float_mm\": 30, ", ""), "KS0005 limits.float_mm");
    EXPECT_EQ(problemOf("\"tucks_on_needle\": 2", "\"tucks_on_needle\": 0"), "KS0004 limits.tucks_on_needle");
    EXPECT_EQ(problemOf("\"id\"", "\"checks_off\": {\"KS0233\": \"\"}, \"id\""), "KS0004 checks_off.KS0233");
}

TEST(Profile, SyntaxErrorTellsTheLine) {
    const Result<MachineProfile> result = parseMachineProfile(replaced(kGood, "\"min\"", "min"), "own.json");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.diagnostics()[0].id, "KS0003");
    EXPECT_EQ(result.diagnostics()[0].place.line, 3);
}

TEST(Profile, MissingFile) {
    const Result<MachineProfile> result = readMachineProfile(kFolder / "none.json");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.diagnostics()[0].id, "KS0001");
}

TEST(ShippedProfiles, GenericIsTheBuiltInOne) {
    const Result<MachineProfile> file = readMachineProfile(kFolder / "generic-e15.json");
    ASSERT_TRUE(file);
    const MachineProfile& a = file.value();
    const MachineProfile b = genericProfile();
    EXPECT_EQ(
        std::tie(a.id, a.name, a.gauge, a.needlesPerBed, a.bedGapMm, a.minRack, a.maxRack, a.rackFractions),
        std::tie(b.id, b.name, b.gauge, b.needlesPerBed, b.bedGapMm, b.minRack, b.maxRack, b.rackFractions));
    EXPECT_EQ(std::tie(a.machineNames, a.hookBlocksNeedles, a.carrierStopPitches, a.limits, a.checksOff),
              std::tie(b.machineNames, b.hookBlocksNeedles, b.carrierStopPitches, b.limits, b.checksOff));
    EXPECT_EQ(std::tie(a.carriers, a.sliders, a.insertingHook, a.maxLoopsOnNeedle, a.defaultLoopLengthMm,
                       a.stitchTable),
              std::tie(b.carriers, b.sliders, b.insertingHook, b.maxLoopsOnNeedle, b.defaultLoopLengthMm,
                       b.stitchTable));
}

TEST(ShippedProfiles, AreNamedByIdAndFeedWhatTheirGaugeKnits) {
    for (const char* id : {"generic-e15", "stoll-cms", "shima-swg", "kniterate"}) {
        const Result<MachineProfile> result = readMachineProfile(kFolder / (std::string(id) + ".json"));
        ASSERT_TRUE(result) << id;
        const MachineProfile& profile = result.value();
        EXPECT_EQ(profile.id, id);
        // Spencer, Knitting Technology: worsted count = gauge^2 / 9, tex = 885.8 / count; tightness sqrt(tex)
        // / mm.
        const double tightness = std::sqrt(885.8 * 9) / profile.gauge / profile.defaultLoopLengthMm;
        EXPECT_GT(tightness, 1.1) << id;
        EXPECT_LT(tightness, 1.6) << id;
        for (std::size_t i = 1; i < profile.stitchTable.size(); ++i) {
            EXPECT_GT(profile.stitchTable[i].second, profile.stitchTable[i - 1].second) << id;
        }
    }
}

} // namespace
} // namespace knittsim::machine
