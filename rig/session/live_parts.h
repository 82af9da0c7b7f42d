#pragma once
#include <functional>
#include <memory>

#include "devices/display/display.h"
#include "simulators/motion/eye_motion.h"

namespace foverig {

/// What a run with a window brings into its world.
struct LiveParts {
    /// Made once, for the run's clock, which outlives it.
    std::function<std::unique_ptr<Display>(const Clock&)> make_display;
    /// What the cursor moves; used where motion.gaze is mouse.
    const motion::EyeMotion* pointed_eyes = nullptr;
};

}  // namespace foverig
