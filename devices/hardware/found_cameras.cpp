#include "devices/hardware/found_cameras.h"

#include <fmt/format.h>
#include <linux/videodev2.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <filesystem>

#include "devices/hardware/first_line.h"
#include "devices/hardware/holders.h"
#include "devices/hardware/usb_bus.h"

namespace foverig::hardware {
namespace {

namespace fs = std::filesystem;

double number_of(const std::string& text) {
    double value = 0;
    (void)std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

/// A program that streams holds the device: only then may nobody else ask for buffers.
std::optional<Error> busy_problem(const std::string& path, VideoCalls& calls) {
    const int file = calls.open(path.c_str());
    if (file < 0) return std::nullopt;
    v4l2_requestbuffers none{};
    none.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    none.memory = V4L2_MEMORY_MMAP;
    const bool streams = calls.ioctl(file, VIDIOC_REQBUFS, &none) < 0 && errno == EBUSY;
    (void)calls.close(file);
    if (!streams) return std::nullopt;
    return busy(path);
}

}  // namespace

std::vector<FoundCamera> find_cameras(const std::string& sysfs, const std::string& dev,
                                      const std::shared_ptr<VideoCalls>& calls) {
    std::vector<FoundCamera> found;
    std::error_code error;
    std::vector<fs::path> nodes;
    for (const auto& entry : fs::directory_iterator(sysfs, error)) nodes.push_back(entry.path());
    std::sort(nodes.begin(), nodes.end());
    for (const fs::path& node : nodes) {
        if (!node.filename().string().starts_with("video")) continue;
        if (first_line_of(node / "index") != "0") continue;  // 1: the camera's metadata
        const fs::path usb = fs::canonical(node / "device", error).parent_path();
        const auto id =
            usb_id_of(first_line_of(usb / "idVendor") + ":" + first_line_of(usb / "idProduct"));
        if (!id) continue;
        FoundDevice device{.path = (fs::path(dev) / node.filename()).string(),
                           .serial = first_line_of(usb / "serial"),
                           .problem = {}};
        device.problem = opening_problem(device.path);
        if (!device.problem) device.problem = busy_problem(device.path, *calls);
        found.push_back({std::move(device), *id, first_line_of(node / "name"),
                         number_of(first_line_of(usb / "speed"))});
    }
    return found;
}

std::vector<FoundDevice> find_cameras_of(const UsbId& id) {
    std::vector<FoundDevice> found;
    for (FoundCamera& camera : find_cameras()) {
        if (camera.id == id) found.push_back(std::move(camera.device));
    }
    for (FoundDevice& device : find_without_node(id, "video4linux")) found.push_back(device);
    return found;
}

}  // namespace foverig::hardware
