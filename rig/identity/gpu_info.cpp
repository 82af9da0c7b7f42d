#include "rig/identity/gpu_info.h"

#include <dlfcn.h>

#include <fstream>
#include <memory>
#include <sstream>

namespace foverig {
namespace {

struct Close {
    void operator()(void* library) const { dlclose(library); }
};
using Library = std::unique_ptr<void, Close>;

/// The calls of the driver's library that we need, by the types of cuda.h: CUresult and CUdevice
/// are ints, and 0 is success.
class Driver {
  public:
    Driver() : library_(dlopen("libcuda.so.1", RTLD_NOW | RTLD_LOCAL)) {}

    bool there() const { return library_ != nullptr; }

    template <class... Args>
    bool call(const char* name, Args... args) const {
        const auto function = reinterpret_cast<int (*)(Args...)>(dlsym(library_.get(), name));
        return function != nullptr && function(args...) == 0;
    }

  private:
    Library library_;
};

/// The version in "NVRM version: NVIDIA UNIX x86_64 Kernel Module  580.159.03  ...": the first word
/// that starts with a digit and has a point.
std::optional<std::string> kernel_driver() {
    std::ifstream stream("/proc/driver/nvidia/version");
    std::string line;
    if (!std::getline(stream, line)) return std::nullopt;
    std::istringstream words(line);
    for (std::string word; words >> word;)
        if (word[0] >= '0' && word[0] <= '9' && word.find('.') != std::string::npos) return word;
    return "of unknown version";
}

std::optional<GpuInfo> gpu(const Driver& driver, int ordinal) {
    // CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MAJOR and _MINOR of cuda.h.
    constexpr int kMajor = 75;
    constexpr int kMinor = 76;
    int device = 0;
    char name[256] = {};
    GpuInfo info;
    if (!driver.call("cuDeviceGet", &device, ordinal) ||
        !driver.call("cuDeviceGetName", &name[0], static_cast<int>(sizeof name) - 1, device) ||
        !driver.call("cuDeviceGetAttribute", &info.major, kMajor, device) ||
        !driver.call("cuDeviceGetAttribute", &info.minor, kMinor, device))
        return std::nullopt;
    info.name = name;
    return info;
}

}  // namespace

GpuFindings find_gpus() {
    GpuFindings found;
    found.driver = kernel_driver();
    const Driver driver;
    if (!driver.there()) {
        found.why_none = found.driver ? "the driver's library libcuda.so.1 is not installed"
                                      : "no NVIDIA driver is loaded";
        return found;
    }
    int count = 0;
    int version = 0;
    if (!driver.call("cuInit", 0U) || !driver.call("cuDeviceGetCount", &count)) {
        found.why_none = "libcuda.so.1 is there and finds no GPU";
        return found;
    }
    if (driver.call("cuDriverGetVersion", &version))
        found.cuda = std::to_string(version / 1000) + "." + std::to_string(version % 1000 / 10);
    for (int i = 0; i < count; ++i)
        if (const auto info = gpu(driver, i)) found.gpus.push_back(*info);
    if (found.gpus.empty()) found.why_none = "the driver lists no GPU";
    return found;
}

std::string gpu_text(const GpuFindings& found) {
    if (found.gpus.empty())
        return "none that CUDA can use: " + found.why_none +
               (found.driver ? " (driver " + *found.driver + ")" : "");
    std::string text;
    for (const GpuInfo& info : found.gpus)
        text +=
            info.name + ", sm_" + std::to_string(info.major) + std::to_string(info.minor) + "; ";
    text += "driver " + found.driver.value_or("of unknown version");
    if (found.cuda) text += " for CUDA " + *found.cuda;
    return text;
}

}  // namespace foverig
