#pragma once
#include <span>
#include <vector>

#include "devices/time.h"
#include "renderer/pipelines/lens_distortion.h"
#include "renderer/renderer.h"
#include "rig/scenario/scenario.h"

namespace foverig {

/// Puts the eyes' images on the DK2's panel: lens distortion with chromatic correction
/// (DEVICES.md 2.1). Runs between submit and present, on the frame's time.
class LensPass {
  public:
    explicit LensPass(const Scenario& scenario);

    /// Of the renderer's last frame; the passes' times join the frame's.
    std::vector<PassTime> run(const Renderer& renderer);

    /// The same for images that were kept: landscape, 960x1080 for each eye, the left one first.
    Image picture(std::span<const Image> eyes) const;

  private:
    WallClock clock_;
    LensDistortion distortion_;
    std::vector<View<const Half4>> eyes_;
    Image panel_;
};

}  // namespace foverig
