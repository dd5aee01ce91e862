#include "core/machine/profile_library.h"
#include "tests/support/build.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace knittsim::machine {
namespace {

namespace fs = std::filesystem;

const fs::path kShipped = fs::path(KNITTSIM_SOURCE_DIR) / "resources/machines";

class Profiles : public testing::Test {
protected:
    /// The generic profile with some text replaced, as a user would begin.
    void addOwn(const char* file, const std::string& old, const std::string& now) {
        std::ostringstream text;
        text << std::ifstream(kShipped / "generic-e15.json").rdbuf();
        std::string json = text.str();
        const std::size_t at = json.find(old);
        ASSERT_NE(at, std::string::npos) << old;
        std::ofstream(m_own / file) << json.replace(at, old.size(), now);
    }

    ProfileLibrary read() { return ProfileLibrary::read({kShipped, m_own}, m_problems); }

    std::string chosen(const std::string& header, const std::string& wanted = {}) {
        Program program = test::program("in 1\nout 1\n");
        program.header.machine = header;
        const auto profile = chooseProfile(program, read(), wanted);
        m_problems = profile.diagnostics();
        return profile ? profile.value().id : std::string();
    }

    test::TemporaryFolder m_temporary;
    const fs::path m_own = m_temporary.path();
    Diagnostics m_problems;
};

TEST_F(Profiles, TheHeaderNamesTheMachine) {
    EXPECT_EQ(chosen(""), "generic-e15");
    EXPECT_EQ(chosen("SWG091N2"), "shima-swg");
    EXPECT_EQ(chosen("swgxyz"), "shima-swg");
    EXPECT_EQ(chosen("Kniterate"), "kniterate");
    EXPECT_EQ(chosen("stoll-cms"), "stoll-cms");
    EXPECT_TRUE(m_problems.empty());
}

TEST_F(Profiles, AnUnknownMachineIsTold) {
    EXPECT_EQ(chosen("Jenny"), "generic-e15");
    ASSERT_EQ(m_problems.size(), 1U);
    EXPECT_EQ(m_problems[0].id, "KS0242");
}

TEST_F(Profiles, TheUserDecides) {
    EXPECT_EQ(chosen("SWG091N2", "kniterate"), "kniterate");
    EXPECT_EQ(chosen("SWG091N2", "none"), "");
    ASSERT_EQ(m_problems.size(), 1U);
    EXPECT_EQ(m_problems[0].id, "KS0008");
}

TEST_F(Profiles, AnotherGaugeTakesOtherLoops) {
    Program program = test::program("in 1\nout 1\n");
    program.header.gauge = 7.5;
    const auto profile = chooseProfile(program, read());
    ASSERT_TRUE(profile);
    EXPECT_DOUBLE_EQ(profile.value().gauge, 7.5);
    EXPECT_DOUBLE_EQ(profile.value().defaultLoopLengthMm, 2 * genericProfile().defaultLoopLengthMm);
    EXPECT_DOUBLE_EQ(profile.value().bedGapMm, 2 * genericProfile().bedGapMm);
}

TEST_F(Profiles, OwnOnesAreAddedAndReplace) {
    const auto count = read().profiles().size();
    addOwn("mine.json", "\"id\": \"generic-e15\"", "\"id\": \"mine\", \"machine_names\": [\"Brother *\"]");
    EXPECT_EQ(read().profiles().size(), count + 1);
    EXPECT_EQ(chosen("brother KH-900"), "mine");
    addOwn("wide.json", "\"needles_per_bed\": 540,\n  \"bed_length_mm\": 914", "\"needles_per_bed\": 700");
    const ProfileLibrary library = read();
    EXPECT_EQ(library.profiles().size(), count + 1);
    EXPECT_EQ(library.find("generic-e15")->needlesPerBed, 700);
}

TEST_F(Profiles, AFaultyOneIsToldAndLeftOut) {
    addOwn("bad.json", "\"id\": \"generic-e15\"", "\"id\": \"bad\", \"speed\": 3");
    std::ofstream(m_own / "notes.schema.json") << "no profile";
    const ProfileLibrary library = read();
    EXPECT_EQ(library.find("bad"), nullptr);
    ASSERT_EQ(m_problems.size(), 1U);
    EXPECT_EQ(m_problems[0].id, "KS0004");
    EXPECT_EQ(m_problems[0].arguments[0], "speed");
}

TEST_F(Profiles, AddingCopiesWhatIsWithoutFault) {
    addOwn("new.txt", "\"id\": \"generic-e15\"", "\"id\": \"mine\"");
    const fs::path folder = m_own / "made" / "on demand";
    const auto added = addProfile(m_own / "new.txt", folder);
    ASSERT_TRUE(added);
    EXPECT_EQ(added.value().id, "mine");
    EXPECT_NE(ProfileLibrary::read({folder}, m_problems).find("mine"), nullptr);
    EXPECT_TRUE(m_problems.empty());
}

TEST_F(Profiles, AddingRefusesFaultsAndCopiesNothing) {
    const auto problem = [&](const char* now) {
        addOwn("new.txt", "\"id\": \"generic-e15\"", now);
        const auto added = addProfile(m_own / "new.txt", m_own / "made");
        return added ? "added"
                     : added.diagnostics().front().id + ' ' + added.diagnostics().front().arguments[0];
    };
    EXPECT_EQ(problem("\"id\": \"../up\""), "KS0004 id");
    EXPECT_EQ(problem("\"id\": \".hidden\""), "KS0004 id");
    EXPECT_EQ(problem("\"id\": \"a\", \"gauges\": 1"), "KS0004 gauges");
    EXPECT_EQ(problem("\"id\": \"a\", \"checks_off\": {\"no-such-rule\": \"why\"}"), "KS0008 rule");
    EXPECT_FALSE(fs::exists(m_own / "made"));
    EXPECT_EQ(addProfile(m_own / "none", m_own / "made").diagnostics().front().id, "KS0001");
    std::ofstream(m_own / "file") << "no folder";
    addOwn("new.txt", "\"id\": \"generic-e15\"", "\"id\": \"a\"");
    EXPECT_EQ(addProfile(m_own / "new.txt", m_own / "file").diagnostics().front().id, "KS0002");
}

TEST_F(Profiles, AMissingFolderIsEmpty) {
    fs::remove_all(m_own);
    EXPECT_NE(read().find("generic-e15"), nullptr);
    EXPECT_TRUE(m_problems.empty());
    EXPECT_EQ(ProfileLibrary::read({}, m_problems).profiles().size(), 1U) << "the built-in one";
}

TEST(ProfileFolders, TheEnvironmentNamesTheUsersFolder) {
    const char* before = std::getenv("KNITTSIM_MACHINES");
    const std::string kept = before == nullptr ? "" : before;
    setenv("KNITTSIM_MACHINES", "/own/machines", 1);
    EXPECT_THAT(profileFolders(), testing::ElementsAre(testing::_, fs::path("/own/machines")));
    before == nullptr ? unsetenv("KNITTSIM_MACHINES") : setenv("KNITTSIM_MACHINES", kept.c_str(), 1);
}

} // namespace
} // namespace knittsim::machine
