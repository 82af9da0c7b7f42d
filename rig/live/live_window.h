#pragma once
// The window of a run: what shows its frames, the keys, the cursor as a gaze, the HUD.
#include <memory>
#include <optional>

#include "devices/window/window_display.h"
#include "rig/live/hud.h"
#include "rig/records/run_record.h"
#include "rig/session/live_parts.h"
#include "simulators/motion/pointed_eye.h"

namespace foverig {

class LiveWindow {
  public:
    /// Null where the scenario's display is virtual. Throws DeviceError where no window can be had,
    /// UsageError where the clock is not the wall's.
    static std::unique_ptr<LiveWindow> open(const Scenario& scenario);

    /// For the session; this outlives it.
    const LiveParts& parts() const { return parts_; }

    const std::string& shown_on() const { return window_->shown_on(); }

    /// At a frame's begin: takes what the desktop has to say; the eyes look at the cursor from then
    /// on. A cursor beside the panel leaves them where they are.
    void frame_begins(HostTime begin);
    void frame_done(const FrameRecord& frame);
    /// Escape, or the close button.
    bool closed() const { return window_->closed(); }

    /// What is only known here.
    void complete(DisplayRecord& record) const;

  private:
    LiveWindow(const Scenario& scenario, std::unique_ptr<window::Window> window,
               window::LensPainter painter);
    std::unique_ptr<Display> make_display(const Clock& clock);
    void toggle_hud();

    const Scenario scenario_;
    std::unique_ptr<window::Window> window_;
    window::LensPainter painter_;
    EyeMap map_;
    motion::PointedEye eyes_;
    LiveParts parts_;
    double rate_hz_;
    std::unique_ptr<Hud> hud_;  // null: off
    std::uint64_t hud_frames_ = 0;
};

}  // namespace foverig
