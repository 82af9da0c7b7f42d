#pragma once
// The lens as a mesh that a graphics card draws: EyeMap at its corners, straight lines between.
#include <cstdint>
#include <vector>

#include "devices/display/eye_map.h"

namespace foverig {

struct LensVertex {
    float x = 0, y = 0;  ///< NDC of the whole landscape panel
    float red_x = 0, red_y = 0, green_x = 0, green_y = 0, blue_x = 0, blue_y = 0;  ///< tangents
};

struct LensMesh {
    std::vector<LensVertex> vertices;
    std::vector<std::uint32_t> indices;  ///< three a triangle
};

/// Cells of 4x4 panel pixels: nowhere off by more than 0.06 px of an eye's image at density 1.
inline constexpr int kLensCell_px = 4;

/// An eye's half of the panel.
LensMesh lens_mesh(Eye eye, const EyeMap& map);

}  // namespace foverig
