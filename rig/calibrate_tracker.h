#pragma once
// The gaze tracker that a scenario asks for and nothing else, with whoever looks at the targets.
#include <functional>
#include <memory>

#include "devices/gaze/calibration.h"
#include "devices/gaze/gaze_source.h"
#include "devices/hardware/live_transport.h"
#include "rig/scenario/scenario.h"
#include "rig/session/run_clock.h"
#include "simulators/gaze/simulated_gaze.h"
#include "simulators/motion/guided_eye.h"

namespace foverig {

class CalibratedTracker {
  public:
    /// Throws DeviceError where it cannot be opened, UsageError where it is a recording's.
    explicit CalibratedTracker(const Scenario& scenario);

    struct Hooks {
        /// At each step: what is shown, and how it goes.
        std::function<void(const gaze::CalibrationProcedure&)> step;
        std::function<bool()> stop_requested;
    };
    /// Until it is over. Throws DeviceError where the tracker is lost.
    void run(gaze::CalibrationProcedure& procedure, const Hooks& hooks);

    bool simulated() const { return simulated_ != nullptr; }
    HostTime now() const { return clock_.now(); }
    const gaze::Info& info() const { return source_->info(); }
    /// Throw DeviceError.
    gaze::DeviceStatus status();
    std::vector<std::byte> calibration();  ///< empty: it keeps it to itself

  private:
    Transport& transport();
    void obey(gaze::CalibrationProcedure& procedure);
    void look(const gaze::CalibrationProcedure& procedure);
    std::vector<std::byte> asked(std::uint8_t request, std::size_t size);

    RunClock clock_;
    motion::GuidedEye eyes_;
    std::optional<std::size_t> looked_at_;
    std::unique_ptr<SimulatedGaze> simulated_;          // null: on the desk
    std::unique_ptr<hardware::LiveTransport> on_desk_;  // null: simulated
    std::optional<gaze::GazeSource> source_;
};

}  // namespace foverig
