#pragma once
#include <vector>

#include "renderer/backends/cuda/handles.cuh"

namespace foverig::gpu {

/// Of each repetition of `work`, by the stream's events; one more before them warms up.
template <class Work>
std::vector<double> event_times_ms(cudaStream_t stream, int repetitions, const Work& work) {
    const cuda::Event begin = cuda::make_event();
    const cuda::Event end = cuda::make_event();
    std::vector<double> times_ms;
    for (int i = -1; i < repetitions; ++i) {
        cuda::check(cudaEventRecord(begin.get(), stream), "cudaEventRecord");
        work();
        cuda::check(cudaEventRecord(end.get(), stream), "cudaEventRecord");
        cuda::check(cudaStreamSynchronize(stream), "cudaStreamSynchronize");
        float ms = 0.0F;
        cuda::check(cudaEventElapsedTime(&ms, begin.get(), end.get()), "cudaEventElapsedTime");
        if (i >= 0) times_ms.push_back(static_cast<double>(ms));
    }
    return times_ms;
}

}  // namespace foverig::gpu
