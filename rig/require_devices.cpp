#include "rig/require_devices.h"

#include "devices/hardware/open_devices.h"
#include "rig/failure.h"

namespace foverig {
namespace {

/// `choice`: required, auto or sim; `key` is where the scenario says so.
void require(const std::string& choice, const std::string& key,
             const Result<hardware::FoundDevice>& chosen) {
    const bool missing = !chosen && chosen.error().code == ErrorCode::not_found;
    if (missing && choice == "auto") return;
    if (missing) {
        throw DeviceError("devices = hardware: " + chosen.error().text +
                          ", or simulate it (--set " + key + "=sim)");
    }
    if (!chosen) throw DeviceError("devices = hardware: " + chosen.error().text);
    if (chosen->problem) throw DeviceError("devices = hardware: " + chosen->problem->text);
}

void require_hardware(const Scenario& scenario) {
    const HardwareSettings& asked = scenario.hardware;
    if (asked.head != "sim") {
        require(asked.head, "hardware.head", hardware::choose_headset(asked.head_serial));
    }
    if (asked.gaze != "sim") {
        const auto id = hardware::usb_id_of(asked.gaze_usb_id).value_or(hardware::kGazeTracker);
        require(asked.gaze, "hardware.gaze", hardware::choose_gaze_tracker(id, asked.gaze_serial));
    }
    if (scenario.tracking.camera && asked.camera != "sim") {
        require(asked.camera, "hardware.camera",
                hardware::choose_tracker_camera(asked.camera_serial));
    }
    if (scenario.clock != "wall") {
        throw UsageError("devices = hardware and clock = " + scenario.clock +
                         ": devices on a desk run in real time; add --clock wall");
    }
}

}  // namespace

void require_devices(const Scenario& scenario) {
    if (scenario.devices == "hardware") require_hardware(scenario);
}

void require_see_through(const Scenario& scenario) {
    const SeeThroughSettings& asked = scenario.see_through;
    const bool on_desk =
        !asked.camera.empty() && asked.camera != "sim" && replayed_file(scenario).empty();
    if (!on_desk || scenario.clock == "wall") return;
    throw UsageError("see_through.camera = " + asked.camera + " and clock = " + scenario.clock +
                     ": a camera on a desk runs in real time; add --clock wall");
}

}  // namespace foverig
