#pragma once
// The two topics of a recorded device: its packets as they came, and its control transfers.
#include "devices/recording/recorder.h"

namespace foverig {

/// Where a packet holds the device's own time, for people who read a recording without us.
struct RecordedDevice {
    std::string name;             ///< "dk2": topics /dk2/raw and /dk2/control
    std::string packet_encoding;  ///< "x-hid", "x-sgz1", ...
    std::string device_time;      ///< "u32 LE at byte 8, us, wraps"
    std::string origin{};         ///< "simulated" or "hardware"; empty: nobody knows
};

/// In the metadata of its raw topic: what the device was. Absent: nobody knew.
inline constexpr const char* kDeviceOrigin = "origin";

inline std::string raw_topic(const std::string& device) {
    return "/" + device + "/raw";
}
inline std::string control_topic(const std::string& device) {
    return "/" + device + "/control";
}

}  // namespace foverig
