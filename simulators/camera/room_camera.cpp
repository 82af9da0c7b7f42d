#include "simulators/camera/room_camera.h"

#include <algorithm>

#include "devices/camera/frame.h"

namespace foverig {
namespace {

constexpr Nanoseconds kInterval{33'333'333};
constexpr std::size_t kRowBytes = 2 * RoomCamera::kWidth_px;

Error no_controls() {
    return {ErrorCode::unsupported, "the simulated room camera has no controls"};
}

}  // namespace

RoomCamera::RoomCamera(Clock& clock, Pose world_from_camera, const camera::AnyLens& lens)
    : clock_(clock),
      world_from_camera_(std::move(world_from_camera)),
      view_(kWidth_px, kHeight_px, lens),
      start_(clock.now()) {}

HostTime RoomCamera::arrival() const {
    return start_ + frames_ * kInterval + kToStamp + kToArrival;
}

NextPacket RoomCamera::next(HostTime deadline) {
    while (clock_.now() < arrival()) {
        if (deadline < arrival()) {
            clock_.sleep_until(deadline);
            return Timeout{};
        }
        clock_.sleep_until(arrival());
    }
    if (deadline < arrival()) return Timeout{};
    const HostTime came = arrival();
    std::vector<std::byte> image(kRowBytes * kHeight_px);
    view_.render(world_from_camera_(came - kToArrival - kToStamp), image);
    const camera::FrameHeader header{
        .format = camera::kYuyv,
        .width_px = kWidth_px,
        .height_px = kHeight_px,
        .stride_bytes = kRowBytes,
        .sequence = frames_++,
        .age_us = static_cast<std::uint32_t>(
            std::chrono::duration_cast<std::chrono::microseconds>(kToArrival).count())};
    return Packet{came, camera::encode_frame(header, image)};
}

Status RoomCamera::control_set(std::uint8_t, std::uint16_t, std::span<const std::byte>) {
    return no_controls();
}

Result<std::vector<std::byte>> RoomCamera::control_get(std::uint8_t, std::uint16_t, std::size_t) {
    return no_controls();
}

}  // namespace foverig
