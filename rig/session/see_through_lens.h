#pragma once
#include "devices/camera/any_lens.h"
#include "rig/scenario/scenario.h"

namespace foverig {

/// The see-through camera's, in pixels of a picture of this size.
camera::AnyLens lens_of(const SeeThroughSettings& settings, int width_px, int height_px);

}  // namespace foverig
