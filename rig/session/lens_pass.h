#pragma once
#include "renderer/image.h"
#include "renderer/renderer.h"

namespace foverig {

/// Warps the eyes' images onto the panel: lens distortion with chromatic correction
/// (DEVICES.md 2.1). Runs between submit and present, on the frame's time.
class LensPass {
  public:
    virtual ~LensPass() = default;
    /// Of the renderer's last frame. The pass's own time; it joins the frame's passes.
    virtual PassTime warp(const Renderer& renderer) = 0;
    /// What `warp` last put on the panel, landscape 1920x1080.
    virtual Image panel() const = 0;
};

}  // namespace foverig
