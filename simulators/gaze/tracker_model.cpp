#include "simulators/gaze/tracker_model.h"

#include <cmath>
#include <numbers>

namespace foverig {
namespace {

using gaze::EyeBlock;
using gaze::SampleFrame;

constexpr double kEccentricityScale_deg = 20.0;
constexpr double kLidPull_deg = 2.0;  // a half-closed lid drags the measured pupil down
constexpr float kRightEyesPor_px = 960.0F;
constexpr float kConfidence = 0.95f, kLidConfidence = 0.5f;

gaze::Vec2f pair_of(const dvec2& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y)};
}

EyeBlock tracked_eye(Side side, const dvec3& direction, double openness) {
    EyeBlock eye;
    const dvec3 base_mm = eye_base_mm(side);
    dvec2 por_px = por_in_eye_px(side, direction);
    if (side == Side::right) por_px.x += kRightEyesPor_px;
    eye.base_point_mm = on_wire(base_mm);
    eye.direction = on_wire(direction);
    eye.por_px = pair_of(por_px);
    eye.pupil_mm = on_wire(base_mm + kPupilAhead_mm * direction);
    eye.pupil_radius_mm = static_cast<float>(kPupilRadius_mm);
    eye.lens_distance_mm = static_cast<float>(kLensDistance_mm);
    eye.screen_distance_mm = static_cast<float>(kScreenDistance_mm);
    eye.openness = static_cast<float>(openness);
    eye.confidence = kConfidence;
    eye.state = gaze::EyeState::tracked;
    return eye;
}

EyeBlock unseen_eye(gaze::EyeCause cause, double openness) {
    EyeBlock eye;
    eye.openness = static_cast<float>(openness);
    eye.cause = cause;
    return eye;
}

SampleFrame unseen_sample(gaze::EyeCause cause, double openness) {
    SampleFrame frame;
    frame.iod_mm = static_cast<float>(kIod_mm);
    frame.left = frame.right = unseen_eye(cause, openness);
    if (cause == gaze::EyeCause::blink) {
        frame.status = gaze::sample_status::left_blink | gaze::sample_status::right_blink;
    }
    return frame;
}

SampleFrame seen_sample(const dvec3& left, const dvec3& right, const dvec3& combined,
                        const motion::EyeState& state) {
    SampleFrame frame;
    frame.left = tracked_eye(Side::left, left, state.openness);
    frame.right = tracked_eye(Side::right, right, state.openness);
    const dvec3 between_pupils = eye_base_mm(Side::right) + kPupilAhead_mm * right -
                                 (eye_base_mm(Side::left) + kPupilAhead_mm * left);
    frame.iod_mm = static_cast<float>(kIod_mm);
    frame.ipd_mm = static_cast<float>(glm::length(between_pupils));
    frame.base_point_mm = on_wire(cyclops_base_mm());
    frame.direction = on_wire(combined);
    frame.por_px =
        pair_of(0.5 * (por_in_eye_px(Side::left, left) + por_in_eye_px(Side::right, right)));
    frame.vergence_distance_mm = static_cast<float>(1000.0 * state.vergence_m);
    frame.status = gaze::sample_status::valid | gaze::sample_status::left_valid |
                   gaze::sample_status::right_valid | gaze::sample_status::combined_valid;
    return frame;
}

void lower_confidence(EyeBlock& eye) {
    eye.confidence = kLidConfidence;
    eye.state = gaze::EyeState::compensated;
    eye.cause = gaze::EyeCause::blink;
}

}  // namespace

void shut_eye(SampleFrame& frame, Side side) {
    namespace status = gaze::sample_status;
    if ((frame.status & status::valid) == 0) return;
    const bool left = side == Side::left;
    (left ? frame.left : frame.right) = unseen_eye(gaze::EyeCause::blink, 0.0);
    frame.status = static_cast<std::uint16_t>(
        (frame.status & ~(left ? status::left_valid : status::right_valid)) |
        (left ? status::left_blink : status::right_blink));
    const EyeBlock& open = left ? frame.right : frame.left;
    frame.base_point_mm = open.base_point_mm;
    frame.direction = open.direction;
    frame.por_px = {open.por_px[0] - (left ? kRightEyesPor_px : 0.0F), open.por_px[1]};
    frame.ipd_mm = frame.vergence_distance_mm = gaze::kNotMeasured;
}

TrackerModel::TrackerModel(const motion::EyeMotion& eyes, const GazeFaults& faults,
                           std::uint64_t seed)
    : eyes_(eyes), faults_(faults), noise_(seed, 800) {
    if (faults.blink > 0.0) blinking_.emplace(eyes, seed, faults.blink);
    if (faults.user > 0.0) {
        user_ = {UserEye(Side::left, seed, faults.user), UserEye(Side::right, seed, faults.user)};
    }
    const motion::Draws draws(seed, 801);
    for (std::size_t eye = 0; eye < 2; ++eye) {
        offset_deg_[eye] = faults.offset * dvec2(draws.normal(2 * eye), draws.normal(2 * eye + 1));
    }
    const double heading = 2.0 * std::numbers::pi * draws.uniform(4);
    slip_direction_ = {std::cos(heading), std::sin(heading)};
}

motion::EyeState TrackerModel::state_at(double t_s) const {
    return blinking_ ? blinking_->at(t_s) : eyes_.at(t_s);
}

bool TrackerModel::near_blink(double t_s, double period_s) const {
    return state_at(t_s - period_s).openness < kInvalidBelow ||
           state_at(t_s + period_s).openness < kInvalidBelow;
}

/// One step of an AR(1) process for each eye and axis; both eyes share a part.
void TrackerModel::step_noise(double ecc_deg, std::uint64_t index) {
    const double ecc = ecc_deg / kEccentricityScale_deg;
    const double sigma_deg = faults_.noise * (1.0 + ecc * ecc);
    const double fresh = std::sqrt(1.0 - kNoiseLag1 * kNoiseLag1);
    const dvec2 shared(noise_.normal(8 * index), noise_.normal(8 * index + 1));
    for (std::size_t eye = 0; eye < 2; ++eye) {
        const std::uint64_t i = 8 * index + 2 + 2 * eye;
        const dvec2 own(noise_.normal(i), noise_.normal(i + 1));
        const dvec2 drawn = std::sqrt(kNoiseShared) * shared + std::sqrt(1.0 - kNoiseShared) * own;
        noise_deg_[eye] = kNoiseLag1 * noise_deg_[eye] + fresh * sigma_deg * drawn;
    }
}

dvec2 TrackerModel::systematic_error_deg(std::size_t eye, const dvec2& gaze_deg, double t_s) const {
    const dvec2 share = gaze_deg / kEccentricityScale_deg;
    return offset_deg_[eye] + faults_.crosstalk * dvec2(share.y * share.y, share.x * share.x) +
           faults_.slip * (t_s / 60.0) * slip_direction_;
}

void TrackerModel::smooth(Gaze& gaze_deg, double rate_hz) {
    const double gain = -std::expm1(-2.0 * std::numbers::pi * kLowPass_hz / rate_hz);
    if (!smoothed_) smoothed_ = gaze_deg;
    for (std::size_t eye = 0; eye < 2; ++eye) {
        (*smoothed_)[eye] += gain * (gaze_deg[eye] - (*smoothed_)[eye]);
    }
    gaze_deg = *smoothed_;
}

TrackerModel::Gaze TrackerModel::measured_deg(const Gaze& true_deg, double ecc_deg, double t_s,
                                              std::uint64_t index) {
    if (faults_.noise > 0.0) step_noise(ecc_deg, index);
    Gaze measured = true_deg;
    for (std::size_t eye = 0; eye < 2; ++eye) {
        if (user_) measured[eye] = (*user_)[eye].seen_deg(true_deg[eye]);
        measured[eye] += noise_deg_[eye] + systematic_error_deg(eye, true_deg[eye], t_s);
    }
    return measured;
}

SampleFrame TrackerModel::measure(double t_s, double rate_hz, bool low_pass,
                                  std::optional<gaze::EyeCause> unseen) {
    const motion::EyeState state = state_at(t_s);
    const dvec2 true_deg = motion::gaze_of(state.direction);
    const Gaze true_eye_deg{motion::gaze_of(eye_direction(Side::left, state)),
                            motion::gaze_of(eye_direction(Side::right, state))};
    Gaze eye_deg = measured_deg(true_eye_deg, glm::length(true_deg), t_s, samples_++);
    raw_deg_.reset();
    if (unseen)
        return unseen_sample(*unseen, *unseen == gaze::EyeCause::blink ? 0.0 : state.openness);
    if (state.openness < kInvalidBelow) return unseen_sample(gaze::EyeCause::blink, state.openness);

    const bool lid_moves = state.openness < 1.0 && near_blink(t_s, 1.0 / rate_hz);
    if (lid_moves) {
        for (dvec2& gaze_deg : eye_deg) gaze_deg.y -= kLidPull_deg;
    }
    if (!lid_moves) raw_deg_ = eye_deg;
    if (maps_) {
        for (std::size_t eye = 0; eye < 2; ++eye) {
            eye_deg[eye] = (*maps_)[eye].corrected_deg(eye_deg[eye]);
        }
    }
    if (low_pass) smooth(eye_deg, rate_hz);
    const dvec2 error_deg = 0.5 * (eye_deg[0] - true_eye_deg[0] + eye_deg[1] - true_eye_deg[1]);
    SampleFrame frame =
        seen_sample(motion::direction_of(eye_deg[0]), motion::direction_of(eye_deg[1]),
                    motion::direction_of(true_deg + error_deg), state);
    if (lid_moves) {
        lower_confidence(frame.left);
        lower_confidence(frame.right);
    }
    return frame;
}

}  // namespace foverig
