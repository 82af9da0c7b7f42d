#include "devices/gaze/gaze_sample.h"

#include <cmath>

namespace foverig {
namespace {

using namespace gaze;

constexpr double kMetersPerMm = 1e-3;
constexpr double kUnitTolerance = 1e-3;  // the wire promises 1e-4

dvec3 turned(const Vec3f& v) {
    return {-v[0], v[1], -v[2]};
}

GazeRay ray_of(const Vec3f& base_point_mm, const Vec3f& direction, bool said_valid) {
    GazeRay ray;
    ray.base_point_m = kMetersPerMm * turned(base_point_mm);
    const dvec3 d = turned(direction);
    const double length = glm::length(d);
    // NaN fails both comparisons; an eye that looks backwards is no eye.
    ray.valid = said_valid && std::abs(length - 1) < kUnitTolerance && d.z < 0;
    if (ray.valid) ray.direction = d / length;
    return ray;
}

GazeEye eye_of(const EyeBlock& eye, bool said_valid, bool blink) {
    return {.ray = ray_of(eye.base_point_mm, eye.direction,
                          said_valid && eye.state >= EyeState::compensated),
            .blink = blink || eye.cause == EyeCause::blink,
            .confidence = eye.confidence,
            .openness = eye.openness,
            .pupil_radius_m = kMetersPerMm * eye.pupil_radius_mm,
            .state = eye.state,
            .cause = eye.cause};
}

GazeTime time_of(std::uint64_t ns) {
    return GazeTime(Nanoseconds(static_cast<std::int64_t>(ns)));
}

}  // namespace

GazeSample to_sample(const SampleFrame& f) {
    const auto has = [&](std::uint16_t bit) { return (f.status & bit) != 0; };
    GazeSample s;
    s.device_time = time_of(f.exposure_ns);
    s.queued = time_of(f.header.queued_ns);
    s.sequence = f.header.sequence;
    s.session = f.header.session;
    s.camera_frame = f.camera_frame;
    s.valid = has(sample_status::valid);
    s.saccade = has(sample_status::saccade);
    s.calibrated = !has(sample_status::uncalibrated);
    s.left = eye_of(f.left, has(sample_status::left_valid), has(sample_status::left_blink));
    s.right = eye_of(f.right, has(sample_status::right_valid), has(sample_status::right_blink));
    s.combined = ray_of(f.base_point_mm, f.direction, has(sample_status::combined_valid));
    s.por_px = {f.por_px[0], f.por_px[1]};
    s.vergence_distance_m = kMetersPerMm * f.vergence_distance_mm;
    return s;
}

}  // namespace foverig
