#include "rig/compare/comparable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rig/failure.h"

namespace foverig::compare {
namespace {

using testing::HasSubstr;

report::RunData run_of(const char* name) {
    report::RunData run;
    run.folder = name;
    run.summary = {{"scenario",
                    {{"scene", "cornell"},
                     {"seed", 1},
                     {"display", {{"rate_hz", 75.0}, {"eyes", 2}}},
                     {"camera", {{"keys_m", {1.0, 2.0}}}}}},
                   {"build", {{"type", "Release"}, {"backend", "embree"}, {"git", "abc"}}},
                   {"host", {{"cpu", "Xeon"}, {"cores", 2}, {"os", nullptr}}}};
    return run;
}

std::string complaint(const report::RunData& other, std::vector<std::string> allowed = {}) {
    try {
        check_comparable({run_of("a"), run_of("a2"), other}, allowed);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

TEST(Comparable, AreRunsThatDifferInTheProgramAlone) {
    report::RunData other = run_of("b");
    other.summary["build"]["git"] = "def";
    other.summary["build"]["version"] = "0.2";
    EXPECT_EQ(complaint(other), "");
}

TEST(Comparable, AreNotRunsOfAnythingElse) {
    const auto changed = [](const char* pointer, nlohmann::json value) {
        report::RunData run = run_of("b");
        run.summary[nlohmann::json::json_pointer(pointer)] = std::move(value);
        return complaint(run);
    };
    EXPECT_THAT(changed("/scenario/scene", "atrium"),
                HasSubstr("a and b cannot be compared: scene is \"cornell\" and \"atrium\""));
    EXPECT_THAT(changed("/scenario/display/eyes", 1), HasSubstr("display.eyes is 2 and 1"));
    EXPECT_THAT(changed("/scenario/camera/keys_m", {1.0}), HasSubstr("camera.keys_m"));
    EXPECT_THAT(changed("/scenario/faults", {{"dk2", {{"noise", 1.0}}}}),
                HasSubstr("faults.dk2.noise is absent and 1.0"));
    EXPECT_THAT(changed("/build/type", "Debug"), HasSubstr("build.type"));
    EXPECT_THAT(changed("/build/backend", "host-bvh"), HasSubstr("build.backend"));
    EXPECT_THAT(changed("/host/cores", 64), HasSubstr("--allow host.cores"));
    EXPECT_THAT(changed("/devices/dk2/origin", "hardware"),
                HasSubstr("devices.dk2.origin is absent and \"hardware\""));
    EXPECT_EQ(changed("/devices/dk2/origin", "simulated"), "") << "as before runs said so";
}

TEST(Comparable, MayBeWidened) {
    report::RunData other = run_of("b");
    other.summary["scenario"]["seed"] = 2;
    other.summary["host"]["cores"] = 4;
    EXPECT_EQ(complaint(other, {"seed", "host.cores"}), "");
    EXPECT_THAT(complaint(other, {"seed"}), HasSubstr("host.cores"));
    EXPECT_THAT(complaint(other, {"seeds"}), HasSubstr("nearest is seed"));
}

}  // namespace
}  // namespace foverig::compare
