#pragma once
#include <string>
#include <vector>

#include "devices/hardware/found_device.h"

namespace foverig {

struct DoctorRow {
    const char* name;
    std::string text;
};

/// Headsets, one sentence each: why it cannot be opened, or where it is and what it says of itself.
std::vector<std::string> headset_texts(const std::vector<hardware::FoundDevice>& found);

/// What is plugged in, whether this user may open it, and what to do where not.
std::vector<DoctorRow> examine_devices();

}  // namespace foverig
