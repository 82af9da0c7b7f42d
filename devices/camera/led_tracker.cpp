#include "devices/camera/led_tracker.h"

#include <algorithm>

namespace foverig::camera {

LedTracker::LedTracker(std::vector<dk2::Led> leds, const Lens& lens, const LedTrackerConfig& config)
    : leds_(std::move(leds)), lens_(lens), config_(config), tracks_(leds_, config.tracks) {}

std::optional<SolvedPose> LedTracker::see(const GreyView& image, int exposure, std::uint8_t pattern,
                                          const std::optional<RigidPose>& expected) {
    ++counts_.images;
    const auto blobs = find_blobs(image, config_.blobs);
    if (blobs.size() > config_.blobs.most_blobs) {
        ++counts_.crowded;
        spots_.clear();
        return std::nullopt;
    }
    spots_ = tracks_.follow(blobs, exposure, pattern);
    std::optional<SolvedPose> pose;
    if (expected) {
        if (const auto rough = near(*expected, config_.match_gate_px)) {
            pose = settled(rough->camera_from_imu);
        }
    }
    if (!pose) {
        if (const auto rough = by_blinking()) {
            pose = settled(rough->camera_from_imu);
            if (pose) ++counts_.acquired;
        }
    }
    if (pose) ++counts_.poses;
    return pose;
}

std::optional<SolvedPose> LedTracker::near(const RigidPose& expected, double gate_px) const {
    std::vector<Correspondence> points;
    for (const Match& m : match_leds(leds_, spots_, expected, lens_, gate_px)) {
        points.push_back({leds_[m.led].position_m, spots_[m.blob].blob.center_px});
    }
    return refine_pose(points, lens_, expected, config_.solver);
}

std::optional<SolvedPose> LedTracker::by_blinking() const {
    std::vector<Correspondence> points;
    for (const TrackedBlob& spot : spots_) {
        if (spot.led) points.push_back({leds_[*spot.led].position_m, spot.blob.center_px});
    }
    return solve_pose(points, lens_, config_.solver);
}

bool LedTracker::contradicted(std::span<const Match> matches) const {
    std::size_t known = 0, wrong = 0;
    for (const Match& m : matches) {
        const auto& led = spots_[m.blob].led;
        if (!led) continue;
        ++known;
        if (*led != m.led) ++wrong;
    }
    return static_cast<double>(wrong) > config_.most_contradicted * static_cast<double>(known);
}

/// The pose decided by every LED that it puts near a spot, or nothing where that does not hold up.
std::optional<SolvedPose> LedTracker::settled(const RigidPose& pose) {
    const auto matches = match_leds(leds_, spots_, pose, lens_, config_.settled_gate_px);
    if (contradicted(matches)) {
        ++counts_.contradicted;
        return std::nullopt;
    }
    auto solved = near(pose, config_.settled_gate_px);
    if (!solved || solved->rms_px > config_.most_rms_px) return std::nullopt;
    const auto asked = std::count_if(leds_.begin(), leds_.end(), [&](const dk2::Led& led) {
        return pixel_of(led, solved->camera_from_imu, lens_).has_value();
    });
    if (static_cast<double>(solved->inliers.size()) <
        config_.least_explained * static_cast<double>(std::min<std::ptrdiff_t>(asked, 12))) {
        return std::nullopt;
    }
    return solved;
}

}  // namespace foverig::camera
