#pragma once
#include "renderer/vec.h"

namespace foverig {

/// A pinhole eye. Eye frame: x right, y up, looking along -z. Pixel (0,0) is top left; the image
/// spans the tangents -tan_left..tan_right and -tan_down..tan_up (all given positive outward).
struct EyeView {
    int width_px = 0;
    int height_px = 0;
    float tan_left = 1.0F;
    float tan_right = 1.0F;
    float tan_down = 1.0F;
    float tan_up = 1.0F;
    vec3 position_m{0.0F};      ///< in the scene frame
    mat3 world_from_eye{1.0F};  ///< rotation
};

/// One eye of one frame. `gaze` is the unit direction of gaze in the eye frame (z < 0).
struct EyeInput {
    EyeView view;
    vec3 gaze{0.0F, 0.0F, -1.0F};
};

}  // namespace foverig
