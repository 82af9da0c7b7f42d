#pragma once
// What is written over the picture while somebody looks at it: it costs its part of each frame, so
// it is made when a key asks for it and gone when the key is pressed again.
#include "devices/display/eye_map.h"
#include "rig/live/overlay.h"
#include "rig/live/recent_frames.h"
#include "rig/scenario/scenario.h"

namespace foverig {

class Hud {
  public:
    /// Needs a current OpenGL 3.3 context for life. One at a time.
    Hud(const Scenario& scenario, double rate_hz);

    void add(const FrameRecord& frame) { frames_.add(frame); }
    /// Into the framebuffer that is bound.
    void draw(const PanelView& view);

  private:
    void draw_numbers(double scale) const;
    void draw_gaze(const PanelView& landscape) const;

    Overlay overlay_;
    FoveationSettings foveation_;
    std::size_t eyes_;
    double budget_ms_;
    EyeMap map_;
    RecentFrames frames_;
};

}  // namespace foverig
