#pragma once
// Randomness as a hash of indices, and a small seeded generator for long draws.
#include <cstdint>

namespace foverig::builtin {

/// Bijection of 32 bits in which every input bit reaches every output bit.
inline std::uint32_t hash(std::uint32_t x) {
    x ^= x >> 16U;
    x *= 0x21f0aaadU;
    x ^= x >> 15U;
    x *= 0x735a2d97U;
    x ^= x >> 15U;
    return x;
}

template <class... More>
std::uint32_t hash(std::uint32_t first, std::uint32_t second, More... more) {
    return hash(hash(first) ^ (second + 0x9e3779b9U), more...);
}

/// 0 <= value < 1, all 24 bits used.
inline float unit_of(std::uint32_t bits) {
    return static_cast<float>(bits >> 8U) * 0x1p-24F;
}

/// Seeded sequence: the n-th draw is a hash of (seed, n).
class Dice {
  public:
    explicit Dice(std::uint32_t seed) : seed_(hash(seed, 0x5eedU)) {}

    float unit() { return unit_of(next()); }
    float between(float low, float high) { return low + (high - low) * unit(); }
    bool chance(float probability) { return unit() < probability; }
    /// 0 <= value < count.
    int below(int count) {
        return static_cast<int>(
            (static_cast<std::uint64_t>(next()) * static_cast<std::uint64_t>(count)) >> 32U);
    }

  private:
    std::uint32_t next() { return hash(seed_, draws_++); }

    std::uint32_t seed_;
    std::uint32_t draws_ = 0;
};

}  // namespace foverig::builtin
