#pragma once
// Randomness without state: hashes of (pixel, frame, dimension) and a scrambled (0,2)-sequence.
#include <cstdint>

#include "renderer/math.h"
#include "renderer/vec.h"
#include "renderer/view.h"

namespace foverig {

/// Good avalanche in few operations ("lowbias32" of the hash-prospector search).
RIG_INLINE std::uint32_t hash32(std::uint32_t x) {
    x ^= x >> 16U;
    x *= 0x7FEB352DU;
    x ^= x >> 15U;
    x *= 0x846CA68BU;
    x ^= x >> 16U;
    return x;
}

RIG_INLINE std::uint32_t hash32(std::uint32_t a, std::uint32_t b) {
    return hash32(a ^ (hash32(b) + 0x9E3779B9U));
}

/// [0, 1): the top 24 bits, exact in float.
RIG_INLINE float unit_float(std::uint32_t bits) {
    return static_cast<float>(bits >> 8U) * 0x1.0p-24F;
}

RIG_INLINE std::uint32_t reverse_bits(std::uint32_t x) {
    x = (x << 16U) | (x >> 16U);
    x = ((x & 0x00FF00FFU) << 8U) | ((x & 0xFF00FF00U) >> 8U);
    x = ((x & 0x0F0F0F0FU) << 4U) | ((x & 0xF0F0F0F0U) >> 4U);
    x = ((x & 0x33333333U) << 2U) | ((x & 0xCCCCCCCCU) >> 2U);
    x = ((x & 0x55555555U) << 1U) | ((x & 0xAAAAAAAAU) >> 1U);
    return x;
}

/// Second dimension of Sobol's sequence; with `reverse_bits` as the first it is a (0,2)-sequence:
/// each aligned run of 2^m points is a net, so a pattern that takes such a run is stratified by
/// itself, and all patterns together are again (Kollig and Keller 2002).
RIG_INLINE std::uint32_t sobol2(std::uint32_t i) {
    std::uint32_t result = 0;
    for (std::uint32_t v = 1U << 31U; i != 0; i >>= 1U, v ^= v >> 1U)
        if ((i & 1U) != 0) result ^= v;
    return result;
}

/// Point i of the sequence, digits scrambled by `seed` (random digit shift keeps the net).
RIG_INLINE vec2 scrambled_point(std::uint32_t i, std::uint32_t seed) {
    return {unit_float(reverse_bits(i) ^ hash32(seed)),
            unit_float(sobol2(i) ^ hash32(seed ^ 0xB5297A4DU))};
}

/// Low-discrepancy jitter of a frame's primary rays within their pixels (oversampling).
RIG_INLINE vec2 pixel_jitter_px(std::uint32_t frame) {
    return scrambled_point(frame, 0x51ED27U) - vec2(0.5F);
}

/// Interleaved sampling (Keller and Heidrich 2001): the pixels of a 4x4 block use 16 different runs
/// of the sequence, each block in another order, so that no grid shows. Rays of equal local
/// direction come from pixels that are near, and can share a packet, without being neighbours.
inline constexpr int kPatterns = 16;

RIG_INLINE int pattern_of(std::uint32_t x, std::uint32_t y) {
    const std::uint32_t in_block = (x & 3U) | ((y & 3U) << 2U);
    const std::uint32_t block = (x >> 2U) | ((y >> 2U) << 16U);
    return static_cast<int>(in_block ^ (hash32(block) & 15U));
}

/// Numbers of all patterns for one frame and one light: entry pattern * samples + k of each row.
/// Rows and not structs, so that sixteen lanes gather them in vectors.
struct PatternTable {
    const float* rows = nullptr;
    int samples = 0;

    RIG_HD float get(int row, int pattern, int sample) const {
        return rows[row * kPatterns * samples + pattern * samples + sample];
    }
};

/// Cosine-weighted direction about +z (Malley): pi times its mean is the irradiance.
RIG_INLINE vec3 cosine_direction(vec2 p) {
    const float phi = 6.28318530718F * p.x;
    const float r = sqrtf(p.y);
    return {r * cosf(phi), r * sinf(phi), sqrtf(max_of(0.0F, 1.0F - p.y))};
}

/// Orthonormal frame about unit n without a branch (Duff et al. 2017).
struct Frame {
    vec3 tangent;
    vec3 bitangent;
    vec3 normal;

    RIG_HD vec3 world(const vec3& local) const {
        return local.x * tangent + local.y * bitangent + local.z * normal;
    }
};

RIG_INLINE Frame frame_about(const vec3& n) {
    const float sign = n.z < 0.0F ? -1.0F : 1.0F;
    const float a = -1.0F / (sign + n.z);
    const float b = n.x * n.y * a;
    return {
        {1.0F + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

}  // namespace foverig
