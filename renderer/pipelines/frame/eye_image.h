#pragma once
#include "renderer/camera.h"
#include "renderer/half.h"
#include "renderer/image.h"
#include "renderer/kernels/tile_grid.h"
#include "renderer/view.h"

namespace foverig {

inline std::size_t pixel_count(const EyeView& view) {
    return static_cast<std::size_t>(view.width_px) * static_cast<std::size_t>(view.height_px);
}

/// Float copy of an image kept as halves.
Image image_of(View<const Half4> halves, const TileGrid& grid);

}  // namespace foverig
