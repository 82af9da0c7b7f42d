#include <fmt/format.h>

#include "devices/hardware/found_cameras.h"
#include "renderer/scene/library.h"
#include "rig/commands.h"
#include "rig/doctor_devices.h"
#include "rig/scenario/scenario.h"
#include "simulators/faults/faults.h"
#include "simulators/motion/catalog.h"

namespace foverig {
namespace {

void print_row(std::string_view name, std::string_view text) {
    fmt::print("  {:<24} {}\n", name, text);
}

void print_found(const char* name, const std::vector<hardware::FoundDevice>& found) {
    if (found.empty()) print_row(name, "none plugged in");
    for (const hardware::FoundDevice& device : found) {
        print_row(name, device.problem ? device.problem->text
                                       : fmt::format("serial {}, {}", device.serial, device.path));
    }
}

void print_video_cameras() {
    std::size_t found = 0;
    for (const hardware::FoundCamera& camera : hardware::find_cameras()) {
        if (camera.id == hardware::kDk2Camera) continue;
        ++found;
        print_row("video", camera.device.problem
                               ? camera.device.problem->text
                               : fmt::format("{}, USB {}, {}", camera.name,
                                             hardware::text_of(camera.id), camera.device.path));
    }
    if (found == 0) print_row("video", "none plugged in (any USB camera, for see-through)");
}

}  // namespace

ExitCode scenes_command() {
    fmt::print("Built-in scenes (foverig run --scene NAME):\n");
    for (const BuiltinInfo& scene : builtin_scenes()) print_row(scene.name, scene.summary);
    fmt::print(
        "Any OBJ, glTF, GLB or PLY file is a scene too (foverig run --scene FILE; "
        "--set scene_scale=0.001 for millimetres).\n");
    return ExitCode::good;
}

ExitCode devices_command() {
    fmt::print("Devices on the desk (--devices hardware --clock wall):\n");
    const auto headsets = headset_texts(hardware::find_headsets());
    if (headsets.empty()) print_row("dk2", "none plugged in");
    for (const std::string& text : headsets) print_row("dk2", text);
    print_found("gaze", hardware::find_gaze_trackers(hardware::kGazeTracker));
    print_found("camera", hardware::find_cameras_of(hardware::kDk2Camera));
    print_video_cameras();
    fmt::print("\nSimulated devices (--devices sim); they speak the bytes of the real ones:\n");
    print_row("dk2", "Oculus Rift DK2: inertial sensor at 1 kHz, 75 Hz panel with pixel read-back");
    print_row("gaze", "binocular gaze tracker, 60 Hz");
    print_row("camera", "the DK2's tracker camera: 752 x 480 at 60 Hz, LEDs that blink, its lens");
    print_row("room", "a camera on the headset that sees a room: 640 x 480 at 30 Hz, YUYV");
    print_row("virtual", "the DK2's panel: VSync, rolling scan-out, persistence");
    fmt::print("\nHead motions (motion.head):\n");
    for (const auto& model : motion::head_motions()) print_row(model.name, model.meaning);
    fmt::print("\nEye motions (motion.gaze):\n");
    for (const auto& model : motion::eye_motions()) print_row(model.name, model.meaning);
    print_row(kMouseGaze,
              "the eyes follow the cursor of a window (--display window), without noise");
    fmt::print("\nFaults (faults.<device>.<kind>), each off until it is named:\n");
    for (const FaultInfo& fault : known_faults()) {
        print_row(fmt::format("{}.{}", fault.device, fault.kind),
                  fmt::format("{} ({}; typical {})", fault.meaning, fault.unit, fault.typical));
    }
    fmt::print(
        "\nA recording of devices is one too (--devices replay:FILE, foverig replay FILE).\n");
    return ExitCode::good;
}

}  // namespace foverig
