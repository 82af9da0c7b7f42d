#include "simulators/camera/simulated_camera.h"

#include <algorithm>

#include "devices/camera/frame.h"
#include "devices/head_geometry.h"

namespace foverig {
namespace {

// Own choices: the kernel stamps a frame at its first packet, and has it all a little after the
// sensor was read out.
constexpr Nanoseconds kFirstPacket{300'000}, kLastPacket{700'000};

Error no_camera() {
    return {ErrorCode::closed,
            "the simulated tracker camera is unplugged (faults.camera.unplug_at)"};
}

RigidPose world_from_imu(const motion::HeadState& head) {
    return {head.world_from_head, head.position_m + head.world_from_head * kImuFromEyes_m};
}

}  // namespace

RigidPose usual_camera_place() {
    constexpr double kPitch_rad = 0.12;
    // Half a turn about z makes OpenCV's axes look backwards at the head; then down a little.
    const dquat backwards(0, 0, 0, 1);
    const dquat down = glm::angleAxis(-kPitch_rad, dvec3(1, 0, 0));
    return {glm::normalize(backwards * down), dvec3(0.0, 0.10, -0.90)};
}

SimulatedCamera::SimulatedCamera(Clock& clock, const motion::HeadMotion& head,
                                 const LedLight& light, Settings settings)
    : clock_(clock),
      head_(head),
      light_(light),
      settings_(std::move(settings)),
      scene_(settings_.leds, settings_.lens, settings_.faults, settings_.seed),
      registers_(settings_.lens),
      loss_(settings_.seed, 710),
      plugged_in_(clock.now()),
      last_start_(plugged_in_),
      busy_until_(plugged_in_) {}

bool SimulatedCamera::unplugged(HostTime now) const {
    const double running_s = to_seconds(now - plugged_in_);
    const CameraFaults& f = settings_.faults;
    return f.unplug_for > 0.0 && running_s >= f.unplug_at && running_s < f.unplug_at + f.unplug_for;
}

std::optional<HostTime> SimulatedCamera::next_start() const {
    if (!registers_.synchronised()) return last_start_ + registers_.frame_time();
    const auto flash = light_.flash_after(last_start_);
    if (!flash) return std::nullopt;
    return flash->start;
}

void SimulatedCamera::advance(HostTime now) {
    for (auto start = next_start(); start && *start <= now; start = next_start()) {
        last_start_ = *start;
        const bool heeded = *start >= busy_until_ || !registers_.synchronised();
        if (!heeded || unplugged(*start)) continue;
        busy_until_ = *start + registers_.frame_time();
        // A flash may have begun before this exposure did.
        const HostTime earliest = registers_.synchronised() ? *start - Nanoseconds{1}
                                                            : *start - std::chrono::milliseconds(1);
        shoot(*start, light_.flash_after(earliest));
    }
    if (!unplugged(now)) return;
    arriving_.clear();
    registers_ = CameraRegisters(settings_.lens);
}

void SimulatedCamera::shoot(HostTime start, const std::optional<LedFlash>& flash) {
    Shot shot{.start = start, .share = 0.0};
    const HostTime end = start + registers_.exposure();
    if (flash && flash->length > Nanoseconds{0}) {
        const HostTime from = std::max(start, flash->start);
        const HostTime to = std::min(end, flash->start + flash->length);
        shot.share = std::max(0.0, to_seconds(to - from) / to_seconds(flash->length));
        shot.pattern = flash->pattern;
    }
    shot.sequence = static_cast<std::uint32_t>(shots_++);
    shot.stamp = end + kFirstPacket;
    shot.arrival = start + registers_.frame_time() + kLastPacket;
    if (loss_.uniform(shot.sequence) < settings_.faults.dropout) return;
    arriving_.push_back(shot);
}

Packet SimulatedCamera::developed(const Shot& shot) {
    const HostTime middle = shot.start + registers_.exposure() / 2;
    const double running_s = to_seconds(shot.start - plugged_in_);
    const CameraFaults& f = settings_.faults;
    const auto head = head_.at(to_seconds(middle.time_since_epoch()));
    std::vector<std::byte> image(static_cast<std::size_t>(kCameraWidth_px) * kCameraHeight_px);
    scene_.render({.camera_from_imu = settings_.world_from_camera.inverse() * world_from_imu(head),
                   .pattern = shot.pattern,
                   .share = shot.share,
                   .covered = f.occlude_for > 0.0 && running_s >= f.occlude_at &&
                              running_s < f.occlude_at + f.occlude_for,
                   .index = shot.sequence},
                  image);
    const auto age_us =
        std::chrono::duration_cast<std::chrono::microseconds>(shot.arrival - shot.stamp).count();
    camera::FrameHeader header{.sequence = shot.sequence,
                               .age_us = static_cast<std::uint32_t>(age_us)};
    if (settings_.yuyv) {
        header.format = camera::kYuyv;
        header.width_px = kCameraWidth_px / 2;
    }
    return {.arrival = shot.arrival, .bytes = camera::encode_frame(header, image)};
}

NextPacket SimulatedCamera::next(HostTime deadline) {
    while (true) {
        const HostTime now = std::min(clock_.now(), deadline);
        advance(now);
        if (unplugged(now)) return Fault{no_camera()};
        if (!arriving_.empty() && arriving_.front().arrival <= now) {
            const Shot shot = arriving_.front();
            arriving_.pop_front();
            return developed(shot);
        }
        if (now >= deadline) return Timeout{};
        HostTime event = next_start().value_or(deadline);
        if (!arriving_.empty()) event = std::min(event, arriving_.front().arrival);
        clock_.sleep_until(std::min(deadline, event));
    }
}

Status SimulatedCamera::control_set(std::uint8_t id, std::uint16_t value,
                                    std::span<const std::byte> data) {
    advance(clock_.now());
    if (unplugged(clock_.now())) return no_camera();
    if (value != camera::kExtensionUnit) {
        return Error{ErrorCode::unsupported, "the simulated camera has one extension unit: 4"};
    }
    return registers_.set(id, data);
}

Result<std::vector<std::byte>> SimulatedCamera::control_get(std::uint8_t id, std::uint16_t value,
                                                            std::size_t size) {
    if (unplugged(clock_.now())) return no_camera();
    if (value != camera::kExtensionUnit) {
        return Error{ErrorCode::unsupported, "the simulated camera has one extension unit: 4"};
    }
    return registers_.get(id, size);
}

}  // namespace foverig
