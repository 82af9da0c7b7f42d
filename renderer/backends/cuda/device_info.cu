#include "renderer/backends/cuda/device_info.h"

#include "renderer/backends/cuda/check.cuh"

namespace foverig::cuda {
namespace {

__global__ void nothing() {}

std::string version_text(int version) {
    return std::to_string(version / 1000) + "." + std::to_string(version % 1000 / 10);
}

int attribute(cudaDeviceAttr which, int device) {
    int value = 0;
    check(cudaDeviceGetAttribute(&value, which, device), "cudaDeviceGetAttribute");
    return value;
}

/// Without a driver the runtime calls the driver too old, which sends people the wrong way.
std::string why_none(cudaError_t error) {
    int driver = 0;
    if (cudaDriverGetVersion(&driver) == cudaSuccess && driver == 0)
        return "no NVIDIA driver is loaded";
    return error != cudaSuccess ? cudaGetErrorString(error) : "no device is there";
}

void require(int device) {
    int count = 0;
    const cudaError_t error = cudaGetDeviceCount(&count);
    if (error != cudaSuccess || count == 0)
        throw NoGpuError("no GPU that CUDA can use: " + why_none(error) +
                         "; run this where nvidia-smi lists a GPU");
    if (device >= count)
        throw NoGpuError("GPU " + std::to_string(device) + " is not there: this machine has " +
                         std::to_string(count) + ", counted from 0");
    check(cudaSetDevice(device), "cudaSetDevice");
}

}  // namespace

int device_count() {
    int count = 0;
    return cudaGetDeviceCount(&count) == cudaSuccess ? count : 0;
}

DeviceInfo device_info(int device) {
    require(device);
    cudaDeviceProp properties{};
    check(cudaGetDeviceProperties(&properties, device), "cudaGetDeviceProperties");
    cudaFuncAttributes code{};
    if (const cudaError_t error = cudaFuncGetAttributes(&code, nothing); error != cudaSuccess)
        throw NoGpuError(std::string(properties.name) + " is sm_" +
                         std::to_string(properties.major) + std::to_string(properties.minor) +
                         " and this program has no code for it (" + cudaGetErrorString(error) +
                         "); configure with -DFOVERIG_CUDA_ARCHS=native");
    DeviceInfo info;
    info.name = properties.name;
    info.major = properties.major;
    info.minor = properties.minor;
    info.multiprocessors = properties.multiProcessorCount;
    info.memory_bytes = properties.totalGlobalMem;
    info.l2_bytes = static_cast<std::uint64_t>(properties.l2CacheSize);
    info.clock_khz = attribute(cudaDevAttrClockRate, device);
    int version = 0;
    check(cudaDriverGetVersion(&version), "cudaDriverGetVersion");
    info.driver = version_text(version);
    info.runtime = version_text(CUDART_VERSION);
    return info;
}

}  // namespace foverig::cuda
