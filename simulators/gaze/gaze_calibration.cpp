// GazeFirmware's calibration and validation (DEVICES.md 4.5.5, 4.5.6).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "devices/gaze/calibration_targets.h"
#include "devices/gaze_angles.h"
#include "simulators/gaze/gaze_firmware.h"

namespace foverig {
namespace {

using gaze::DeviceState;

constexpr std::size_t kMostTargets = 64;
constexpr double kDefaultMapping_m = 1.5;
constexpr float kEyeWidth_px = 960.0F, kEyeHeight_px = 1080.0F;
constexpr std::size_t kHeadBytes = 4;  // of the stored data: points, quality, 2 unused

bool on_display(const gaze::Vec2f& px) {
    return px[0] >= 0.0F && px[0] <= kEyeWidth_px && px[1] >= 0.0F && px[1] <= kEyeHeight_px;
}

bool known_points(std::uint16_t points) {
    return std::find(gaze::kCalibrationPoints.begin(), gaze::kCalibrationPoints.end(), points) !=
           gaze::kCalibrationPoints.end();
}

dvec2 sent_deg(const gaze::EyeBlock& eye) {
    const auto& d = eye.direction;
    return gaze_angles_deg(dvec3(-d[0], d[1], -d[2]));
}

/// Pairs, `count` of them where there are any, all on the display; else the reason.
Result<std::vector<gaze::Vec2f>> targets_of(Bytes data, std::size_t count) {
    auto targets = gaze::decode_targets(data);
    if (!targets) return targets.error();
    const bool fit = targets->empty() || targets->size() == count;
    if (!fit || !std::all_of(targets->begin(), targets->end(), on_display)) {
        return Error{ErrorCode::invalid_data,
                     fmt::format("expected {} targets within 960x1080 px", count)};
    }
    return targets;
}

}  // namespace

void GazeFirmware::begin_points(PointProcedure::Kind kind, std::vector<gaze::Vec2f> targets_px,
                                HostTime now) {
    const bool calibrate = kind == PointProcedure::Kind::calibrate;
    points_.emplace(
        PointProcedure::Settings{.kind = kind,
                                 .id = calibrate ? static_cast<std::uint16_t>(calibrations_ + 1)
                                                 : status_.calibration_id,
                                 .targets_px = std::move(targets_px),
                                 .mapping_m = std::isinf(status_.mapping_mm)
                                                  ? kDefaultMapping_m
                                                  : 1e-3 * static_cast<double>(status_.mapping_mm)},
        now);
    status_.state = DeviceState::calibrating;
    status_.last_error = 0;
    tell_points(now);
}

Status GazeFirmware::start_calibration(std::uint16_t points, Bytes data, HostTime now) {
    if (!known_points(points)) {
        return stall(fmt::format("CAL_START {}; expected 0, 1, 3, 5, 9 or 13 points", points));
    }
    if (points_) return stall("CAL_START while calibrating");
    auto targets = targets_of(data, points);
    if (!targets) return stall("CAL_START: " + targets.error().text);
    if (points == 0) {
        forget_calibration();
        if (running()) told_.push_back({now, {.state = gaze::CalibrationState::done}});
        return Done{};
    }
    if (!running()) return stall("CAL_START before START");
    std::vector<gaze::Vec2f> targets_px = std::move(targets).value();
    if (targets_px.empty()) {
        for (const dvec2& point : gaze::default_points(points)) {
            targets_px.push_back({static_cast<float>(point.x) * kEyeWidth_px,
                                  static_cast<float>(point.y) * kEyeHeight_px});
        }
    }
    begin_points(PointProcedure::Kind::calibrate, std::move(targets_px), now);
    return Done{};
}

Status GazeFirmware::validate(std::uint16_t points, Bytes data, HostTime now) {
    if (points_) return stall("VALIDATE while calibrating");
    if (!running()) return stall("VALIDATE before START");
    auto targets = targets_of(data, points);
    if (!targets) return stall("VALIDATE: " + targets.error().text);
    if (targets->empty() || targets->size() > kMostTargets) {
        return stall(fmt::format("VALIDATE {}; expected 1 to {} targets", points, kMostTargets));
    }
    begin_points(PointProcedure::Kind::validate, std::move(targets).value(), now);
    return Done{};
}

Status GazeFirmware::accept_point(Bytes data, HostTime now) {
    const auto targets = targets_of(data, 1);
    if (!targets) return stall("CAL_ACCEPT: " + targets.error().text);
    const auto instead = targets->empty() ? std::nullopt : std::optional(targets->front());
    if (!points_ || !points_->accept(now, instead)) return stall("CAL_ACCEPT and no point waits");
    tell_points(now);
    return Done{};
}

Status GazeFirmware::abort_points(HostTime now) {
    if (!points_) return stall("CAL_ABORT and nothing goes on");
    points_->abort();
    tell_points(now);
    return Done{};
}

/// To 0 points: what is measured is sent.
void GazeFirmware::forget_calibration() {
    tracker_.calibrate(std::nullopt);
    status_.calibration_id = 0;
    status_.calibration_points = 0;
    status_.calibration_quality = 255;
}

void GazeFirmware::follow_points(const Queued& queued) {
    if (!points_) return;
    PointProcedure::Sight sight = queued.raw;
    if (sight.gaze_deg && points_->kind() == PointProcedure::Kind::validate) {
        sight.gaze_deg = {sent_deg(queued.frame.left), sent_deg(queued.frame.right)};
    }
    points_->take(sight);
    tell_points(queued.at);
}

/// Whatever there is to say goes out; what has come to its end takes effect.
void GazeFirmware::tell_points(HostTime now) {
    const auto frames = points_->take_frames();
    for (const gaze::CalibrationFrame& frame : frames) told_.push_back({now, frame});
    status_.last_error = static_cast<std::uint8_t>(points_->last_reason());
    if (!points_->over()) return;
    if (points_->maps()) {
        tracker_.calibrate(points_->maps());
        status_.calibration_id = ++calibrations_;
        status_.calibration_points = frames.back().points;
        status_.calibration_quality = points_->quality();
    }
    points_.reset();
    status_.state = DeviceState::streaming;
}

gaze::CalibrationBlob GazeFirmware::calibration() const {
    gaze::CalibrationBlob blob{.id = status_.calibration_id};
    if (status_.calibration_id == 0) return blob;
    blob.data = {static_cast<std::byte>(status_.calibration_points),
                 static_cast<std::byte>(status_.calibration_quality), std::byte{0}, std::byte{0}};
    for (const CalibrationMap& map : tracker_.maps().value_or(TrackerModel::Maps{})) {
        const auto bytes = map.encode();
        blob.data.insert(blob.data.end(), bytes.begin(), bytes.end());
    }
    return blob;
}

Status GazeFirmware::set_calibration(Bytes data) {
    if (points_) return stall("CAL_SET while calibrating");
    const auto blob = gaze::CalibrationBlob::decode(data);
    if (!blob) return stall("CAL_SET: " + blob.error().text);
    if (blob->data.empty()) {
        forget_calibration();
        return Done{};
    }
    constexpr std::size_t kMap = CalibrationMap::kBytes;
    if (blob->id == 0 || blob->data.size() != kHeadBytes + 2 * kMap) {
        return stall("CAL_SET: not a calibration of this tracker");
    }
    const Bytes maps = Bytes(blob->data).subspan(kHeadBytes);
    const auto left = CalibrationMap::decode(maps.first<kMap>());
    const auto right = CalibrationMap::decode(maps.last<kMap>());
    if (!left || !right) return stall("CAL_SET: holds numbers that are not finite");
    tracker_.calibrate(TrackerModel::Maps{*left, *right});
    status_.calibration_id = blob->id;
    status_.calibration_points = read_u8(blob->data, 0);
    status_.calibration_quality = read_u8(blob->data, 1);
    calibrations_ = std::max(calibrations_, blob->id);
    return Done{};
}

}  // namespace foverig
