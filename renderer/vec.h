#pragma once
#include "renderer/hd.h"

#if defined(__CUDACC__)
#ifndef GLM_FORCE_CUDA
#define GLM_FORCE_CUDA
#endif
#endif
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace foverig {

using glm::dmat3;
using glm::dquat;
using glm::dvec2;
using glm::dvec3;
using glm::ivec2;
using glm::mat3;
using glm::mat4;
using glm::quat;
using glm::uvec3;
using glm::vec2;
using glm::vec3;
using glm::vec4;

/// Of linear RGB (Rec. 709).
RIG_INLINE float luminance(const vec3& c) {
    return 0.2126F * c.x + 0.7152F * c.y + 0.0722F * c.z;
}

}  // namespace foverig
