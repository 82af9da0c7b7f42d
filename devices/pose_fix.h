#pragma once
#include "devices/matrix.h"
#include "devices/rigid_pose.h"
#include "devices/time.h"

namespace foverig {

/// Where a camera saw the headset's inertial sensor, and when; it is known only later.
struct PoseFix {
    Dk2Time taken_device{};  ///< on the sensor's clock: the middle of the exposure
    HostTime taken{}, arrival{};
    RigidPose camera_from_imu;
    /// Of (rotation in the sensor's frame, rad; translation in the camera's, m), in that order.
    Matrix<6, 6> covariance{};
    double rms_px = 0;  ///< reprojection error
    int points = 0;
};

}  // namespace foverig
