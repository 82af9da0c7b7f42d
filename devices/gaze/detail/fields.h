#pragma once
// Arrays of floats in SGZ1 bodies.
#include "devices/bytes.h"

namespace foverig::gaze::detail {

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
