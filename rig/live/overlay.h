#pragma once
#include "devices/display/panel_view.h"

struct ImGuiContext;

namespace foverig {

/// What is drawn over the panel's picture, as it lies in a framebuffer: Dear ImGui's lists in the
/// pixels of the landscape panel. Needs a current OpenGL 3.3 context for life. One at a time.
class Overlay {
  public:
    Overlay();
    ~Overlay();
    Overlay(const Overlay&) = delete;
    Overlay& operator=(const Overlay&) = delete;

    /// Begins a picture; gives the landscape panel's size.
    SizePx begin(const PanelView& view, double frame_s);
    /// Draws it into the framebuffer that is bound.
    void end(const PanelView& view);
    /// Of text: 1 on a panel of 720 rows and less.
    double scale() const { return scale_; }

  private:
    ImGuiContext* context_;
    double scale_ = 1.0;
};

}  // namespace foverig
