#pragma once
#include <array>
#include <span>

#include "devices/rigid_pose.h"

namespace foverig {

/// A room that is not there: a box of 6 x 3 x 6 m around the place where the head is upright, each
/// wall of a colour of its own with tiles of half a metre, light and dark by turns.
class RoomView {
  public:
    /// `fov_deg` is the camera's horizontal field of view, without distortion; the width is even.
    RoomView(int width_px, int height_px, double fov_deg);

    /// YUYV rows without padding (BT.601, limited range). The camera's axes are a head's: x right,
    /// y up, z back. It stands inside the room.
    void render(const RigidPose& world_from_camera, std::span<std::byte> yuyv) const;

  private:
    int width_px_, height_px_;
    double tan_half_;  // of the width
};

}  // namespace foverig
