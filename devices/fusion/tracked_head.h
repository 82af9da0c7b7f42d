#pragma once
// The head from its inertial sensor and a camera that sees it: yaw and position do not drift
// (docs/camera.md). Without fixes it is HeadFusion, bit for bit.
//
// At first HeadFusion alone; the first fixes say where the camera stands in its world (gravity
// gives two angles, the start the third, the neck the place). From then on an inertial filter is
// corrected by each fix at its own instant. Without fixes for a while, a neck that stands still
// keeps velocity and position from running away. What a correction changes is shown over a short
// time, not as a jump. Between fixes the gyro's bias moves on with the chip's temperature, by the
// slope that HeadFusion learns.
#include <vector>

#include "devices/fusion/delayed_filter.h"
#include "devices/fusion/head_fusion.h"

namespace foverig {

struct TrackedHeadConfig {
    HeadFusionConfig inertial{};
    DelayedFilterConfig filter{};
    int fixes_to_place_camera = 30;
    double fix_floor_m = 0.0005;      ///< what a fix's own covariance does not know: geometry, lens
    double fix_floor_rad = 0.002;     ///< idem
    int unlikely_until_restart = 15;  ///< fixes in a row that the filter would not believe
    Nanoseconds alone_after{100'000'000};    ///< without a fix: the neck is taken to stand still
    Nanoseconds stale_after{1'000'000'000};  ///< without a fix: `camera_lost`
    double neck_sigma_m_s = 0.05;
    double smoothing_s = 0.06;  ///< time constant of corrections in what is shown
};

struct TrackedHeadCounts {
    std::uint64_t fixes = 0, unlikely = 0, too_old = 0, restarts = 0;
};

class TrackedHead {
  public:
    explicit TrackedHead(const TrackedHeadConfig& config = {})
        : config_(config), inertial_(config.inertial), filter_(config.filter) {}

    /// As HeadFusion's.
    void add(const ImuSample& sample);
    /// In order of their instants, each after the samples around it. One that tracking would begin
    /// with counts as too old beyond HeadFusionConfig::max_prediction, later ones beyond what the
    /// filter keeps.
    void add(const PoseFix& fix);

    /// As HeadFusion's.
    Pose at(HostTime time) const;

    /// Where the sensor was, or is about to be, before the camera; once the camera's place is
    /// known.
    std::optional<RigidPose> expected(Dk2Time time) const;

    /// Position and yaw rest on the camera.
    bool tracking() const { return filter_.started(); }
    bool camera_lost() const;
    const HeadFusion& inertial() const { return inertial_; }
    const std::optional<RigidPose>& world_from_camera() const { return world_from_camera_; }
    const TrackedHeadCounts& counts() const { return counts_; }
    /// What the filter has learnt; zero before it started.
    dvec3 gyro_bias_rad_s() const;

  private:
    bool is_beyond_inertia(const PoseFix& fix) const;
    void place_camera(const PoseFix& fix);
    void begin(const PoseFix& fix);
    RigidPose sensor_by_inertia(HostTime time) const;
    void correct(const PoseFix& fix);
    Matrix<6, 6> spread_of(const PoseFix& fix) const;
    RigidPose shown() const;
    void show_as_before(const RigidPose& before);

    TrackedHeadConfig config_;
    HeadFusion inertial_;
    DelayedFilter filter_;
    ImuSample newest_;
    dvec3 bias_by_warmth_rad_s_{0};  // since the first sample, by the slope that HeadFusion learns
    std::vector<RigidPose> places_;  // of the camera, by one fix each, until there are enough
    std::optional<RigidPose> world_from_camera_;
    Dk2Time last_fix_{};
    Dk2Time next_rest_{};
    int unlikely_in_row_ = 0;
    dvec3 turn_left_rad_{0}, way_left_m_{0};  // of corrections that are not yet shown
    TrackedHeadCounts counts_;
};

}  // namespace foverig
