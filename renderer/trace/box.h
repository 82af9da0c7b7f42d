#pragma once
#include <limits>

#include "renderer/math.h"
#include "renderer/vec.h"

namespace foverig {

/// Axis-aligned and closed; min above max: empty.
struct Box {
    vec3 min_m{std::numeric_limits<float>::infinity()};
    vec3 max_m{-std::numeric_limits<float>::infinity()};

    RIG_HD bool empty() const { return !(min_m.x <= max_m.x); }
    /// A NaN coordinate leaves its axis as it is.
    RIG_HD void grow(const vec3& p) { grow(Box{p, p}); }
    RIG_HD void grow(const Box& b) {
        for (int a = 0; a < 3; ++a) {
            min_m[a] = min_of(b.min_m[a], min_m[a]);
            max_m[a] = max_of(b.max_m[a], max_m[a]);
        }
    }
    /// Half the surface; 0 of an empty box.
    RIG_HD float half_area_m2() const {
        if (empty()) return 0.0F;
        const vec3 d = max_m - min_m;
        return d.x * d.y + d.y * d.z + d.z * d.x;
    }
    RIG_HD vec3 middle_m() const { return 0.5F * min_m + 0.5F * max_m; }
};

}  // namespace foverig
