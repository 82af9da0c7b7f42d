#pragma once
#include <tbb/task_arena.h>

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "renderer/image.h"

namespace foverig {

/// Where a panel pixel's red, green and blue lie in the eye's image: px from its top left corner,
/// pixel centres at halves. Outside the image, or NaN: that colour is black.
using ColourSources = std::array<vec2, 3>;

/// Lens distortion with chromatic correction: undistorted eye images in, the panel's picture out.
/// It knows no lens: the tables say, row by row, where each pixel's colours come from. Same bits on
/// any number of threads.
class LensDistortion {
  public:
    /// One table an eye, each width_px * height_px entries: that eye's share of the panel.
    /// `threads` 0: one a core.
    LensDistortion(int width_px, int height_px, std::span<const std::vector<ColourSources>> tables,
                   int threads = 0);

    /// The eyes' shares side by side, eye 0 left; an empty image leaves its share black. Reuses
    /// `panel`'s memory.
    void apply(std::span<const Image> eyes, Image& panel) const;
    Image apply(std::span<const Image> eyes) const;

  private:
    int width_px_;
    int height_px_;
    std::vector<std::vector<float>> sources_px_;  ///< by eye: planes as DistortRow reads them
    std::unique_ptr<tbb::task_arena> arena_;
};

}  // namespace foverig
