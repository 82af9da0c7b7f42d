#pragma once
// A gaze sample in the rig's frame: x right, y up, z back, metres, origin midway between the lens
// centres. The wire's frame is this one turned by 180 degrees about y (DEVICES.md 4.1).
#include <cstdint>

#include "devices/gaze/frames.h"
#include "devices/math.h"
#include "devices/time.h"

namespace foverig {

struct GazeRay {
    bool valid = false;  ///< direction is unit, finite and forward; the rest may be NaN
    dvec3 base_point_m{0};
    dvec3 direction{0, 0, -1};  ///< straight ahead where not valid
};

struct GazeEye {
    GazeRay ray{};
    bool blink = false;
    double confidence = 0;  ///< 0..1
    double openness = 0;    ///< 0..1, NaN if not measured
    double pupil_radius_m = 0;
    gaze::EyeState state = gaze::EyeState::invalid;
    gaze::EyeCause cause = gaze::EyeCause::none;
};

struct GazeSample {
    HostTime host_time{};    ///< mid-exposure through the clock map
    HostTime arrival{};      ///< when its packet was there
    GazeTime device_time{};  ///< mid-exposure
    GazeTime queued{};       ///< given to USB
    std::uint32_t sequence = 0, session = 0, camera_frame = 0;
    bool valid = false;    ///< SMI's isValid
    bool saccade = false;  ///< the device suspects one
    bool calibrated = true;
    bool gap = false;  ///< frames before this one were lost
    GazeEye left{}, right{};
    GazeRay combined{};
    dvec2 por_px{0};                 ///< combined, of the eye's 960x1080, (0, 0) top-left
    double vergence_distance_m = 0;  ///< NaN if diverging or unknown
};

/// Everything but host_time, arrival and gap, which the source knows.
GazeSample to_sample(const gaze::SampleFrame& frame);

}  // namespace foverig
