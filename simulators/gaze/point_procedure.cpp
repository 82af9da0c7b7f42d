#include "simulators/gaze/point_procedure.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "devices/gaze/calibration_targets.h"
#include "devices/gaze_angles.h"
#include "simulators/gaze/tracker_geometry.h"

namespace foverig {
namespace {

using gaze::CalibrationReason;
using gaze::CalibrationState;

constexpr double kWorthless_deg = 2.0;  // residual of quality 0

}  // namespace

PointProcedure::PointProcedure(const Settings& settings, HostTime now) : settings_(settings) {
    show(now);
}

void PointProcedure::tell(CalibrationState state, CalibrationReason reason) {
    const gaze::Vec2f& target_px = settings_.targets_px[point_];
    frames_.push_back(
        {.calibration_id = settings_.id,
         .points = static_cast<std::uint8_t>(settings_.targets_px.size()),
         .current_point = static_cast<std::uint8_t>(point_),
         .state = state,
         .reason = reason,
         .target_por_px = target_px,
         .target_direction = on_wire(gaze_direction(gaze::target_deg_of(target_px)))});
    if (state != CalibrationState::done) return;
    frames_.back().accuracy_deg = accuracy_deg_;
    frames_.back().precision_deg = precision_deg_;
}

std::vector<gaze::CalibrationFrame> PointProcedure::take_frames() {
    return std::exchange(frames_, {});
}

void PointProcedure::show(HostTime now) {
    shown_ = now;
    accepted_.reset();
    sights_.clear();
    tell(CalibrationState::waiting);
}

bool PointProcedure::accept(HostTime now, const std::optional<gaze::Vec2f>& instead) {
    if (over_ || accepted_) return false;
    if (instead) settings_.targets_px[point_] = *instead;
    accepted_ = now;
    tell(CalibrationState::collecting);
    return true;
}

void PointProcedure::abort() {
    over_ = true;
    last_reason_ = CalibrationReason::host_abort;
    tell(CalibrationState::aborted, last_reason_);
}

void PointProcedure::take(const Sight& sight) {
    if (over_) return;
    if (!accepted_) {
        if (sight.exposed - shown_ < kPatience) return;
        over_ = true;
        last_reason_ = CalibrationReason::timed_out;
        return tell(CalibrationState::failed, last_reason_);
    }
    if (sight.exposed <= *accepted_) return;
    if (sight.exposed - *accepted_ > kCollect) return judge(sight.exposed);
    sights_.push_back(sight);
}

/// Where each eye should look, in the middle of what the tables call a target.
PointProcedure::EyeDegrees PointProcedure::wanted_deg() const {
    const motion::EyeState state{
        .direction = gaze_direction(gaze::target_deg_of(settings_.targets_px[point_])),
        .vergence_m = settings_.mapping_m};
    return {gaze_angles_deg(eye_direction(Side::left, state)),
            gaze_angles_deg(eye_direction(Side::right, state))};
}

gaze::DataQuality PointProcedure::quality_of(std::size_t eye, const dvec2& wanted_deg) const {
    gaze::DataQualityMeter meter;
    for (const Sight& sight : sights_) {
        if (sight.gaze_deg)
            meter.add(gaze_direction((*sight.gaze_deg)[eye]));
        else
            meter.gap();
    }
    return meter.against(gaze_direction(wanted_deg));
}

std::optional<CalibrationReason> PointProcedure::fault_of_point() const {
    const auto seen = std::count_if(sights_.begin(), sights_.end(),
                                    [](const Sight& sight) { return sight.gaze_deg.has_value(); });
    if (seen < kLeastSights ||
        static_cast<double>(seen) < kLeastSeen * static_cast<double>(sights_.size()))
        return CalibrationReason::no_eyes;
    for (const std::size_t eye : {0U, 1U})
        if (!(quality_of(eye, dvec2(0.0)).sd_deg < kUnstable_deg))
            return CalibrationReason::unstable;
    return std::nullopt;
}

void PointProcedure::judge(HostTime now) {
    if (const auto fault = fault_of_point()) {
        last_reason_ = *fault;
        tell(CalibrationState::point_rejected, *fault);
        return show(now);
    }
    const EyeDegrees wanted = wanted_deg();
    for (const std::size_t eye : {0U, 1U}) {
        const gaze::DataQuality quality = quality_of(eye, wanted[eye]);
        dvec2 sum_deg(0.0);
        for (const Sight& sight : sights_)
            if (sight.gaze_deg) sum_deg += (*sight.gaze_deg)[eye];
        measured_deg_[eye].push_back(sum_deg / static_cast<double>(quality.samples));
        wanted_deg_[eye].push_back(wanted[eye]);
        squared_s2s_deg2_[eye] += quality.rms_s2s_deg * quality.rms_s2s_deg;
        if (settings_.kind == Kind::calibrate) continue;
        accuracy_deg_[eye] = static_cast<float>(quality.accuracy_deg);
        precision_deg_[eye] = static_cast<float>(quality.rms_s2s_deg);
    }
    tell(settings_.kind == Kind::calibrate ? CalibrationState::point_accepted
                                           : CalibrationState::done);
    next_point(now);
}

void PointProcedure::next_point(HostTime now) {
    if (point_ + 1 < settings_.targets_px.size()) {
        ++point_;
        return show(now);
    }
    over_ = true;
    if (settings_.kind == Kind::calibrate) finish_calibration();
}

void PointProcedure::finish_calibration() {
    const auto count = static_cast<double>(settings_.targets_px.size());
    std::array<CalibrationMap, 2> maps;
    double worst_deg = 0.0;
    for (const std::size_t eye : {0U, 1U}) {
        const auto map = CalibrationMap::fit(static_cast<int>(settings_.targets_px.size()),
                                             measured_deg_[eye], wanted_deg_[eye]);
        if (!map) {
            last_reason_ = CalibrationReason::unstable;
            return tell(CalibrationState::failed, last_reason_);
        }
        maps[eye] = *map;
        double residuals_deg = 0.0;
        for (std::size_t i = 0; i < measured_deg_[eye].size(); ++i)
            residuals_deg +=
                angle_between_deg(gaze_direction(map->corrected_deg(measured_deg_[eye][i])),
                                  gaze_direction(wanted_deg_[eye][i]));
        worst_deg = std::max(worst_deg, residuals_deg / count);
        precision_deg_[eye] = static_cast<float>(std::sqrt(squared_s2s_deg2_[eye] / count));
        // One point is met exactly, whatever the eye: that says nothing.
        if (settings_.targets_px.size() > 1)
            accuracy_deg_[eye] = static_cast<float>(residuals_deg / count);
    }
    maps_ = maps;
    if (settings_.targets_px.size() > 1)
        quality_ = static_cast<std::uint8_t>(
            std::lround(100.0 * std::max(0.0, 1.0 - worst_deg / kWorthless_deg)));
    tell(CalibrationState::done);
}

}  // namespace foverig
