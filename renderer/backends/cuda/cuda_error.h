#pragma once
#include <stdexcept>

namespace foverig::cuda {

/// A call of the CUDA runtime failed: which, where and why.
struct CudaError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// There is no GPU that this program can use: no driver, no device, or none that it was built for.
struct NoGpuError : CudaError {
    using CudaError::CudaError;
};

}  // namespace foverig::cuda
