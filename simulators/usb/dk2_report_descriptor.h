#pragma once
#include <cstddef>
#include <vector>

namespace foverig::usb {

/// The DK2's HID report descriptor, 771 bytes, as its firmware has it (RiftDK2, usb_desc.c): report
/// 13 is declared with 14 bytes although it has 16.
std::vector<std::byte> dk2_report_descriptor();

}  // namespace foverig::usb
