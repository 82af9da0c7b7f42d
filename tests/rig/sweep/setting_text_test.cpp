#include "rig/sweep/setting_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace foverig::sweep {
namespace {

using nlohmann::json;

TEST(SettingText, TakesTheLastPartsOfNamesAndFewDigits) {
    EXPECT_EQ(setting_text(json{{"foveation.p_min", 0.0123456}, {"pipeline", "full"}}),
              "p_min 0.01235, pipeline full");
}

// Noise of the headset and of the gaze tracker are two knobs.
TEST(SettingText, NamesInFullWhatEndsAlike) {
    EXPECT_EQ(setting_text(json{
                  {"faults.dk2.noise", 1}, {"faults.gaze.noise", 0.5}, {"foveation.r0_deg", 5}}),
              "faults.dk2.noise 1, faults.gaze.noise 0.5, r0_deg 5");
}

}  // namespace
}  // namespace foverig::sweep
