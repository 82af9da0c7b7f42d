#pragma once
#include <tbb/task_arena.h>

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "renderer/image.h"
#include "renderer/kernels/lens_distortion.h"
#include "renderer/view.h"

namespace foverig {

struct PixelSize {
    int width_px = 0;
    int height_px = 0;
    std::size_t count() const {
        return static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px);
    }
};

/// Where a panel pixel's red, green and blue lie in the eye's image: px from its top left corner,
/// pixel centres at halves. Outside the image, or NaN: that colour is black.
using ColourSources = std::array<vec2, 3>;

/// Lens distortion with chromatic correction: undistorted eye images in, the panel's picture out.
/// It knows no lens: the tables say, row by row, where each pixel's colours come from. Same bits on
/// any number of threads.
class LensDistortion {
  public:
    /// One table an eye, each an entry for every pixel of `share`, that eye's share of the panel;
    /// eye images are `eye` large, at least 2x2. `threads` 0: one a core.
    LensDistortion(const PixelSize& share, const PixelSize& eye,
                   std::span<const std::vector<ColourSources>> tables, int threads = 0);

    /// The eyes' shares side by side, eye 0 left; an empty image leaves its share black. Reuses
    /// `panel`'s memory.
    void apply(std::span<const View<const Half4>> eyes, Image& panel) const;

  private:
    PixelSize share_;
    PixelSize eye_;
    std::vector<std::vector<LensSource>> sources_;  ///< by eye
    std::unique_ptr<tbb::task_arena> arena_;
};

}  // namespace foverig
