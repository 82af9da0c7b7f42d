#include "rig/doctor_devices.h"

#include <fmt/format.h>
#include <pthread.h>
#include <sys/resource.h>

#include <filesystem>

#include "devices/hardware/found_cameras.h"
#include "devices/hardware/live_transport.h"

namespace foverig {
namespace {

namespace fs = std::filesystem;

std::string said_of(const std::vector<hardware::FoundDevice>& found, const std::string& absent) {
    if (found.empty()) return absent;
    std::string text;
    for (const hardware::FoundDevice& device : found) {
        if (!text.empty()) text += "; ";
        text += device.problem ? device.problem->text
                               : fmt::format("{} ready, serial {}", device.path,
                                             device.serial.empty() ? "unknown" : device.serial);
    }
    return text;
}

constexpr double kFrameRate_hz = 60.0, kFrameBits = 752.0 * 480.0 * 8.0;

/// Its frames need a high-speed port (DEVICES.md 1.8).
std::string tracker_cameras() {
    std::vector<hardware::FoundDevice> devices;
    std::string ports;
    for (const hardware::FoundCamera& camera : hardware::find_cameras()) {
        if (camera.id != hardware::kDk2Camera) continue;
        devices.push_back(camera.device);
        if (camera.usb_mbit_s == 0) continue;
        ports += fmt::format("; its frames take {:.0f} of the port's {:.0f} Mbit/s{}",
                             kFrameRate_hz * kFrameBits * 1e-6, camera.usb_mbit_s,
                             camera.usb_mbit_s < 480 ? ": too slow a port" : "");
    }
    return said_of(devices, fmt::format("none seen (DK2's camera, USB {})",
                                        hardware::text_of(hardware::kDk2Camera))) +
           ports;
}

std::string kernel_interfaces() {
    std::error_code error;
    const bool hidraw = fs::exists("/sys/class/hidraw", error);
    const bool usbfs = fs::exists("/dev/bus/usb", error);
    const bool video = fs::exists("/sys/class/video4linux", error);
    return fmt::format("hidraw {}, usbfs {}, video4linux {}",
                       hidraw ? "there" : "not in this kernel (no headset can be read)",
                       usbfs ? "there" : "not mounted (no gaze tracker can be read)",
                       video ? "there" : "not there (no camera was ever plugged in)");
}

std::string realtime() {
    rlimit limit{};
    sched_param priority{};
    priority.sched_priority = hardware::kReaderPriority;
    int policy = 0;
    sched_param before{};
    (void)pthread_getschedparam(pthread_self(), &policy, &before);
    if (pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority) == 0) {
        (void)pthread_setschedparam(pthread_self(), policy, &before);
        return "allowed: the threads that read devices use it";
    }
    (void)getrlimit(RLIMIT_RTPRIO, &limit);
    return fmt::format(
        "not allowed (limit {}): reports may be stamped late under load; add \"{} - rtprio 10\" to "
        "/etc/security/limits.d/foverig.conf and log in again",
        limit.rlim_cur, "@users");
}

}  // namespace

std::vector<DoctorRow> examine_devices() {
    const std::string headset = hardware::text_of(hardware::kDk2);
    const std::string tracker = hardware::text_of(hardware::kGazeTracker);
    return {{"kernel", kernel_interfaces()},
            {"headset", said_of(hardware::find_headsets(),
                                fmt::format("none seen (Rift DK2, USB {})", headset))},
            {"gaze tracker", said_of(hardware::find_gaze_trackers(hardware::kGazeTracker),
                                     fmt::format("none seen (SGZ1, USB {})", tracker))},
            {"tracker camera", tracker_cameras()},
            {"udev rule",
             fmt::format("{}: {}", hardware::kUdevRuleFile,
                         fs::exists("/etc/udev/rules.d/70-foverig.rules")
                             ? "installed"
                             : std::string("not installed; ") + hardware::kInstallUdevRule)},
            {"real time", realtime()}};
}

}  // namespace foverig
