#pragma once
// The window of a calibration: black, with the target that is looked at in front of both eyes.
#include <memory>
#include <string>

#include "devices/display/eye_map.h"
#include "devices/window/window.h"
#include "rig/live/overlay.h"
#include "rig/scenario/scenario.h"

namespace foverig {

class TargetWindow {
  public:
    /// Null where the scenario's display is virtual. Throws as open_window.
    static std::unique_ptr<TargetWindow> open(const Scenario& scenario);

    /// Draws the target, or none, and swaps. `watched`: the tracker takes its samples now.
    /// `distance_m`: from the point between the eyes. `text`: a line below the middle.
    struct Picture {
        std::optional<dvec2> target_deg{};
        bool watched = false;
        double distance_m = 1.5;
        std::string text{};
    };
    void show(const Picture& picture);

    /// Escape, or the close button.
    bool closed() const { return window_->closed(); }
    const std::string& shown_on() const { return window_->shown_on(); }

  private:
    TargetWindow(const Scenario& scenario, std::unique_ptr<window::Window> window);
    void draw_target(const PanelView& landscape, const Picture& picture) const;
    void draw_text(const PanelView& landscape, const std::string& text) const;

    std::unique_ptr<window::Window> window_;
    Overlay overlay_;  // of the window's context
    EyeMap map_;
    double frame_s_;
};

}  // namespace foverig
