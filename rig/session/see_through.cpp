#include "rig/session/see_through.h"

#include "devices/hardware/open_devices.h"
#include "rig/failure.h"
#include "rig/session/device_rate.h"
#include "rig/session/see_through_lens.h"
#include "simulators/camera/room_camera.h"

namespace foverig {
namespace {

std::unique_ptr<Transport> open_room(const Scenario& scenario, World& world, Clock& clock) {
    if (!world.true_head(clock.now()))
        throw UsageError(
            "see_through.camera = sim: a simulated camera sits on a simulated head; name a camera "
            "of the desk (foverig devices)");
    const auto on_head = [&world](HostTime t) {
        return RigidPose{world.true_head(t).value_or(dquat(1, 0, 0, 0)), dvec3(0.0)};
    };
    return std::make_unique<RoomCamera>(
        clock, on_head,
        lens_of(scenario.see_through, RoomCamera::kWidth_px, RoomCamera::kHeight_px));
}

std::unique_ptr<Transport> open_camera(const Scenario& scenario, const Clock& clock) {
    const SeeThroughSettings& asked = scenario.see_through;
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

}  // namespace

std::unique_ptr<SeeThrough> SeeThrough::open(const Scenario& scenario, World& world, Clock& clock) {
    const SeeThroughSettings& asked = scenario.see_through;
    if (asked.camera.empty()) return nullptr;
    return std::unique_ptr<SeeThrough>(new SeeThrough(asked, asked.camera == "sim"
                                                                 ? open_room(scenario, world, clock)
                                                                 : open_camera(scenario, clock)));
}

SeeThrough::SeeThrough(const SeeThroughSettings& settings, std::unique_ptr<Transport> transport)
    : settings_(settings), transport_(std::move(transport)), camera_(*transport_) {}

std::optional<BehindPicture> SeeThrough::picture(HostTime now, const HeadTracker& head) {
    const bool changed = camera_.read_until(now);
    const camera::RgbImage* image = camera_.image();
    if (image == nullptr) {
        instants_.reset();
        return std::nullopt;
    }
    if (changed) {
        const HostTime exposed =
            camera_.newest()->stamp - from_seconds(1e-3 * settings_.latency_ms);
        instants_ = {exposed, camera_.newest()->arrival};
        if (!first_) {
            first_ = exposed;
            before_first_ = camera_.counts().samples - 1;
        }
        world_from_camera_ = head.predict(exposed).world_from_head;
        lens_ = lens_of(settings_, image->width_px, image->height_px);
    }
    return BehindPicture{.width_px = image->width_px,
                         .height_px = image->height_px,
                         .srgb = image->bytes,
                         .changed = changed,
                         .lens = lens_,
                         .world_from_camera = world_from_camera_};
}

DeviceRecord SeeThrough::record() const {
    const SourceCounts counts = camera_.counts();
    return {.name = "see_through",
            .counts = counts,
            .rate_hz = sample_rate_hz(counts.samples - before_first_, first_, instants_),
            .origin = settings_.camera == "sim" ? Origin::simulated : Origin::hardware};
}

}  // namespace foverig
