#pragma once
// Which spot is which LED, where the pose is nearly known.
#include <optional>
#include <span>
#include <vector>

#include "devices/camera/blob_tracks.h"
#include "devices/camera/lens.h"
#include "devices/rigid_pose.h"

namespace foverig::camera {

/// An LED shines into a cone about its normal; beyond 75 degrees the headset's shell or the
/// chip's own edge hides it (own choice; VSMY3850 falls to half at 60 degrees).
inline constexpr double kVisibleCosine = 0.2588;

/// The pixel of an LED that faces the camera; nothing where it does not, or lies out of view.
std::optional<dvec2> pixel_of(const dk2::Led& led, const RigidPose& camera_from_imu,
                              const Lens& lens);

struct Match {
    std::size_t led = 0, blob = 0;
};

/// Pairs of an LED and a spot that are each other's nearest within `gate_px`, with no second spot
/// or LED within twice the distance that could be meant instead.
std::vector<Match> match_leds(std::span<const dk2::Led> leds, std::span<const TrackedBlob> blobs,
                              const RigidPose& camera_from_imu, const Lens& lens, double gate_px);

}  // namespace foverig::camera
