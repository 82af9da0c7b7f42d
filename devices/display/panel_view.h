#pragma once
// How the panel's landscape picture lies in a framebuffer, and back from there to what an eye sees.
#include <optional>

#include "devices/display/dk2_optics.h"

namespace foverig {

/// A place on an eye's half of the panel (Dk2Optics' NDC: x right, y up, each -1..1).
struct EyePlace {
    Eye eye = Eye::left;
    dvec2 ndc{0.0};
};

class PanelView {
  public:
    /// As large as fits, centred. `turned`: the framebuffer is the DK2's portrait panel, whose top
    /// row is the landscape's right edge (DEVICES.md 1.7, 2.3).
    PanelView(const SizePx& framebuffer, bool turned);

    /// Viewport in OpenGL's manner: from the lower left corner.
    struct Rectangle {
        int x_px = 0, y_px = 0, width_px = 0, height_px = 0;
    };
    const Rectangle& viewport() const { return viewport_; }
    const SizePx& framebuffer() const { return framebuffer_; }
    bool turned() const { return turned_; }
    /// NDC of the whole landscape panel to NDC of the viewport.
    glm::dmat2 viewport_from_panel() const;
    /// The panel's corner that the headset reads back: the landscape's top right (1.7); one pixel,
    /// from the lower left corner.
    Rectangle latency_pixel() const;

    /// `at_px` from the framebuffer's upper left corner; nothing beside the panel.
    std::optional<EyePlace> place(const dvec2& at_px) const;
    dvec2 at_px(const EyePlace& place) const;

  private:
    SizePx framebuffer_;
    bool turned_;
    Rectangle viewport_;
};

}  // namespace foverig
