#pragma once
// A run of 12 frames at 75 Hz whose every instant is known; its seventh frame was dropped.
#include <filesystem>
#include <fstream>

#include "rig/records/frames_csv.h"
#include "rig/records/summary.h"
#include "rig/report/run_data.h"
#include "rig/scenario/write.h"

namespace foverig::test {

inline HostTime at_ms(double ms) {
    return HostTime(from_seconds(ms * 1e-3));
}

inline RunRecord frames_at_75_hz() {
    RunRecord run;
    for (int i = 0; i < 12; ++i) {
        FrameRecord f;
        const double t = 13.0 * i;
        f.frame = static_cast<std::uint32_t>(i);
        f.wake_up = f.begin = at_ms(t);
        f.pose = {at_ms(t - 2.0), at_ms(t - 1.0)};
        f.gaze = {at_ms(26.0 * (i / 2) - 12.0), at_ms(26.0 * (i / 2) - 4.0)};  // every other frame
        f.submit = at_ms(t + 8.0);
        f.present = at_ms(t + 9.0);
        f.vsync = f.aimed_vsync = at_ms(t + 13.0);
        f.shown_vsync = static_cast<std::uint64_t>(i + 1);
        f.photon = at_ms(t + 20.0);
        f.passes = {{"trace_primary", 5.0}, {"shade", 2.0 + (i % 2)}};
        f.render_ms = 7.5;
        f.cpu_ms = 14.0;
        f.all_pixels = 100;
        f.sampled_pixels = 40;
        if (i == 6) f.drop();
        run.frames.push_back(f);
    }
    PlannedEffect effect;
    effect.name = "area_light";
    effect.on = true;
    effect.because = "2 lights | <b>";
    effect.measured_ms = 1.25;
    run.plan = {effect};
    run.pipeline = "full";
    run.backend = "embree";
    return run;
}

/// As it comes back from its folder.
inline report::RunData some_run(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    const RunRecord run = frames_at_75_hz();
    report::RunData data;
    data.folder = folder;
    data.summary = summary_json(run, scenario_json(Scenario{}), BuildInfo{}, HostInfo{}, 1000);
    std::ofstream(folder / "summary.json") << data.summary.dump();
    std::ofstream(folder / "frames.csv") << frames_csv(run.frames, WallTimes::keep);
    return report::read_run(folder);
}

}  // namespace foverig::test
