#include "rig/session/see_through_camera.h"

#include "devices/hardware/open_devices.h"
#include "rig/failure.h"
#include "rig/session/see_through_lens.h"
#include "simulators/camera/room_camera.h"

namespace foverig {

std::unique_ptr<Transport> open_see_through_camera(const SeeThroughSettings& asked, Clock& clock,
                                                   std::function<dquat(HostTime)> true_head) {
    if (asked.camera.empty()) return nullptr;
    if (asked.camera == "sim") {
        return std::make_unique<RoomCamera>(
            clock,
            [head = std::move(true_head)](HostTime t) {
                return RigidPose{head(t), dvec3(0.0)};
            },
            lens_of(asked, RoomCamera::kWidth_px, RoomCamera::kHeight_px));
    }
    auto opened =
        hardware::open_video_camera(clock, asked.camera,
                                    {.width_px = static_cast<std::uint32_t>(asked.width_px),
                                     .height_px = static_cast<std::uint32_t>(asked.height_px),
                                     .rate_hz = static_cast<std::uint32_t>(asked.rate_hz)});
    if (!opened)
        throw DeviceError("see_through.camera = " + asked.camera + ": " + opened.error().text +
                          " (foverig devices lists cameras)");
    return std::move(opened).value();
}

}  // namespace foverig
