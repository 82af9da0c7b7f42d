#pragma once
// Explicit little-endian access to packet bytes; no packed structs, no casts of buffers.
// The caller has checked the size: `at` reads and writes assert it and never look further.
#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foverig {

using Bytes = std::span<const std::byte>;

inline std::vector<std::byte> to_vector(Bytes b) {
    return {b.begin(), b.end()};
}

inline std::uint8_t read_u8(Bytes b, std::size_t at) {
    assert(at < b.size());
    return std::to_integer<std::uint8_t>(b[at]);
}

namespace detail {

template <class U>
U read_le(Bytes b, std::size_t at) {
    assert(at + sizeof(U) <= b.size());
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < sizeof(U); ++i) {
        value |= std::to_integer<std::uint64_t>(b[at + i]) << (8 * i);
    }
    return static_cast<U>(value);
}

template <class U>
void write_le(std::span<std::byte> b, std::size_t at, U value) {
    assert(at + sizeof(U) <= b.size());
    for (std::size_t i = 0; i < sizeof(U); ++i) {
        b[at + i] = static_cast<std::byte>((std::uint64_t{value} >> (8 * i)) & 0xFF);
    }
}

}  // namespace detail

inline std::uint16_t read_u16(Bytes b, std::size_t at) {
    return detail::read_le<std::uint16_t>(b, at);
}
inline std::uint32_t read_u32(Bytes b, std::size_t at) {
    return detail::read_le<std::uint32_t>(b, at);
}
inline std::uint64_t read_u64(Bytes b, std::size_t at) {
    return detail::read_le<std::uint64_t>(b, at);
}
inline std::int16_t read_s16(Bytes b, std::size_t at) {
    return static_cast<std::int16_t>(read_u16(b, at));
}
inline float read_f32(Bytes b, std::size_t at) {
    return std::bit_cast<float>(read_u32(b, at));
}

inline void write_u8(std::span<std::byte> b, std::size_t at, std::uint8_t v) {
    detail::write_le(b, at, v);
}
inline void write_u16(std::span<std::byte> b, std::size_t at, std::uint16_t v) {
    detail::write_le(b, at, v);
}
inline void write_u32(std::span<std::byte> b, std::size_t at, std::uint32_t v) {
    detail::write_le(b, at, v);
}
inline void write_u64(std::span<std::byte> b, std::size_t at, std::uint64_t v) {
    detail::write_le(b, at, v);
}
inline void write_s16(std::span<std::byte> b, std::size_t at, std::int16_t v) {
    write_u16(b, at, static_cast<std::uint16_t>(v));
}
inline void write_f32(std::span<std::byte> b, std::size_t at, float v) {
    write_u32(b, at, std::bit_cast<std::uint32_t>(v));
}

}  // namespace foverig
