#include "devices/camera/pose_solver.h"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "devices/fusion/rotation.h"

namespace foverig::camera {
namespace {

constexpr int kSamples = 100;
constexpr double kConfidence = 0.999;
constexpr int kRounds = 3;  // refine, leave outliers out, again
constexpr double kStep_m = 1e-5;

cv::Mat camera_matrix(const Lens& lens) {
    return (cv::Mat_<double>(3, 3) << lens.fx_px, 0, lens.cx_px, 0, lens.fy_px, lens.cy_px, 0, 0,
            1);
}
cv::Mat distortion(const Lens& lens) {
    return (cv::Mat_<double>(1, 5) << lens.k1, lens.k2, lens.p1, lens.p2, lens.k3);
}

struct Points {
    std::vector<cv::Point3d> object;
    std::vector<cv::Point2d> image;

    Points(std::span<const Correspondence> all, std::span<const std::size_t> chosen) {
        for (const std::size_t i : chosen) {
            object.emplace_back(all[i].point_m.x, all[i].point_m.y, all[i].point_m.z);
            image.emplace_back(all[i].pixel.x, all[i].pixel.y);
        }
    }
};

RigidPose pose_of(const cv::Vec3d& rotation, const cv::Vec3d& translation) {
    return {exp_map(dvec3(rotation[0], rotation[1], rotation[2])),
            dvec3(translation[0], translation[1], translation[2])};
}

/// The pixel and how it moves with the point, in the camera's frame.
struct Projected {
    dvec2 pixel{0};
    std::array<dvec2, 3> by_axis{};  ///< px/m
};
std::optional<Projected> project(const Lens& lens, const dvec3& camera_m) {
    const auto pixel = lens.project(camera_m);
    if (!pixel) return std::nullopt;
    Projected out{.pixel = *pixel};
    for (int axis = 0; axis < 3; ++axis) {
        dvec3 step(0);
        step[axis] = kStep_m;
        const auto ahead = lens.project(camera_m + step), back = lens.project(camera_m - step);
        if (!ahead || !back) return std::nullopt;
        out.by_axis[static_cast<std::size_t>(axis)] = (*ahead - *back) / (2 * kStep_m);
    }
    return out;
}

std::vector<std::size_t> within(std::span<const Correspondence> points, const Lens& lens,
                                const RigidPose& pose, double limit_px) {
    std::vector<std::size_t> in;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto pixel = lens.project(pose * points[i].point_m);
        if (pixel && glm::distance(*pixel, points[i].pixel) <= limit_px) in.push_back(i);
    }
    return in;
}

/// Residuals and information matrix; nothing where the geometry leaves a direction open.
bool judge(std::span<const Correspondence> points, const Lens& lens, const SolverConfig& config,
           SolvedPose& solved) {
    const RigidPose& pose = solved.camera_from_imu;
    Matrix<6, 6> information;
    double squares = 0;
    for (const std::size_t i : solved.inliers) {
        const auto seen = project(lens, pose * points[i].point_m);
        if (!seen) return false;
        const dvec2 error_px = seen->pixel - points[i].pixel;
        squares += glm::dot(error_px, error_px);
        // A turn by d about the sensor's axes moves the point by -R [p]x d.
        const dmat3 by_turn = glm::mat3_cast(pose.rotation) * -cross_matrix(points[i].point_m);
        std::array<dvec2, 6> row{};
        for (std::size_t k = 0; k < 3; ++k) {
            row[k + 3] = seen->by_axis[k];
            for (std::size_t axis = 0; axis < 3; ++axis) {
                row[k] +=
                    seen->by_axis[axis] * by_turn[static_cast<int>(k)][static_cast<int>(axis)];
            }
        }
        for (std::size_t r = 0; r < 6; ++r) {
            for (std::size_t c = 0; c < 6; ++c) information(r, c) += glm::dot(row[r], row[c]);
        }
    }
    const double freedom = 2.0 * static_cast<double>(solved.inliers.size()) - 6.0;
    solved.rms_px = std::sqrt(squares / static_cast<double>(solved.inliers.size()));
    const double sigma2 =
        std::max(squares / freedom, config.least_sigma_px * config.least_sigma_px);
    const auto covariance = inverse_spd(information);
    if (!covariance) return false;
    solved.covariance = *covariance;
    solved.covariance *= sigma2;
    return true;
}

}  // namespace

std::optional<SolvedPose> refine_pose(std::span<const Correspondence> points, const Lens& lens,
                                      const RigidPose& guess, const SolverConfig& config) {
    SolvedPose solved;
    solved.camera_from_imu = guess;
    // The guess itself may be off by more than a pixel: the first round believes every pair.
    for (std::size_t i = 0; i < points.size(); ++i) solved.inliers.push_back(i);
    for (int round = 0; round < kRounds; ++round) {
        if (solved.inliers.size() < config.least_inliers) return std::nullopt;
        const Points chosen(points, solved.inliers);
        const dvec3 turn = log_map(solved.camera_from_imu.rotation);
        const dvec3& way = solved.camera_from_imu.translation_m;
        cv::Vec3d rotation(turn.x, turn.y, turn.z), translation(way.x, way.y, way.z);
        cv::solvePnPRefineLM(chosen.object, chosen.image, camera_matrix(lens), distortion(lens),
                             rotation, translation);
        solved.camera_from_imu = pose_of(rotation, translation);
        auto in = within(points, lens, solved.camera_from_imu, config.inlier_px);
        const bool settled = in == solved.inliers;
        solved.inliers = std::move(in);
        if (settled) break;
    }
    if (solved.inliers.size() < config.least_inliers) return std::nullopt;
    if (!judge(points, lens, config, solved)) return std::nullopt;
    return solved;
}

std::optional<SolvedPose> solve_pose(std::span<const Correspondence> points, const Lens& lens,
                                     const SolverConfig& config) {
    if (points.size() < std::max<std::size_t>(config.least_inliers, 4)) return std::nullopt;
    std::vector<std::size_t> all(points.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    const Points chosen(points, all);
    cv::Vec3d rotation, translation;
    std::vector<int> in;
    const bool found = cv::solvePnPRansac(
        chosen.object, chosen.image, camera_matrix(lens), distortion(lens), rotation, translation,
        false, kSamples, static_cast<float>(config.inlier_px), kConfidence, in, cv::SOLVEPNP_SQPNP);
    if (!found || in.size() < config.least_inliers) return std::nullopt;
    std::vector<Correspondence> agreed;
    std::vector<std::size_t> index;
    for (const int i : in) {
        index.push_back(static_cast<std::size_t>(i));
        agreed.push_back(points[index.back()]);
    }
    auto solved = refine_pose(agreed, lens, pose_of(rotation, translation), config);
    if (!solved) return std::nullopt;
    for (std::size_t& i : solved->inliers) i = index[i];
    return solved;
}

}  // namespace foverig::camera
