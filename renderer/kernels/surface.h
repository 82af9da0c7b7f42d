#pragma once
// The surface record between shading and light: one row of floats a quantity, one slot a hit pixel.
// Rows are padded to whole packets, so that sixteen lanes can always be read.
#include "renderer/vec.h"

namespace foverig {

enum class Row {
    origin_x,
    origin_y,
    origin_z,  // where secondary rays start, offset off the surface
    normal_x,
    normal_y,
    normal_z,  // shading normal, on the viewer's side
    diffuse_r,
    diffuse_g,
    diffuse_b,
    specular_r,
    specular_g,
    specular_b,
    shininess,
    view_x,
    view_y,
    view_z,  // unit, to the eye
    colour_r,
    colour_g,
    colour_b,  // everything but the stochastic light
    depth,
    visible,  // of the point light in hand: 1 or 0
    irradiance_r,
    irradiance_g,
    irradiance_b,
    occlusion,  // the light buffer's part: last, so that
    count,      // without it the rows are not there
};

inline constexpr int kRows = static_cast<int>(Row::count);
inline constexpr int kRowsWithoutLight = static_cast<int>(Row::irradiance_r);

struct Surfaces {
    float* data = nullptr;
    int stride = 0;

    RIG_HD float& at(Row row, int slot) const {
        return data[static_cast<int>(row) * stride + slot];
    }
    RIG_HD vec3 get3(Row row, int slot) const {
        const float* p = data + static_cast<int>(row) * stride + slot;
        return {p[0], p[stride], p[2 * stride]};
    }
    RIG_HD void set3(Row row, int slot, const vec3& v) const {
        float* p = data + static_cast<int>(row) * stride + slot;
        p[0] = v.x;
        p[stride] = v.y;
        p[2 * stride] = v.z;
    }
};

}  // namespace foverig
