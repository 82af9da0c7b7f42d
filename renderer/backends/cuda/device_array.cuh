#pragma once
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "renderer/backends/cuda/check.cuh"
#include "renderer/buffer.h"

namespace foverig::cuda {

/// Owned array in the GPU's own memory (plain cudaMalloc), zeroed, counted while it lives. Its view
/// is for kernels alone.
template <class T>
class DeviceArray {
    static_assert(std::is_trivially_copyable_v<T>);

  public:
    DeviceArray() = default;
    DeviceArray(MemoryCount& count, std::size_t size)
        : data_(allocate(size), Free{&count, size * sizeof(T)}), size_(size) {
        if (size_ == 0) return;
        count.bytes += size * sizeof(T);
        ++count.allocations;
        check(cudaMemset(data_.get(), 0, size * sizeof(T)), "cudaMemset");
        // Streams of ours do not wait for the default one, which zeroes.
        check(cudaStreamSynchronize(nullptr), "cudaStreamSynchronize after cudaMemset");
    }

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    T* data() { return data_.get(); }
    const T* data() const { return data_.get(); }
    View<T> view() { return {data_.get(), size_}; }
    View<const T> view() const { return {data_.get(), size_}; }

    /// In order with the stream's work. From pageable memory: `from` may change on return.
    void upload(View<const T> from, cudaStream_t stream) {
        if (from.size > size_) throw CudaError("an upload is larger than its array");
        check(cudaMemcpyAsync(data_.get(), from.data, from.size * sizeof(T), cudaMemcpyHostToDevice,
                              stream),
              "cudaMemcpyAsync to the device");
    }
    /// Waits for the stream.
    std::vector<T> download(cudaStream_t stream) const {
        std::vector<T> to(size_);
        check(cudaMemcpyAsync(to.data(), data_.get(), size_ * sizeof(T), cudaMemcpyDeviceToHost,
                              stream),
              "cudaMemcpyAsync to the host");
        check(cudaStreamSynchronize(stream), "cudaStreamSynchronize after a download");
        return to;
    }

  private:
    static T* allocate(std::size_t size) {
        void* p = nullptr;
        if (size > 0) check(cudaMalloc(&p, size * sizeof(T)), "cudaMalloc");
        return static_cast<T*>(p);
    }

    struct Free {
        MemoryCount* count = nullptr;
        std::size_t bytes = 0;
        void operator()(T* p) const {
            cudaFree(p);
            count->bytes -= bytes;
        }
    };
    std::unique_ptr<T[], Free> data_;
    std::size_t size_ = 0;
};

}  // namespace foverig::cuda
