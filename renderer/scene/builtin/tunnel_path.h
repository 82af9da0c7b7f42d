#pragma once
// The course that both tunnels take: along -z, with two bends, floor about 1.5 m below it.
#include "renderer/scene/builtin/scene_builder.h"

namespace foverig::builtin::tunnel {

inline constexpr float kLength_m = 48.0F;

/// Axis of the tunnel at that distance from its entrance.
vec3 axis_m(float along_m);

/// Three point lights, a strip light under the roof, and a flight along the axis.
void light_and_fly(Scene& scene);

}  // namespace foverig::builtin::tunnel
