#pragma once
// Where the headset is, of LEDs whose pixels are known: perspective-n-point by OpenCV's calib3d,
// which no other file names.
#include <optional>
#include <span>
#include <vector>

#include "devices/camera/lens.h"
#include "devices/matrix.h"
#include "devices/rigid_pose.h"

namespace foverig::camera {

struct Correspondence {
    dvec3 point_m{0};  ///< in the inertial sensor's frame
    dvec2 pixel{0};
};

struct SolvedPose {
    RigidPose camera_from_imu;
    std::vector<std::size_t> inliers;  ///< of the correspondences
    double rms_px = 0;                 ///< reprojection error of the inliers, per point
    /// Of (rotation in the sensor's frame, rad; translation in the camera's, m), in that order, as
    /// the pixels' own scatter and the geometry give it. No systematic error is in it.
    Matrix<6, 6> covariance;
};

struct SolverConfig {
    double inlier_px = 1.5;
    std::size_t least_inliers = 5;
    double least_sigma_px = 0.1;  ///< a centroid is not believed to be better
};

/// No guess needed: random samples agree first (RANSAC), then all inliers decide. Deterministic.
std::optional<SolvedPose> solve_pose(std::span<const Correspondence> points, const Lens& lens,
                                     const SolverConfig& config = {});

/// From a guess that is good to a few degrees; outliers of the refined pose are left out once more.
std::optional<SolvedPose> refine_pose(std::span<const Correspondence> points, const Lens& lens,
                                      const RigidPose& guess, const SolverConfig& config = {});

}  // namespace foverig::camera
