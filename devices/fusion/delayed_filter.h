#pragma once
// An inertial filter that takes measurements of the past: the states of the last moments are kept,
// a late measurement corrects the one of its instant, and the samples since are run again.
#include <deque>

#include "devices/fusion/inertial_filter.h"
#include "devices/imu_sample.h"
#include "devices/pose_fix.h"

namespace foverig {

struct DelayedFilterConfig {
    InertialNoise noise{};
    Nanoseconds kept{200'000'000};  ///< how late a measurement may be
    double gate = 30.0;             ///< chi-square of 6: one good fix in 25 000 is turned away
};

class DelayedFilter {
  public:
    explicit DelayedFilter(const DelayedFilterConfig& config = {}) : config_(config) {}

    bool started() const { return !steps_.empty(); }
    /// Begins at this pose and sample; `bias_by_warmth_rad_s` as Inertial's.
    void start(const ImuSample& sample, const RigidPose& world_from_imu, const dvec3& velocity_m_s,
               const dvec3& bias_by_warmth_rad_s = dvec3(0));
    void stop() { steps_.clear(); }

    /// In order, once started.
    void add(const ImuSample& sample, const dvec3& bias_by_warmth_rad_s = dvec3(0));
    /// A point `lever_m` from the sensor stands still now, but for `sigma_m_s`.
    void add_rest(const dvec3& lever_m, double sigma_m_s);

    enum class Verdict { taken, unlikely, too_old };
    /// A pose of the past in the world; `covariance` as InertialFilter's.
    Verdict add(Dk2Time taken, const RigidPose& world_from_imu, const Matrix<6, 6>& covariance);

    /// Only once started.
    const InertialFilter::State& now() const { return steps_.back().state; }
    const Inertial& newest() const { return steps_.back().sensed; }
    /// The state of an instant of the kept past, before its newest sample.
    std::optional<InertialFilter::State> state_at(Dk2Time time) const;

  private:
    struct Step {
        Dk2Time time{};
        Inertial sensed;
        InertialFilter::State state;
    };

    std::size_t first_after(Dk2Time time) const;
    Step between(const Step& before, const Step& after, Dk2Time time) const;
    void forget(Dk2Time now);

    DelayedFilterConfig config_;
    std::deque<Step> steps_;
};

}  // namespace foverig
