#pragma once
// A window as the rig's display: draws, swaps, and says which VSync a frame made and how sure that
// is.
#include <functional>

#include "devices/display/vsync_clock.h"
#include "devices/window/lens_painter.h"
#include "devices/window/window.h"

namespace foverig::window {

/// Where swaps do not wait for the monitor (Xvfb, or a driver set so), VSyncs are a grid of our own
/// at the monitor's rate, and vsync_knowledge() says so. Light is taken to come as from a DK2's
/// panel whose scan-out starts at that VSync: of another monitor's light nothing is known.
class WindowDisplay final : public Display {
  public:
    struct Settings {
        double rate_hz = 75;     ///< where the monitor does not tell its own
        bool wait_vsync = true;  ///< false: swaps do not wait, so they are not asked
    };
    /// Drawn over the lenses' picture, on the frame's time; empty: nothing.
    using Overlay = std::function<void(const PanelView&)>;

    /// Swaps black frames for a third of a second, to see whether swaps wait. All outlive this.
    WindowDisplay(Window& window, LensPainter& painter, const Clock& clock, Overlay overlay,
                  const Settings& settings);

    const PanelTiming& timing() const override { return timing_; }
    VsyncKnowledge vsync_knowledge() const override;
    HostTime next_vsync(HostTime at) const override {
        return vsyncs_.vsync(vsyncs_.number_from(at));
    }
    bool draws_pictures() const override { return true; }
    DrawTimes draw(const FramePictures& frame) override;
    Presentation present(const FrameOnPanel& frame, HostTime submit) override;

  private:
    Window& window_;
    LensPainter& painter_;
    const Clock& clock_;
    Overlay overlay_;
    VsyncClock vsyncs_;
    PanelTiming timing_;
    WallClock stopwatch_;
    std::optional<std::uint64_t> last_vsync_;
};

}  // namespace foverig::window
