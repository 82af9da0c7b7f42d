#pragma once
#include <array>

#include "renderer/buffer.h"
#include "renderer/effects/plan.h"

namespace foverig {

/// A renderer's arrays, counted under the effect that they are there for; `base` has what every
/// plan needs. Must outlive its buffers, at one address.
class EffectMemory {
  public:
    EffectMemory() = default;
    EffectMemory(const EffectMemory&) = delete;
    EffectMemory& operator=(const EffectMemory&) = delete;
    ~EffectMemory() = default;

    MemoryCount& base() { return base_; }
    MemoryCount& of(Effect effect) { return effects_[static_cast<std::size_t>(effect)]; }
    std::uint64_t bytes(Effect effect) const {
        return effects_[static_cast<std::size_t>(effect)].bytes;
    }
    std::uint64_t bytes() const {
        std::uint64_t sum = base_.bytes;
        for (const MemoryCount& count : effects_) sum += count.bytes;
        return sum;
    }

  private:
    MemoryCount base_;
    std::array<MemoryCount, static_cast<std::size_t>(Effect::count)> effects_;
};

}  // namespace foverig
