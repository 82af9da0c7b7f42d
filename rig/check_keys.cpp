#include "rig/check_keys.h"

#include <nlohmann/json.hpp>
#include <string_view>

#include "rig/records/summary.h"
#include "rig/scenario/write.h"

namespace foverig {
namespace {

constexpr std::string_view kPasses = "pass_time_ms.";
constexpr const char* kAnyPass = "NAME";

/// A frame that has every number.
FrameRecord whole_frame() {
    FrameRecord frame;
    frame.pose = frame.gaze = frame.warp = frame.see_through = SampleInstants{};
    frame.vsync = frame.photon = frame.readback_scan_out = HostTime{};
    frame.photon_eye = {HostTime{}, HostTime{}};
    frame.shown_vsync = 0;
    frame.prediction_error_deg = frame.gaze_error_deg = 0.0;
    frame.head_lag_ms = 0.0;
    frame.all_pixels = 1;
    frame.passes = {{kAnyPass, 0.0}};
    return frame;
}

DeviceRecord device(const char* name, Troubles troubles) {
    return {.name = name, .counts = {}, .rate_hz = {}, .troubles = std::move(troubles)};
}

/// What a run can leave, with numbers that mean nothing. What this one will not have (a recording)
/// is there too: it is absent then, and a check of what is absent fails.
nlohmann::json summary_of_any_run(const Scenario& scenario) {
    RunRecord run;
    run.frames = {whole_frame()};
    run.devices = {device("dk2", by_key(HeadsetTroubles{})),
                   device("gaze", by_key(GazeTroubles{}))};
    if (scenario.tracking.camera) run.devices.push_back(device("camera", by_key(CameraTroubles{})));
    if (!scenario.see_through.camera.empty()) run.devices.push_back(device("see_through", {}));
    run.recording.emplace();
    run.display.emplace();
    if (!scenario.governor.front.empty() || !scenario.governor.settings.empty())
        run.governor = GovernorRecord{.settings = {{}}, .error_name = {}};
    return summary_json(run, scenario_json(scenario), {}, {}, 0);
}

/// The name of a pass stands for any.
FailIf with_any_pass(FailIf check) {
    const auto dot = check.key.rfind('.');
    if (check.key.starts_with(kPasses) && dot > kPasses.size())
        check.key.replace(kPasses.size(), dot - kPasses.size(), kAnyPass);
    return check;
}

}  // namespace

void refuse_unknown_keys(const std::vector<FailIf>& checks, const Scenario& scenario) {
    if (checks.empty()) return;
    const nlohmann::json summary = summary_of_any_run(scenario);
    for (const FailIf& check : checks) failure(with_any_pass(check), summary);
}

}  // namespace foverig
