#include "rig/expose_command.h"

#include <fmt/format.h>

#include <cstdio>

#include "devices/hardware/identity.h"
#include "rig/interrupt.h"
#include "rig/session/run_clock.h"
#include "rig/session/session_recording.h"
#include "rig/session/world.h"
#include "simulators/camera/staged_camera.h"
#include "simulators/usb/camera_descriptors.h"
#include "simulators/usb/camera_function.h"
#include "simulators/usb/dk2_function.h"
#include "simulators/usb/dk2_report_descriptor.h"
#include "simulators/usb/exposed_device.h"
#include "simulators/usb/gaze_function.h"
#include "simulators/usb/uhid_face.h"
#include "simulators/usb/vhci_face.h"

namespace foverig {
namespace {

constexpr Nanoseconds kStep{50'000'000};  // between two looks at Ctrl-C

hardware::UsbId identity_of(const ExposeRequest& request) {
    if (request.device == "dk2") return hardware::kDk2;
    if (request.device == "camera") return hardware::kDk2Camera;
    return hardware::usb_id_of(request.scenario.hardware.gaze_usb_id)
        .value_or(hardware::kGazeTracker);
}

void check(const ExposeRequest& request) {
    if (request.via == "uhid" && request.device != "dk2") {
        throw UsageError(fmt::format("--via uhid {}: only a dk2 is a HID device; use --via usbip",
                                     request.device));
    }
    if (request.scenario.devices == "hardware") {
        throw UsageError(
            "expose and devices = hardware: a device on the desk is the kernel's already; use "
            "--devices sim or replay:FILE");
    }
}

usb::PlugIn plug_in(const ExposeRequest& request, Transport& model, const Clock& clock) {
    const hardware::UsbId id = identity_of(request);
    if (request.via == "uhid") {
        return [&model, id] {
            return usb::UhidFace::plug_in(model,
                                          {.vendor = id.vendor,
                                           .product = id.product,
                                           .release = usb::Dk2Function::kRelease,
                                           .name = "Oculus VR, Inc. Rift DK2",
                                           .serial = usb::dk2_serial(model),
                                           .report_descriptor = usb::dk2_report_descriptor()});
        };
    }
    if (request.device == "dk2") {
        return [&model, &clock] {
            return usb::VhciFace::plug_in(std::make_unique<usb::Dk2Function>(model),
                                          usb::Dk2Function::kReports, clock);
        };
    }
    if (request.device == "camera") {
        return [&model, &clock] {
            return usb::VhciFace::plug_in(std::make_unique<usb::CameraFunction>(model),
                                          usb::kCameraFrames, clock);
        };
    }
    return [&model, &clock, id] {
        return usb::VhciFace::plug_in(
            std::make_unique<usb::GazeFunction>(
                model, usb::DeviceIdentity{.vendor = id.vendor, .product = id.product}),
            usb::GazeFunction::kFrames, clock);
    };
}

/// The device's bytes, recorded on their way where that is asked for. A simulated camera sees the
/// LEDs of its scenario's headset, and is `staged` before that.
Transport& transport_of(const ExposeRequest& request, World& world, const Clock& clock,
                        SessionRecording* recording, std::optional<StagedCamera>& staged) {
    if (recording != nullptr) recording->begin(world.initial_yaw_rad());
    if (request.device == "dk2") {
        return recording ? recording->headset(world.headset(), clock, first_origin(world, "dk2"))
                         : world.headset();
    }
    if (request.device == "gaze") {
        return recording ? recording->gaze_tracker(world.gaze_tracker(), clock,
                                                   first_origin(world, "gaze"))
                         : world.gaze_tracker();
    }
    Transport* camera = world.tracker_camera();
    if (camera == nullptr) {
        throw UsageError("expose camera: there is no tracker camera among these devices");
    }
    if (replayed_file(request.scenario).empty()) {
        camera = &staged.emplace(*camera, world.headset(), clock);
    }
    return recording ? recording->tracker_camera(*camera, clock, first_origin(world, "camera"))
                     : *camera;
}

std::optional<SessionRecording> recording_of(const ExposeRequest& request,
                                             const Scenario& scenario) {
    if (!request.record) return std::nullopt;
    if (std::filesystem::exists(*request.record)) {
        throw UsageError(
            fmt::format("--record {}: is there already; expected the name of a new file",
                        request.record->string()));
    }
    return std::optional<SessionRecording>(std::in_place, *request.record, scenario);
}

}  // namespace

ExitCode expose_command(const ExposeRequest& request) {
    check(request);
    Scenario scenario = request.scenario;
    scenario.clock = "wall";  // a kernel's time passes by itself
    scenario.tracking.camera = request.device == "camera";
    RunClock clock(scenario.clock, Cost{});
    const auto world = make_world(scenario, clock.clock());
    std::optional<SessionRecording> recording = recording_of(request, scenario);
    std::optional<StagedCamera> staged;
    usb::LockedTransport model(
        transport_of(request, *world, clock.clock(), recording ? &*recording : nullptr, staged));
    const Interrupt interrupt;
    auto begun =
        usb::ExposedDevice::begin(model, clock.clock(), plug_in(request, model, clock.clock()));
    if (!begun) {
        recording.reset();
        if (request.record) std::filesystem::remove(*request.record);  // of nothing
        throw DeviceError(begun.error().text);
    }
    std::unique_ptr<usb::ExposedDevice> device = std::move(begun).value();
    fmt::print("{} is a device of this machine's kernel, {} through {}; Ctrl-C takes it away\n",
               request.device, hardware::text_of(identity_of(request)), request.via);
    std::fflush(stdout);

    const HostTime end =
        scenario.seconds > 0.0 ? clock.now() + from_seconds(scenario.seconds) : HostTime::max();
    while (clock.now() < end && !interrupt.requested() && !device->ended()) {
        clock.clock().sleep_until(std::min(clock.now() + kStep, end));
        if (recording) recording->check();
    }
    const auto error = device->error();
    const auto counts = device->counts();
    device.reset();
    if (recording) recording->end();
    fmt::print("{}: {} packets in {:.1f} s, plugged in {}; {} transfers not asked for in time\n",
               request.device, counts.packets, to_seconds(clock.now().time_since_epoch()),
               counts.plugged_in == 1 ? "once" : fmt::format("{} times", counts.plugged_in),
               counts.unheard);
    if (error) throw DeviceError(error->text);
    return ExitCode::good;
}

}  // namespace foverig
