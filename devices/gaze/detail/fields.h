#pragma once
// What SGZ1 frames and payloads are made of.
#include "devices/bytes.h"

namespace foverig::gaze::detail {

constexpr std::uint32_t kMagic = 0x315A4753;  ///< "SGZ1"

template <std::size_t n>
std::array<float, n> read_floats(Bytes b, std::size_t at) {
    std::array<float, n> v;
    for (std::size_t i = 0; i < n; ++i) v[i] = read_f32(b, at + 4 * i);
    return v;
}

/// Any NaN is written as the one quiet NaN of rule (c).
inline void write_float(std::span<std::byte> b, std::size_t at, float v) {
    v == v ? write_f32(b, at, v) : write_u32(b, at, 0x7FC00000u);
}

template <std::size_t n>
void write_floats(std::span<std::byte> b, std::size_t at, const std::array<float, n>& v) {
    for (std::size_t i = 0; i < n; ++i) write_float(b, at + 4 * i, v[i]);
}

}  // namespace foverig::gaze::detail
