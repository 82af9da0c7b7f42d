#pragma once
#include <string>
#include <vector>

#include "renderer/renderer.h"
#include "rig/scenario/scenario.h"

namespace foverig::sweep {

/// What the eyes see frame by frame: the scenario's devices, motions and camera at one frame a
/// VSync, whatever frames cost. So every point of a sweep is shown the same.
std::vector<FrameInput> fly(const Scenario& scenario, const Scene& scene);

/// Of all numbers of the inputs.
std::string digest_of(const std::vector<FrameInput>& flight);

/// Of all that a scene shows.
std::string digest_of(const Scene& scene);

}  // namespace foverig::sweep
