#include "devices/camera/led_matcher.h"

namespace foverig::camera {
namespace {

// Spots of two LEDs this near run into one, whose centre is neither's.
constexpr double kApart_px = 6.0;

struct Nearest {
    std::size_t index = 0;
    double gap_px = 1e9, second_px = 1e9;

    void see(std::size_t i, double gap) {
        if (gap < gap_px) {
            second_px = gap_px;
            gap_px = gap;
            index = i;
        } else if (gap < second_px) {
            second_px = gap;
        }
    }
    bool clear(double gate_px) const { return gap_px <= gate_px && second_px >= 2 * gap_px; }
};

}  // namespace

std::optional<dvec2> pixel_of(const dk2::Led& led, const RigidPose& camera_from_imu,
                              const Lens& lens) {
    const dvec3 place_m = camera_from_imu * led.position_m;
    const dvec3 to_camera = -glm::normalize(place_m);
    if (glm::dot(camera_from_imu.rotation * led.normal, to_camera) < kVisibleCosine) {
        return std::nullopt;
    }
    return lens.project(place_m);
}

std::vector<Match> match_leds(std::span<const dk2::Led> leds, std::span<const TrackedBlob> blobs,
                              const RigidPose& camera_from_imu, const Lens& lens, double gate_px) {
    std::vector<Nearest> blob_of(leds.size()), led_of(blobs.size());
    for (std::size_t l = 0; l < leds.size(); ++l) {
        const auto pixel = pixel_of(leds[l], camera_from_imu, lens);
        if (!pixel) continue;
        for (std::size_t b = 0; b < blobs.size(); ++b) {
            const double gap_px = glm::distance(*pixel, blobs[b].blob.center_px);
            blob_of[l].see(b, gap_px);
            led_of[b].see(l, gap_px);
        }
    }
    std::vector<Match> matches;
    for (std::size_t l = 0; l < leds.size(); ++l) {
        const Nearest& blob = blob_of[l];
        if (!blob.clear(gate_px)) continue;
        const Nearest& back = led_of[blob.index];
        const bool alone = back.second_px >= kApart_px;
        if (back.index == l && alone && back.clear(gate_px)) matches.push_back({l, blob.index});
    }
    return matches;
}

}  // namespace foverig::camera
