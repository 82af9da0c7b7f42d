#pragma once
// Cameras that are plugged in, by what sysfs says of their USB devices.
#include "devices/hardware/found_device.h"
#include "devices/hardware/video_calls.h"

namespace foverig::hardware {

struct FoundCamera {
    FoundDevice device;
    UsbId id;
    std::string name;       ///< as the driver calls it
    double usb_mbit_s = 0;  ///< of its port; 0: unknown
};

/// The capture nodes of USB cameras; others (a camera's metadata) are left out. A node that another
/// program streams from is busy.
std::vector<FoundCamera> find_cameras(const std::string& sysfs = "/sys/class/video4linux",
                                      const std::string& dev = "/dev",
                                      const std::shared_ptr<VideoCalls>& calls = kernel_video());
/// Those of one kind, and those that are on the bus with no node.
std::vector<FoundDevice> find_cameras_of(const UsbId& id);

}  // namespace foverig::hardware
