#pragma once
// Double precision vectors of the device layer. Frames are right-handed, x right, y up, z back.
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace foverig {

using glm::dmat3;
using glm::dquat;
using glm::dvec2;
using glm::dvec3;

}  // namespace foverig
