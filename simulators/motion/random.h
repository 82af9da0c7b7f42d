#pragma once
// Random draws that are a hash of (seed, stream, index): the same numbers on every machine, in any
// order, without a running state. Standard-library distributions differ between libraries.
#include <cmath>
#include <cstdint>
#include <numbers>

namespace foverig::motion {

/// Bijective 64-bit mix (the splitmix64 finaliser's constants, Steele et al. 2014).
constexpr std::uint64_t mix64(std::uint64_t x) {
    x += 0x9E3779B97F4A7C15u;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return x ^ (x >> 31);
}

/// One independent stream of draws; `index` names the draw.
class Draws {
  public:
    constexpr Draws(std::uint64_t seed, std::uint64_t stream)
        : key_(mix64(mix64(seed) ^ (stream * 0xD1342543DE82EF95u))) {}

    constexpr std::uint64_t bits(std::uint64_t index) const { return mix64(key_ ^ mix64(index)); }

    /// Uniform in the open interval (0, 1).
    double uniform(std::uint64_t index) const {
        return (static_cast<double>(bits(index) >> 12) + 0.5) * 0x1p-52;
    }
    double uniform(std::uint64_t index, double low, double high) const {
        return low + (high - low) * uniform(index);
    }
    /// Standard normal, by Box and Muller; uses a second hash beside `index`.
    double normal(std::uint64_t index) const {
        const double second = uniform(index ^ 0x8000000000000000u);
        return std::sqrt(-2.0 * std::log(uniform(index))) *
               std::cos(2.0 * std::numbers::pi * second);
    }
    double log_normal(std::uint64_t index, double median, double sigma_ln) const {
        return median * std::exp(sigma_ln * normal(index));
    }
    double exponential(std::uint64_t index, double mean) const {
        return -mean * std::log(uniform(index));
    }
    /// -1 or +1.
    double sign(std::uint64_t index) const { return (bits(index) >> 63) != 0 ? 1.0 : -1.0; }

  private:
    std::uint64_t key_;
};

}  // namespace foverig::motion
