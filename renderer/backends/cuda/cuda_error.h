#pragma once
#include "renderer/backend_error.h"

namespace foverig::cuda {

/// A call of the CUDA runtime failed: which, where and why.
struct CudaError : BackendError {
    using BackendError::BackendError;
};

/// There is no GPU that this program can use: no driver, no device, or none that it was built for.
struct NoGpuError : CudaError {
    using CudaError::CudaError;
};

}  // namespace foverig::cuda
