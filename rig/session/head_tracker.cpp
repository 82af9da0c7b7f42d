#include "rig/session/head_tracker.h"

#include "rig/session/device_rate.h"
#include "rig/session/open_device.h"

namespace foverig {
namespace {

std::unique_ptr<camera::HeadCamera> open_camera(Transport* camera, Transport& headset) {
    if (camera == nullptr) return nullptr;
    return opened("camera",
                  camera::HeadCamera::open(*camera, opened("dk2", dk2::read_leds(headset))));
}

/// Offsets that the headset has by temperature leave a residue of 0.01 deg/s/C (DEVICES.md 6.2).
HeadFusionConfig knowing(HeadFusionConfig config, const dk2::FactoryCalibration& calibration) {
    if (calibration.gyro_offsets.by_temperature()) config.bias.slope_sigma_rad_s_c = 1.75e-4;
    return config;
}

}  // namespace

HeadTracker::HeadTracker(Transport& transport, HostTime now, const HeadFusionConfig& config,
                         std::function<void(const ImuSample&)> on_sample, const CameraFeed& camera)
    : camera_(open_camera(camera.transport, transport)),
      source_(opened("dk2", dk2::Dk2ImuSource::open(transport, now,
                                                    {.light_leds = camera.transport != nullptr}))),
      fusion_(TrackedHeadConfig{.inertial = knowing(config, source_.calibration())}),
      on_sample_(std::move(on_sample)),
      on_fix_(camera.on_fix) {}

void HeadTracker::read_until(HostTime deadline) {
    while (true) {
        const auto next = source_.next(deadline);
        const auto* sample = std::get_if<ImuSample>(&next);
        if (sample == nullptr) break;
        if (on_sample_) on_sample_(*sample);
        fusion_.add(*sample);
        if (!first_) first_ = sample->host_time;
        newest_ = {sample->host_time, sample->arrival};
    }
    if (camera_) read_camera(deadline);
}

void HeadTracker::read_camera(HostTime deadline) {
    camera_->add(source_.take_exposures());
    while (true) {
        const auto next =
            camera_->next(deadline, [this](Dk2Time taken) { return fusion_.expected(taken); });
        const auto* fix = std::get_if<PoseFix>(&next);
        if (fix == nullptr) return;
        if (on_fix_) on_fix_(*fix);
        fusion_.add(*fix);
        if (!first_fix_) first_fix_ = fix->taken;
        newest_fix_ = {fix->taken, fix->arrival};
    }
}

const Error* HeadTracker::camera_as_it_is() const {
    if (!camera_) return nullptr;
    const std::optional<Error>& problem = camera_->source().as_it_is();
    return problem ? &*problem : nullptr;
}

std::optional<DeviceRecord> HeadTracker::camera_record() const {
    if (!camera_) return std::nullopt;
    SourceCounts counts = camera_->source().counts();
    const std::uint64_t crowded = camera_->counts().tracker.crowded;
    counts.samples -= crowded;
    counts.rejected += crowded;
    return DeviceRecord{
        .name = "camera",
        .counts = counts,
        .rate_hz = sample_rate_hz(camera_->counts().tracker.poses, first_fix_, newest_fix_),
        .troubles = by_key(CameraTroubles{.frames_of_no_known_flash = camera_->counts().unpaired,
                                          .poses_too_old = fusion_.counts().too_old})};
}

DeviceRecord HeadTracker::record() const {
    return {
        .name = "dk2",
        .counts = source_.counts(),
        .rate_hz = sample_rate_hz(source_.counts().samples, first_, newest_),
        .troubles = by_key(HeadsetTroubles{.control_failures = source_.failed_requests().refused,
                                           .requests_not_sent = source_.failed_requests().not_sent,
                                           .format_switches = source_.format_switches()})};
}

}  // namespace foverig
