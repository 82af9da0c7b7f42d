#pragma once
#include <sys/mman.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

#include "renderer/view.h"

namespace foverig {

/// What a backend has handed out: a renderer's memory is counted, not estimated.
struct MemoryCount {
    std::uint64_t bytes = 0;
    std::uint64_t allocations = 0;
};

/// Large arrays ask for 2 MiB pages: a tile touches 64 rows of each image, more than a TLB holds of
/// 4 KiB.
inline constexpr std::size_t kHugePage = std::size_t{2} << 20U;

/// Owned array of plain values, zeroed, at least 64-byte aligned, counted while it lives. Empty
/// until allocated.
template <class T>
class Buffer {
    static_assert(std::is_trivially_copyable_v<T>);

  public:
    Buffer() = default;
    Buffer(MemoryCount& count, std::size_t size) : Buffer(count, size, count, 0) {}
    /// One array whose last `more` elements another count answers for.
    Buffer(MemoryCount& count, std::size_t size, MemoryCount& more_count, std::size_t more)
        : data_(allocate(size + more),
                Free{&count, &more_count, size * sizeof(T), more * sizeof(T)}),
          size_(size + more) {
        if (size_ == 0) return;
        count.bytes += size * sizeof(T);
        more_count.bytes += more * sizeof(T);
        ++count.allocations;
    }

    T* data() { return data_.get(); }
    const T* data() const { return data_.get(); }
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    T& operator[](std::size_t i) { return data_.get()[i]; }
    const T& operator[](std::size_t i) const { return data_.get()[i]; }
    View<T> view() { return {data_.get(), size_}; }
    View<const T> view() const { return {data_.get(), size_}; }

  private:
    static constexpr std::size_t alignment(std::size_t bytes) {
        return bytes >= kHugePage ? kHugePage : 64;
    }

    static T* allocate(std::size_t size) {
        if (size == 0) return nullptr;
        const std::size_t bytes = size * sizeof(T);
        void* const p = ::operator new[](bytes, std::align_val_t{alignment(bytes)});
        if (bytes >= kHugePage) madvise(p, bytes / kHugePage * kHugePage, MADV_HUGEPAGE);
        std::memset(p, 0, bytes);
        return static_cast<T*>(p);
    }

    struct Free {
        MemoryCount* count = nullptr;
        MemoryCount* more_count = nullptr;
        std::size_t bytes = 0;
        std::size_t more_bytes = 0;
        void operator()(T* p) const {
            ::operator delete[](p, std::align_val_t{alignment(bytes + more_bytes)});
            count->bytes -= bytes;
            more_count->bytes -= more_bytes;
        }
    };
    std::unique_ptr<T[], Free> data_;
    std::size_t size_ = 0;
};

}  // namespace foverig
