#pragma once
// The inputs of every frame that is timed: the scene's camera path with a moving head and gaze.
#include "renderer/renderer.h"
#include "rig/session/camera_flight.h"

namespace foverig::bench {

struct EyeSize {
    int width_px = 1182;  ///< DK2, one eye at density 1 (DEVICES.md 2.2)
    int height_px = 1464;
};

/// One DK2 eye along the scene's path at 75 Hz. The head turns by +-20 deg at 0.4 Hz (50 deg/s at
/// most) and nods by +-5 deg; gaze rests 0.3 s each at places within +-15 deg, jumping between
/// them.
class Flight {
  public:
    static constexpr double kRate_hz = 75.0;

    explicit Flight(const Scene& scene, const EyeSize& size = {});

    FrameInput frame(int index) const;
    int frame_count() const;  ///< of the path, one way

  private:
    CameraFlight path_;
    EyeSize size_;
    double one_way_s_;
};

}  // namespace foverig::bench
