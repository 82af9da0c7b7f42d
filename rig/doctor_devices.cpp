#include "rig/doctor_devices.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pthread.h>
#include <sys/resource.h>

#include <filesystem>

#include "devices/dk2/about.h"
#include "devices/hardware/found_cameras.h"
#include "devices/hardware/open_devices.h"

namespace foverig {
namespace {

namespace fs = std::filesystem;

std::string said_of(const hardware::FoundDevice& device) {
    if (device.problem) return device.problem->text;
    return fmt::format("{} ready, serial {}", device.path,
                       device.serial.empty() ? "unknown" : device.serial);
}

std::string said_of(const std::vector<hardware::FoundDevice>& found, const std::string& absent) {
    if (found.empty()) return absent;
    std::vector<std::string> texts;
    for (const hardware::FoundDevice& device : found) texts.push_back(said_of(device));
    return fmt::format("{}", fmt::join(texts, "; "));
}

/// Opened for a moment; nothing is set.
std::string said_of_headset(const hardware::FoundDevice& headset) {
    if (headset.problem) return headset.problem->text;
    const WallClock clock;
    const auto device = hardware::open_headset(clock, headset.serial, {.realtime = false});
    if (!device) return device.error().text;
    const auto about = dk2::read_about(**device);
    if (!about) return said_of(headset) + ", but " + about.error().text;
    return said_of(headset) + ", " + dk2::text_of(*about);
}

constexpr double kFrameRate_hz = 60.0, kFrameBits = 752.0 * 480.0 * 8.0;

/// Its frames need a high-speed port (DEVICES.md 1.8).
std::string tracker_cameras() {
    std::string ports;
    for (const hardware::FoundCamera& camera : hardware::find_cameras()) {
        if (camera.id != hardware::kDk2Camera) continue;
        if (camera.usb_mbit_s == 0) continue;
        ports += fmt::format("; its frames take {:.0f} of the port's {:.0f} Mbit/s{}",
                             kFrameRate_hz * kFrameBits * 1e-6, camera.usb_mbit_s,
                             camera.usb_mbit_s < 480 ? ": too slow a port" : "");
    }
    const auto devices = hardware::find_cameras_of(hardware::kDk2Camera);
    return said_of(devices, fmt::format("none seen (DK2's camera, USB {})",
                                        hardware::text_of(hardware::kDk2Camera))) +
           ports;
}

/// Those for see-through.
std::string video_cameras() {
    std::string text;
    for (const hardware::FoundCamera& camera : hardware::find_cameras()) {
        if (camera.id == hardware::kDk2Camera) continue;
        if (!text.empty()) text += "; ";
        text += fmt::format(
            "{} (USB {}): {}", camera.name, hardware::text_of(camera.id),
            camera.device.problem ? camera.device.problem->text : camera.device.path + " ready");
    }
    return text.empty() ? "none seen (any USB camera, for see-through)" : text;
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

std::vector<std::string> headset_texts(const std::vector<hardware::FoundDevice>& found) {
    std::vector<std::string> texts;
    for (const hardware::FoundDevice& headset : found) texts.push_back(said_of_headset(headset));
    return texts;
}

std::vector<DoctorRow> examine_devices() {
    const std::string headset = hardware::text_of(hardware::kDk2);
    const auto headsets = headset_texts(hardware::find_headsets());
    const std::string tracker = hardware::text_of(hardware::kGazeTracker);
    return {{"kernel", kernel_interfaces()},
            {"headset", headsets.empty() ? fmt::format("none seen (Rift DK2, USB {})", headset)
                                         : fmt::format("{}", fmt::join(headsets, "; "))},
            {"gaze tracker", said_of(hardware::find_gaze_trackers(hardware::kGazeTracker),
                                     fmt::format("none seen (SGZ1, USB {})", tracker))},
            {"tracker camera", tracker_cameras()},
            {"video cameras", video_cameras()},
            {"udev rule",
             fmt::format("{}: {}", hardware::kUdevRuleFile,
                         fs::exists("/etc/udev/rules.d/70-foverig.rules")
                             ? "installed"
                             : std::string("not installed; ") + hardware::kInstallUdevRule)},
            {"real time", realtime()}};
}

}  // namespace foverig
