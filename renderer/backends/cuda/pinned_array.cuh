#pragma once
#include <memory>
#include <type_traits>

#include "renderer/backends/cuda/check.cuh"
#include "renderer/buffer.h"

namespace foverig::cuda {

/// Owned array in page-locked memory of the host, counted while it lives: what the device copies
/// from while the host goes on.
template <class T>
class PinnedArray {
    static_assert(std::is_trivially_copyable_v<T>);

  public:
    PinnedArray() = default;
    PinnedArray(MemoryCount& count, std::size_t size)
        : data_(allocate(size), Free{&count, size * sizeof(T)}), size_(size) {
        if (size_ == 0) return;
        count.bytes += size * sizeof(T);
        ++count.allocations;
    }

    const T* data() const { return data_.get(); }
    View<T> view() { return {data_.get(), size_}; }

  private:
    static T* allocate(std::size_t size) {
        void* p = nullptr;
        if (size > 0) check(cudaMallocHost(&p, size * sizeof(T)), "cudaMallocHost");
        return static_cast<T*>(p);
    }

    struct Free {
        MemoryCount* count = nullptr;
        std::size_t bytes = 0;
        void operator()(T* p) const {
            cudaFreeHost(p);
            count->bytes -= bytes;
        }
    };
    std::unique_ptr<T[], Free> data_;
    std::size_t size_ = 0;
};

}  // namespace foverig::cuda
