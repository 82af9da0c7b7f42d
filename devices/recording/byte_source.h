#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "devices/bytes.h"
#include "devices/result.h"

namespace foverig {

/// A file that is read here and there.
class ByteSource {
  public:
    virtual ~ByteSource() = default;
    virtual std::uint64_t size() const = 0;
    /// Fills `out`, which lies within the source.
    virtual Status read(std::uint64_t offset, std::span<std::byte> out) const = 0;
};

/// Bytes in memory; they outlive the source.
class MemorySource final : public ByteSource {
  public:
    explicit MemorySource(Bytes bytes) : bytes_(bytes) {}
    std::uint64_t size() const override { return bytes_.size(); }
    Status read(std::uint64_t offset, std::span<std::byte> out) const override {
        const Bytes from = bytes_.subspan(static_cast<std::size_t>(offset), out.size());
        std::copy(from.begin(), from.end(), out.begin());
        return Done{};
    }

  private:
    Bytes bytes_;
};

}  // namespace foverig
