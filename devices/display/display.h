#pragma once
// What shows a frame: a headset, a window or a simulated panel.
#include <cstdint>

#include "devices/display/panel_timing.h"
#include "devices/time.h"

namespace foverig {

/// What is shown with a frame beside its pixels.
struct FrameOnPanel {
    std::uint64_t frame_id = 0;
    std::uint8_t latency_level = 16;  ///< grey of the corner pixel (LatencyTester); 16 is idle
};

/// Which scan-out a frame made.
struct Presentation {
    std::uint64_t frame_id = 0;
    std::uint64_t vsync_number = 0;  ///< counts from the display's first
    HostTime vsync{};                ///< start of the scan-out that shows it
    bool replaced = false;           ///< an earlier frame of the same vsync was never seen
};

class Display {
  public:
    virtual ~Display() = default;
    virtual const PanelTiming& timing() const = 0;
    /// The first vsync at or after `at`.
    virtual HostTime next_vsync(HostTime at) const = 0;
    /// Hands over a finished frame at `submit`; submits do not go back in time. It is scanned out
    /// from the first vsync that its submit time makes.
    virtual Presentation present(const FrameOnPanel& frame, HostTime submit) = 0;
};

}  // namespace foverig
