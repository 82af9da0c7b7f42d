#pragma once
#include <cstdint>

#include "renderer/vec.h"

namespace foverig {

inline constexpr std::uint32_t kMiss = 0xFFFFFFFFU;

/// World frame, metres; `direction` need not be unit: t counts in its lengths.
struct Ray {
    vec3 origin_m{0.0F};
    vec3 direction{0.0F, 0.0F, -1.0F};
    float t_min = 0.0F;
    float t_max = 3.0e38F;
};

/// `triangle` indexes Scene::triangles, or is kMiss. u, v weigh the second and third corner.
struct Hit {
    float t = 0.0F;
    float u = 0.0F;
    float v = 0.0F;
    std::uint32_t triangle = kMiss;

    RIG_HD bool missed() const { return triangle == kMiss; }
};

/// A visibility ray and what it adds if nothing is in its way; weight 0: not traced at all.
struct WeightedRay {
    Ray ray;
    float weight = 0.0F;
};

}  // namespace foverig
