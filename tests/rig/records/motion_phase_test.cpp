#include "rig/records/motion_phase.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "rig/session/session.h"
#include "tests/rig/session/fake_renderer.h"

namespace foverig {
namespace {

using std::chrono::milliseconds;

/// A frame each 10 ms whose head has that speed.
std::vector<FrameRecord> with_head_speeds(const std::vector<double>& speeds_deg_s) {
    std::vector<FrameRecord> frames(speeds_deg_s.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        frames[i].predicted_photon = HostTime(milliseconds(10 * static_cast<int>(i)));
        frames[i].true_head_speed_deg_s = speeds_deg_s[i];
    }
    return frames;
}

std::string letters(const std::vector<Phase>& phases) {
    std::string text;
    for (const Phase phase : phases) text += "ros"[static_cast<int>(phase)];
    return text;
}

TEST(MotionPhase, IsOnsetForATenthOfASecondAfterTheHeadBeginsToMove) {
    std::vector<double> speeds(20, 50.0);
    speeds[0] = speeds[1] = speeds[18] = speeds[19] = 1.0;
    EXPECT_EQ(letters(head_phases(with_head_speeds(speeds))),
              "rr"
              "ooooooooooo"
              "sssss"
              "rr");
}

TEST(MotionPhase, KnowsNoOnsetOfWhatMovesFromTheStart) {
    EXPECT_EQ(letters(head_phases(with_head_speeds({50, 50, 1, 50}))), "ssro");
}

TEST(MotionPhase, TakesTheRenderedPosesWhereNobodyKnowsTheTruth) {
    auto frames = with_head_speeds(std::vector<double>(6, 0.0));
    for (std::size_t i = 0; i < frames.size(); ++i) {
        frames[i].true_head_speed_deg_s.reset();
        const double turned_deg = i < 3 ? 0.0 : static_cast<double>(i - 2);  // 100 deg/s
        frames[i].world_from_head = glm::angleAxis(glm::radians(turned_deg), dvec3(0, 1, 0));
    }
    EXPECT_EQ(letters(head_phases(frames)), "rrrooo");
}

TEST(MotionPhase, BeginsASaccadeWhereTheKnownGazeJumps) {
    std::vector<FrameRecord> frames(16);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        frames[i].predicted_photon = HostTime(milliseconds(10 * static_cast<int>(i)));
        const float x = i < 3 ? 0.0F : 0.1F;
        frames[i].best_known_gaze[0] = glm::normalize(vec3(x, 0.0F, -1.0F));
        frames[i].saccade = i == 5;  // the tracker is late, and not asked
    }
    EXPECT_EQ(letters(gaze_phases(frames)),
              "sss"
              "ooooooooooo"
              "ss");
}

RunRecord turning(const char* head) {
    Scenario scenario;
    scenario.cost = "fixed:7";
    scenario.frames = 150;
    scenario.motion.head = head;
    Scene scene;
    scene.camera_path = {{vec3(0.0F, 1.6F, 4.0F), vec3(0.0F, 1.6F, 0.0F)}};
    FakeRenderer renderer;
    return Session(scenario, scene, renderer, nullptr).run({});
}

// A prediction with constant speed cannot know of a turn before it begins: there the picture lags
// by what was predicted over, 10 to 20 ms here; once the turn goes on, it does not (Warburton
// 2022).
TEST(MotionPhase, HasTheLagOfAHeadStepAtItsOnset) {
    const auto json = latency_by_phase_json(turning("step").frames);
    const auto& onset = json["head"]["onset"];
    ASSERT_TRUE(onset["head_lag"].is_object()) << json.dump(1);
    EXPECT_GT(onset["head_lag"]["max"].get<double>(), 5.0);
    EXPECT_LT(onset["head_lag"]["max"].get<double>(), 60.0);
    EXPECT_EQ(json["onset_ms"], 100.0);
}

TEST(MotionPhase, HasHardlyAnyLagInASteadyTurn) {
    const auto json = latency_by_phase_json(turning("look").frames);
    ASSERT_TRUE(json["head"]["steady"]["head_lag"].is_object()) << json.dump(1);
    EXPECT_LT(std::abs(json["head"]["steady"]["head_lag"]["p50"].get<double>()), 5.0);
    EXPECT_GT(json["head"]["rest"]["frames"].get<int>() +
                  json["head"]["onset"]["frames"].get<int>() +
                  json["head"]["steady"]["frames"].get<int>(),
              149);
}

}  // namespace
}  // namespace foverig
