#pragma once
#include <cuda_runtime_api.h>

#include <source_location>
#include <string>

#include "renderer/backends/cuda/cuda_error.h"

namespace foverig::cuda {

/// Throws CudaError that names the call, the place and CUDA's reason.
inline void check(cudaError_t error, const char* what,
                  std::source_location where = std::source_location::current()) {
    if (error == cudaSuccess) return;
    throw CudaError(std::string(where.file_name()) + ":" + std::to_string(where.line()) + ": " +
                    what + ": " + cudaGetErrorString(error) + " (" + cudaGetErrorName(error) + ")");
}

}  // namespace foverig::cuda
