#pragma once
// The frame loop: from bytes of devices to light, with every instant recorded. The same code drives
// wall and lockstep clocks, simulated and replayed devices, and will drive real ones.
#include <functional>

#include "devices/display/latency_tester.h"
#include "renderer/renderer.h"
#include "rig/records/run_record.h"
#include "rig/scenario/scenario.h"
#include "rig/session/device_streams.h"
#include "rig/session/eye_views.h"
#include "rig/session/lens_pass.h"
#include "rig/session/live_parts.h"
#include "rig/session/pacing.h"
#include "rig/session/run_clock.h"

namespace foverig {

struct SessionProgress {
    std::uint64_t frames = 0;
    double share = 0.0;          ///< of the run, 0..1
    double frame_time_ms = 0.0;  ///< of the last frame
};

/// What others may do between two frames; none of it is on the frames' time.
struct SessionHooks {
    std::function<bool()> stop_requested = [] { return false; };
    /// Right after a frame's begin, on its time: what feeds devices by hand (a window's cursor).
    std::function<void(HostTime)> frame_begins = [](HostTime) {};
    /// At a fixed cost: what the frame that begins will cost; none: what the scenario says.
    std::function<std::optional<double>()> fixed_ms = [] { return std::nullopt; };
    /// A device was lost, or is back: one sentence, as soon as a frame asks the devices.
    Notice notice{};
    std::function<void(const SessionProgress&)> progress = [](const SessionProgress&) {};
    /// Returns whether images were kept of that frame.
    std::function<bool(const FrameRecord&, const FrameInput&, double share)> frame_done =
        [](const FrameRecord&, const FrameInput&, double) { return false; };
};

class Session {
  public:
    /// All outlive the session; `lens` may be null: no distortion pass. So may `recording`, and
    /// `live`: no window.
    Session(const Scenario& scenario, const Scene& scene, Renderer& renderer, LensPass* lens,
            SessionRecording* recording = nullptr, const LiveParts* live = nullptr);

    RunRecord run(const SessionHooks& hooks);

  private:
    void read_devices(HostTime deadline);
    FrameInput input_for(FrameRecord& frame, HostTime expected_vsync);
    void render_frame(FrameRecord& frame, FrameInput& input);
    EyePicture picture_of(int eye) const;
    /// Returns the VSync that the picture is of, which a late warp may see coming later.
    HostTime draw(FrameRecord& frame, HostTime expected_vsync);
    void see_through(FrameRecord& frame, FramePictures& pictures);
    HostTime warp_to_newest(FrameRecord& frame, HostTime expected_vsync);
    void present(FrameRecord& frame, HostTime pictured_vsync);
    void show(FrameRecord& frame, const Presentation& shown, HostTime pictured_vsync);
    void judge(FrameRecord& frame, const FrameInput& input) const;
    void judge_turn(FrameRecord& frame) const;
    void match_readbacks();
    double share_done(std::uint64_t frames) const;
    RunRecord finish(bool interrupted);

    const Scenario& scenario_;
    Renderer& renderer_;
    LensPass* lens_;
    RunClock clock_;
    SessionRecording* recording_;
    std::unique_ptr<World> world_;
    DeviceStreams devices_;
    CameraFlight flight_;
    EyeViews views_;
    Pacing pacing_;
    LatencyTester latency_tester_;
    HostTime start_{};
    std::vector<FrameRecord> frames_;
    std::array<Pose, 2> poses_;  // of the frame in work, an eye each
};

}  // namespace foverig
