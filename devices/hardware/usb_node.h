#pragma once
// What finding a USB device and driving one share.
#include <string>

#include "devices/hardware/found_device.h"

struct libusb_context;
struct libusb_device;
struct libusb_device_handle;

namespace foverig::hardware {

/// /dev/bus/usb/BBB/DDD.
std::string node_of(libusb_device* device);
/// Null where the node is not in the context's list, or cannot be opened. The caller closes it.
libusb_device_handle* open_node(libusb_context* context, const std::string& path);

/// Why an interface could not be claimed.
Error claim_problem(const std::string& path, int libusb_code);
/// Why a vendor request failed; `outcome` is a libusb error, or too short a length.
Error request_problem(const std::string& path, int request, int outcome);

}  // namespace foverig::hardware
