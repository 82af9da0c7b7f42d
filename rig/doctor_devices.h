#pragma once
#include <string>
#include <vector>

namespace foverig {

struct DoctorRow {
    const char* name;
    std::string text;
};

/// What is plugged in, whether this user may open it, and what to do where not.
std::vector<DoctorRow> examine_devices();

}  // namespace foverig
