#pragma once
// A camera on the headset that sees a room: what a see-through camera is where there is none.
#include <functional>

#include "devices/transport.h"
#include "simulators/camera/room_view.h"

namespace foverig {

/// 640x480 YUYV at 30 Hz (camera/frame.h), whether or not anybody reads them; drawn when they are
/// read. It has no controls.
class RoomCamera final : public Transport {
  public:
    static constexpr int kWidth_px = 640, kHeight_px = 480;
    /// From the middle of an exposure to the kernel's stamp, and from there until all is there: own
    /// choices, as of a webcam with a rolling shutter.
    static constexpr Nanoseconds kToStamp{10'000'000}, kToArrival{25'000'000};

    /// The pose of the camera in the room. `clock` outlives the camera.
    using Pose = std::function<RigidPose(HostTime)>;
    RoomCamera(Clock& clock, Pose world_from_camera, const camera::AnyLens& lens);

    NextPacket next(HostTime deadline) override;
    Status control_set(std::uint8_t id, std::uint16_t value,
                       std::span<const std::byte> data) override;
    Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                               std::size_t size) override;

  private:
    HostTime arrival() const;

    Clock& clock_;
    Pose world_from_camera_;
    RoomView view_;
    HostTime start_;
    std::uint32_t frames_ = 0;
};

}  // namespace foverig
