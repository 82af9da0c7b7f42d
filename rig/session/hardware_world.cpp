#include "rig/session/hardware_world.h"

#include "devices/hardware/open_devices.h"
#include "rig/failure.h"

namespace foverig {
namespace {

/// Null where a simulated device stands in.
template <class Open>
std::unique_ptr<hardware::LiveTransport> open_or_null(const std::string& choice, Open open) {
    if (choice == "sim") return nullptr;
    Result<std::unique_ptr<hardware::LiveTransport>> opened = open();
    if (opened) return std::move(opened).value();
    // What is there and cannot be opened is no reason to simulate it.
    if (choice == "auto" && opened.error().code == ErrorCode::not_found) return nullptr;
    throw DeviceError("devices = hardware: " + opened.error().text);
}

}  // namespace

HardwareWorld::HardwareWorld(const Scenario& scenario, Clock& clock,
                             const motion::EyeMotion* pointed_eyes)
    : stand_ins_(scenario, clock, pointed_eyes),
      simulated_see_through_(scenario.see_through.camera == "sim"),
      headset_(open_or_null(
          scenario.hardware.head,
          [&] { return hardware::open_headset(clock, scenario.hardware.head_serial); })),
      gaze_tracker_(open_or_null(scenario.hardware.gaze, [&] {
          const auto id = hardware::usb_id_of(scenario.hardware.gaze_usb_id);
          return hardware::open_gaze_tracker(clock, id.value_or(hardware::kGazeTracker),
                                             scenario.hardware.gaze_serial);
      })) {
    if (!scenario.tracking.camera) return;
    camera_ = open_or_null(scenario.hardware.camera, [&] {
        return hardware::open_tracker_camera(clock, scenario.hardware.camera_serial);
    });
}

/// A simulated camera sees a simulated headset only.
Transport* HardwareWorld::tracker_camera() {
    if (camera_) return camera_.get();
    return headset_ ? nullptr : stand_ins_.tracker_camera();
}

Transport* HardwareWorld::see_through_camera() {
    if (headset_ && simulated_see_through_)
        throw UsageError(
            "see_through.camera = sim: a simulated camera sits on a simulated head; name a camera "
            "of the desk (foverig devices)");
    return stand_ins_.see_through_camera();
}

Transport& HardwareWorld::headset() {
    return headset_ ? *headset_ : stand_ins_.headset();
}

Transport& HardwareWorld::gaze_tracker() {
    return gaze_tracker_ ? *gaze_tracker_ : stand_ins_.gaze_tracker();
}

double HardwareWorld::initial_yaw_rad() const {
    return headset_ ? 0.0 : stand_ins_.initial_yaw_rad();
}

std::optional<dquat> HardwareWorld::true_head(HostTime time) const {
    return headset_ ? std::nullopt : stand_ins_.true_head(time);
}

std::optional<std::array<dvec3, 2>> HardwareWorld::true_gaze(HostTime time) const {
    return gaze_tracker_ ? std::nullopt : stand_ins_.true_gaze(time);
}

Origin HardwareWorld::origin(std::string_view device) const {
    if (device == "see_through") return stand_ins_.origin(device);
    const auto& real = device == "dk2" ? headset_ : device == "gaze" ? gaze_tracker_ : camera_;
    return real ? Origin::hardware : Origin::simulated;
}

}  // namespace foverig
