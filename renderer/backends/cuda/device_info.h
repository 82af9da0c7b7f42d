#pragma once
#include <cstdint>
#include <string>

namespace foverig::cuda {

struct DeviceInfo {
    std::string name;
    int major = 0;  ///< compute capability: the architecture is sm_<major><minor>
    int minor = 0;
    int multiprocessors = 0;
    std::uint64_t memory_bytes = 0;
    std::uint64_t l2_bytes = 0;
    int clock_khz = 0;
    std::string driver;   ///< the newest CUDA that the driver knows, "13.0"
    std::string runtime;  ///< the CUDA that this program was built with
};

/// The current device. Throws NoGpuError with one sentence where there is no driver, no device, or
/// none that this program has code for.
DeviceInfo device_info();

}  // namespace foverig::cuda
