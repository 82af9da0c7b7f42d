#pragma once
// The coarse mesh of the last frame's visible geometry (Weier 2016 3.2): one vertex a support
// pixel, unprojected with the last eye, projected with this one.
#include "renderer/kernels/camera_rays.h"
#include "renderer/math.h"
#include "renderer/view.h"

namespace foverig {

/// Depth of a ray that hit nothing: so far that a head's shift moves it by less than a pixel, yet
/// finite.
inline constexpr float kFarDepth_m = 1.0e6F;

/// Vertices nearer to the eye than this cannot be projected in float; their cells are left out.
inline constexpr float kNearestVertex_m = 1.0e-3F;

/// Vertex (column, row) at [row * columns + column]. `inverse_depth` is 0 where it cannot be seen.
struct DepthMesh {
    const float* x_px = nullptr;  ///< in the new image
    const float* y_px = nullptr;
    const float* inverse_depth = nullptr;  ///< 1/m in the new eye
    const float* source_x_px = nullptr;    ///< in the old image, by column
    const float* source_y_px = nullptr;    ///< by row
    int columns = 0;
    int rows = 0;
};

/// Old image position and depth -> new image position and depth, as one affine map and a division.
struct Reprojection {
    vec3 offset{0.0F};  ///< old eye's position in the new eye's frame
    vec3 corner{0.0F};  ///< old ray directions in the new eye's frame
    vec3 step_x{0.0F};
    vec3 step_y{0.0F};
    vec2 scale_px{1.0F};   ///< pixels per tangent
    vec2 centre_px{0.0F};  ///< image position of the view axis

    Reprojection() = default;
    Reprojection(const EyeView& from, const EyeView& to) {
        const EyeRays rays(from);
        const mat3 eye_from_world = glm::transpose(to.world_from_eye);
        offset = eye_from_world * (from.position_m - to.position_m);
        corner = eye_from_world * rays.corner;
        step_x = eye_from_world * rays.step_x;
        step_y = eye_from_world * rays.step_y;
        scale_px = {static_cast<float>(to.width_px) / (to.tan_left + to.tan_right),
                    static_cast<float>(to.height_px) / (to.tan_up + to.tan_down)};
        centre_px = {to.tan_left * scale_px.x, to.tan_up * scale_px.y};
    }

    /// Point at `depth_m` behind old image position (x, y), in the new eye's frame.
    RIG_HD vec3 in_new_eye(float x_px, float y_px, float depth_m) const {
        return offset + depth_m * (corner + x_px * step_x + y_px * step_y);
    }
};

/// One row of vertices, or columns [begin, end) of it.
struct ReprojectVertices {
    Reprojection map;
    const float* depth_m;  ///< support G-buffer of the last frame
    const float* source_x_px;
    const float* source_y_px;
    int columns;
    float* x_px;
    float* y_px;
    float* inverse_depth;

    RIG_HD void operator()(int row) const { span(row, 0, columns); }

    RIG_INLINE void span(int row, int begin, int end) const {
        const float source_y = source_y_px[row];
        const int first = row * columns;
        for (int column = begin; column < end; ++column) {
            const vec3 p = map.in_new_eye(source_x_px[column], source_y, depth_m[first + column]);
            const float depth = -p.z;
            const bool seen = depth > kNearestVertex_m;
            const float inverse = 1.0F / (seen ? depth : 1.0F);
            x_px[first + column] = map.centre_px.x + map.scale_px.x * p.x * inverse;
            y_px[first + column] = map.centre_px.y - map.scale_px.y * p.y * inverse;
            inverse_depth[first + column] = seen ? inverse : 0.0F;
        }
    }
};

}  // namespace foverig
