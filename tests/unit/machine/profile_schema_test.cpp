// resources/machines/machine.schema.json says the same as the reader.

#include "core/machine/profile.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <set>

namespace knittsim::machine {
namespace {

using nlohmann::json;

const std::filesystem::path kFolder = std::filesystem::path(KNITTSIM_SOURCE_DIR) / "resources/machines";

json readJson(const char* name) {
    std::ifstream in(kFolder / name);
    return json::parse(in);
}

/// With all objects that a profile may have.
json genericWithSpeed() {
    json profile = readJson("generic-e15.json");
    profile["speed"] = {{"knit_m_per_s", 1.0}, {"transfer_m_per_s", 0.5}, {"turn_s", 0.5}};
    return profile;
}

std::string firstProblem(const json& profile) {
    const auto result = parseMachineProfile(profile.dump(), "changed.json");
    return result ? ""
                  : result.diagnostics().front().id + ' ' + result.diagnostics().front().arguments.front();
}

/// Calls test(object of the profile, its schema, path) for the profile itself and the objects in it.
template<class Test> void forObjects(json& profile, const json& schema, Test test) {
    test(profile, schema, std::string());
    for (const char* key : {"rack", "limits", "speed"}) {
        test(profile[key], schema["properties"][key], std::string(key) + '.');
    }
    test(profile["stitch_table"][0], schema["properties"]["stitch_table"]["items"], "stitch_table.0.");
}

TEST(ProfileSchema, RequiresWhatTheReaderRequires) {
    json profile = genericWithSpeed();
    const json schema = readJson("machine.schema.json");
    forObjects(profile, schema, [&](json& object, const json& part, const std::string& path) {
        for (const auto& [key, value] : part["properties"].items()) {
            const bool required = part["required"].get<std::set<std::string>>().contains(key);
            if (!object.contains(key)) {
                EXPECT_FALSE(required) << path << key;
                continue;
            }
            const json before = object;
            object.erase(key);
            EXPECT_EQ(firstProblem(profile), required ? "KS0005 " + path + key : "") << path << key;
            object = before;
        }
    });
}

TEST(ProfileSchema, KnowsNoKeyThatTheReaderDoesNot) {
    json profile = genericWithSpeed();
    profile["machine_names"] = {"Some*"};
    profile["checks_off"] = {{"long-float", "why not"}};
    profile["note"] = "all keys at once";
    const json schema = readJson("machine.schema.json");
    EXPECT_EQ(firstProblem(profile), "");
    forObjects(profile, schema, [&](json& object, const json& part, const std::string& path) {
        EXPECT_EQ(object.size(), part["properties"].size()) << path;
        EXPECT_EQ(part["additionalProperties"], false) << path;
    });
}

TEST(ProfileSchema, HasTheLimitsOfTheReader) {
    json profile = genericWithSpeed();
    const json schema = readJson("machine.schema.json");
    int limits = 0;
    forObjects(profile, schema, [&](json& object, const json& part, const std::string& path) {
        for (const auto& [key, value] : part["properties"].items()) {
            for (const auto& [limit, outwards] : {std::pair{"minimum", -1}, {"maximum", 1}}) {
                if (!value.contains(limit)) {
                    continue;
                }
                const json before = object;
                object[key] = value["type"] == "integer" ? json(value[limit].get<int>() + outwards)
                                                         : json(value[limit].get<double>() + 0.01 * outwards);
                EXPECT_EQ(firstProblem(profile), "KS0004 " + path + key) << limit;
                object = before;
                ++limits;
            }
        }
    });
    EXPECT_GT(limits, 20);
}

} // namespace
} // namespace knittsim::machine
