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

/// Throws NoGpuError with one sentence where there is no driver, no such device, or none that this
/// program has code for. The device becomes the current one.
DeviceInfo device_info(int device = 0);

/// Devices of this machine; 0 where there is no driver.
int device_count();

}  // namespace foverig::cuda
