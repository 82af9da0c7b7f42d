#pragma once
#include "renderer/kernels/sampling.h"

namespace foverig {

/// Permutes the first 2^16 indices so that aligned runs of a power of two stay such runs (nested
/// uniform shuffle by Laine-Karras hashing on mirrored bits: Burley 2020, "Practical Hash-based
/// Owen Scrambling").
RIG_INLINE std::uint32_t shuffled_index(std::uint32_t index, std::uint32_t seed) {
    std::uint32_t x = reverse_bits(index) + seed;
    x ^= x * 0x6C50B47CU;
    x ^= x * 0xB82F1E52U;
    x ^= x * 0xC7AFE638U;
    x ^= x * 0x8D22F6E6U;
    return reverse_bits(x) & 0xFFFFU;
}

/// What a pair of random numbers of a path is for; light l takes two pairs, from kLightPair + 2 l.
enum PathDimension : std::uint32_t {
    kLensPair = 0,
    kLobePair = 1,
    kDirectionPair = 2,
    kOcclusionPair = 3,
    kLightPair = 4
};

/// Sample `index` of every pixel: each pair of dimensions is its own (0,2)-sequence over the
/// samples, shuffled and scrambled apart, so that pairs are independent of each other while each
/// converges as a net does.
struct PathSampler {
    std::uint32_t seed = 0;   ///< of the run and of the half that accumulates the sample
    std::uint32_t index = 0;  ///< < 2^16

    RIG_HD vec2 point(std::uint32_t pixel, std::uint32_t bounce, std::uint32_t dimension) const {
        const std::uint32_t key = hash32(hash32(seed, pixel), (bounce << 16U) + dimension);
        return scrambled_point(shuffled_index(index, key), hash32(key));
    }
};

}  // namespace foverig
