#include "devices/gaze/calibration_targets.h"

#include "devices/display/dk2_optics.h"
#include "devices/gaze_angles.h"

namespace foverig::gaze {
namespace {

constexpr double kMiddle = 0.5;
constexpr double kOuter = 0.3;  // of the outermost default points, from the middle
constexpr dvec2 kEye_px{960.0, 1080.0};

/// Of the mean of both eyes' halves. The eyes sit as far from the middle as each other, so that the
/// mean of their tangents to a point is the tangent from between them.
struct MeanFrustum {
    dvec2 low, size;

    MeanFrustum() {
        const Dk2Optics optics;
        const TangentFrustum left = optics.frustum(Eye::left), right = optics.frustum(Eye::right);
        low = {-0.5 * (left.left + right.left), -left.down};
        size = {0.5 * (left.left + left.right + right.left + right.right), left.down + left.up};
    }
};

void add_grid(std::vector<dvec2>& points, std::initializer_list<double> places) {
    for (const double y : places)
        for (const double x : places)
            if (x != kMiddle || y != kMiddle) points.emplace_back(x, y);
}

}  // namespace

std::vector<dvec2> default_points(int points) {
    std::vector<dvec2> all{{kMiddle, kMiddle}};
    switch (points) {
        case 1:
            return all;
        case 3:
            all.insert(all.end(), {{0.25, 0.35}, {0.75, 0.65}});
            return all;
        case 5:
            add_grid(all, {0.2, 0.8});
            return all;
        case 9:
        case 13:
            add_grid(all, {0.2, 0.5, 0.8});
            if (points == 13) add_grid(all, {0.35, 0.65});
            return all;
        default:
            return {};
    }
}

std::vector<dvec2> targets_deg(int points, double reach_deg) {
    std::vector<dvec2> targets;
    for (const dvec2& point : default_points(points)) {
        const dvec2 share = dvec2(point.x - kMiddle, kMiddle - point.y) / kOuter;
        targets.push_back(reach_deg * share);
    }
    return targets;
}

Vec2f por_of(const dvec2& target_deg) {
    static const MeanFrustum frustum;
    const dvec3 d = gaze_direction(target_deg);
    const dvec2 share = (dvec2(d.x, d.y) / -d.z - frustum.low) / frustum.size;
    return {static_cast<float>(share.x * kEye_px.x),
            static_cast<float>((1.0 - share.y) * kEye_px.y)};
}

dvec2 target_deg_of(const Vec2f& por_px) {
    static const MeanFrustum frustum;
    const dvec2 share = dvec2(por_px[0], kEye_px.y - por_px[1]) / kEye_px;
    return gaze_angles_deg(dvec3(frustum.low + share * frustum.size, -1.0));
}

}  // namespace foverig::gaze
