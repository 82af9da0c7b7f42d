#pragma once
// Memory of packets that is used again, so that a stream which has run for a while allocates
// nothing.
#include <cstddef>
#include <memory>
#include <vector>

#include "devices/bytes.h"

namespace foverig {

/// Gives out bytes that come back when they are let go of, on any thread. Holds as many as were
/// ever out at once; what is out when the pool ends is freed like any other.
class BytePool {
    struct Spares;

  public:
    /// Bytes of a pool, or of their own, as every copy is.
    class Held {
      public:
        Held() = default;
        Held(std::vector<std::byte> own)  // NOLINT(google-explicit-constructor)
            : bytes_(std::move(own)) {}
        Held(const Held& other) : bytes_(other.bytes_) {}
        Held(Held&&) noexcept = default;
        Held& operator=(Held other) noexcept;
        ~Held() { give_back(); }

        bool empty() const { return bytes_.empty(); }
        std::size_t size() const { return bytes_.size(); }
        std::byte operator[](std::size_t i) const { return bytes_[i]; }
        auto begin() const { return bytes_.begin(); }
        auto end() const { return bytes_.end(); }
        bool operator==(const Held& other) const { return bytes_ == other.bytes_; }

        /// As a vector that is the caller's from now on.
        std::vector<std::byte> release() &&;

      private:
        friend class BytePool;
        void give_back() noexcept;

        std::vector<std::byte> bytes_;
        std::shared_ptr<Spares> home_;  // null: their own
    };

    BytePool();

    /// A copy of `head` and `rest`, one behind the other.
    Held copy_of(Bytes head, Bytes rest = {});

  private:
    std::shared_ptr<Spares> spares_;
};

}  // namespace foverig
