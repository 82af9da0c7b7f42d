#pragma once
#include <cstdint>
#include <vector>

#include "renderer/camera.h"
#include "renderer/kernels/tile_grid.h"
#include "renderer/settings.h"

namespace foverig {

/// How an image axis of `size` pixels and its coarse axis of `count` samples map to each other.
struct EyeAxis {
    EyeAxis(int count, int size_px);

    std::vector<std::int16_t> support_of;    ///< by pixel: the support sample there, or -1
    std::vector<std::int16_t> cell_of;       ///< by pixel: the coarse cell over it
    std::vector<std::int16_t> cell_from_px;  ///< by cell: its first pixel, and the end
    std::vector<float> source_px;            ///< by support sample: image position of its vertex
};

/// The support resolution: by setting, else the paper's 256x318 at 1182x1464, in proportion; at
/// least 2x2.
TileGrid support_grid(const ReprojectionSettings& settings, const EyeView& view);

}  // namespace foverig
