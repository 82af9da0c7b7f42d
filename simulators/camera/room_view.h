#pragma once
#include <array>
#include <span>
#include <vector>

#include "devices/camera/any_lens.h"
#include "devices/rigid_pose.h"

namespace foverig {

/// A room that is not there: a box of 6 x 3 x 6 m around the place where the head is upright, each
/// wall of a colour of its own with tiles of half a metre, light and dark by turns.
class RoomView {
  public:
    /// Of a camera with this lens; the width is even.
    RoomView(int width_px, int height_px, const camera::AnyLens& lens);

    /// YUYV rows without padding (BT.601, limited range). The camera's axes are a head's: x right,
    /// y up, z back. It stands inside the room.
    void render(const RigidPose& world_from_camera, std::span<std::byte> yuyv) const;

  private:
    void render_bent(const RigidPose& world_from_camera, std::span<std::byte> yuyv) const;

    int width_px_, height_px_;
    camera::Lens straight_;        // where rays_ is empty
    std::vector<glm::vec3> rays_;  // of each pair of pixels, in the head's axes; 0: it sees nothing
};

}  // namespace foverig
