#pragma once
// Devices that are on the USB bus, but of which the kernel makes no node that a driver of ours
// could open: to say so, where looking for nodes alone would find nothing.
#include "devices/hardware/found_device.h"

namespace foverig::hardware {

/// Those of `id` without a node of `kind` ("hidraw", "video4linux"), each with its problem: busy
/// where a program took it from the kernel's driver, else io. `sysfs` has a folder a device.
std::vector<FoundDevice> find_without_node(const UsbId& id, const std::string& kind,
                                           const std::string& sysfs = "/sys/bus/usb/devices");

}  // namespace foverig::hardware
