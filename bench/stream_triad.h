#pragma once
#include <cstddef>

#include "renderer/backends/cpu/cpu_backend.h"

namespace foverig::bench {

/// McCalpin's triad a = b + s c, bytes as STREAM counts them (24 an element), on the renderer's
/// threads.
struct TriadRates {
    double plain_gb_s = 0.0;
    double non_temporal_gb_s = 0.0;
};

/// Best of `repetitions` on three arrays of `bytes` each.
TriadRates stream_triad(CpuBackend& backend, std::size_t bytes, int repetitions);

}  // namespace foverig::bench
