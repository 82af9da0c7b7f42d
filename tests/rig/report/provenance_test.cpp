#include "rig/report/provenance.h"

#include <gtest/gtest.h>

namespace foverig::report {
namespace {

using nlohmann::json;

/// Of a run whose devices came from there.
RunData run_from(const char* headset, const char* tracker) {
    RunData run;
    run.summary = {{"fixed_cost", false},
                   {"scenario",
                    {{"clock", "lockstep"},
                     {"cost", "measured"},
                     {"motion", {{"head", "look"}, {"gaze", "scan"}}}}},
                   {"devices",
                    {{"dk2", {{"origin", headset}}},
                     {"gaze", {{"origin", tracker}}},
                     {"panel", {{"origin", "simulated"}}}}}};
    return run;
}

TEST(Provenance, SaysWhatWasSimulatedAndThatTimesWereMeasured) {
    EXPECT_EQ(provenance(run_from("simulated", "simulated")),
              "Simulated: headset (the head moves as look), gaze tracker (the eyes move as scan), "
              "panel. Frame times are measured; waits and the devices' time are simulated "
              "(lockstep).");
}

TEST(Provenance, TellsRecordedAndRealDevicesFromSimulatedOnes) {
    RunData mixed = run_from("hardware", "simulated");
    mixed.summary["scenario"]["clock"] = "wall";
    EXPECT_EQ(provenance(mixed),
              "Simulated: gaze tracker (the eyes move as scan), panel. Real: headset. Frame times "
              "and waits are measured, in real time.");
    RunData replay = run_from("recorded", "recorded");
    replay.summary["devices"]["dk2"]["recorded_from"] = "hardware";
    replay.summary["devices"]["gaze"]["recorded_from"] = "simulated";
    replay.summary["fixed_cost"] = true;
    replay.summary["scenario"]["cost"] = "fixed:9";
    EXPECT_EQ(provenance(replay),
              "Simulated: panel. Recorded: headset (a real one), gaze tracker (a simulated one). "
              "Frame times are the scenario's (fixed:9), not measured.");
}

TEST(Provenance, SaysWhereNobodyKnowsWhatWasRecorded) {
    RunData replay = run_from("recorded", "simulated");
    for (int said = 0; said < 2; ++said) {
        EXPECT_NE(provenance(replay).find("Recorded: headset (real or simulated: the recording "
                                          "does not say). "),
                  std::string::npos)
            << provenance(replay);
        replay.summary["devices"]["dk2"]["recorded_from"] = nullptr;  // older runs lack the key
    }
}

// What stands before the eyes of who looks at an ordinary screen is no headset's panel.
TEST(Provenance, TellsAWindowOnAScreenFromThePanel) {
    RunData run = run_from("hardware", "hardware");
    run.summary["devices"]["panel"]["origin"] = "hardware";
    run.summary["scenario"]["display"]["kind"] = "headset";
    EXPECT_EQ(provenance(run).find("Real: headset, gaze tracker, panel. Frame times"), 0U)
        << provenance(run);
    for (const char* origin : {"window", "hardware"}) {
        run.summary["devices"]["panel"]["origin"] = origin;  // as runs say now, and said before
        run.summary["scenario"]["display"]["kind"] = "window";
        EXPECT_EQ(provenance(run).find("Real: headset, gaze tracker. Shown in a window on an "
                                       "ordinary screen, whose light is taken to come as a DK2 "
                                       "panel's would. Frame times"),
                  0U)
            << provenance(run);
    }
}

TEST(Provenance, NamesWhatWasMadeWorseOnPurpose) {
    RunData run = run_from("hardware", "simulated");
    run.summary["scenario"]["faults"] = {{"dk2", {{"noise", 1.0}}}, {"gaze", {{"blink", 12.0}}}};
    run.summary["scenario"]["tracking"] = {{"gaze_added_latency_ms", 40.0},
                                           {"gaze_added_noise_deg", 0.5}};
    const std::string text = provenance(run);
    EXPECT_NE(text.find("Faults injected: gaze.blink = 12.0. "), std::string::npos)
        << "none of a real headset: " << text;
    EXPECT_NE(text.find("Gaze made worse on purpose: 40 ms later, 0.5 degrees of noise. "),
              std::string::npos)
        << text;
}

TEST(Provenance, IsSilentAboutDevicesOfWhichTheRunSaysNothing) {
    RunData old = run_from("simulated", "simulated");
    for (auto& [name, device] : old.summary["devices"].items()) device.erase("origin");
    EXPECT_EQ(provenance(old).find("Frame times are measured"), 0U);
}

}  // namespace
}  // namespace foverig::report
