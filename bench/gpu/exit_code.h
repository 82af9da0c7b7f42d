#pragma once

namespace foverig::gpu {

/// How foverig_gpu ends: those of `foverig` (rig/failure.h), and one of its own.
enum class GpuExit {
    good = 0,
    parity_failed = 1,  ///< CUDA and host-bvh disagree beyond a tolerance
    usage = 2,
    input = 3,   ///< a scene file
    device = 4,  ///< a CUDA call failed
    internal = 5,
    no_gpu = 6,  ///< no driver, no device, or none that this program has code for
};

}  // namespace foverig::gpu
