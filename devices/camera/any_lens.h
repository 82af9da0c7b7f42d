#pragma once
#include <variant>

#include "devices/camera/fisheye_lens.h"
#include "devices/camera/lens.h"

namespace foverig::camera {

/// What a camera's calibration may say.
using AnyLens = std::variant<Lens, FisheyeLens>;

}  // namespace foverig::camera
