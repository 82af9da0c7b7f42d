#pragma once
#include <string>
#include <vector>

#include "renderer/renderer.h"
#include "rig/scenario/scenario.h"
#include "rig/sweep/definition.h"

namespace foverig::sweep {

/// A frame of a flight, and where each of its eyes really looked (empty: nobody knows).
struct FlownFrame {
    FrameInput input;
    std::vector<vec3> true_gaze;
};

/// What the eyes see frame by frame: the scenario's devices, motions and camera at one frame a
/// VSync, whatever frames cost. So every point of a sweep is shown the same. Throws UsageError
/// where there are fewer than `frames`, as a recording may end before.
std::vector<FlownFrame> fly(const Scenario& scenario, const Scene& scene);

/// Those stretches of a flight, one behind the other; all of it where they have no length.
std::vector<FlownFrame> stretches_of(std::vector<FlownFrame> flight, const Stretches& stretches);

/// Of all numbers of the inputs that a picture without foveation depends on: all but the gaze.
std::string digest_of(const std::vector<FlownFrame>& flight);

/// Of all that a scene shows.
std::string digest_of(const Scene& scene);

}  // namespace foverig::sweep
