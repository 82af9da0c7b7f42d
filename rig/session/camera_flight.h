#pragma once
// Where the person is put in the scene, before the head moves.
#include <vector>

#include "renderer/scene/scene.h"
#include "rig/scenario/scenario.h"

namespace foverig {

/// Place of the point between the eyes and the direction of straight ahead, y up.
struct Stand {
    dvec3 position_m{0.0};
    dmat3 world_from_body{1.0};
};

class CameraFlight {
  public:
    /// The scene's path (`scene`), the scenario's (`keys`), or the scenario's place or the first
    /// key of the scene's path (`still`).
    CameraFlight(const CameraSettings& settings, const Scene& scene);

    /// There and back along a smooth curve through the keys, once each way in `camera_path_s`;
    /// eases in and out at the ends, so that the flight goes on for any time without a jump.
    Stand at(double time_s) const;

  private:
    std::vector<CameraKey> keys_;
    double one_way_s_ = 1.0;
};

}  // namespace foverig
