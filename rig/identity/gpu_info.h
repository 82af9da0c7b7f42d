#pragma once
#include <optional>
#include <string>
#include <vector>

namespace foverig {

struct GpuInfo {
    std::string name;
    int major = 0;  ///< compute capability: the architecture is sm_<major><minor>
    int minor = 0;
};

/// What the NVIDIA driver of this machine says, asked at run time: nothing of CUDA is linked.
struct GpuFindings {
    std::optional<std::string> driver;  ///< version; absent: no driver is loaded
    std::optional<std::string> cuda;    ///< newest CUDA that the driver knows
    std::vector<GpuInfo> gpus;
    std::string why_none;  ///< a clause, where `gpus` is empty
};

GpuFindings find_gpus();

/// One line for a person.
std::string gpu_text(const GpuFindings& found);

}  // namespace foverig
