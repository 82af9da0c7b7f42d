#include "devices/dk2/packed_triple.h"

#include <algorithm>
#include <cmath>

namespace foverig::dk2 {
namespace {

constexpr std::uint64_t kMask21 = (1u << 21) - 1;

std::int32_t sign_extend(std::uint64_t field) {
    const auto value = static_cast<std::int32_t>(field & kMask21);
    return value > kTripleMax ? value - (1 << 21) : value;
}

std::uint64_t field_of(std::int32_t value) {
    return static_cast<std::uint64_t>(std::clamp(value, kTripleMin, kTripleMax)) & kMask21;
}

std::int32_t nearest(double si) {
    if (std::isnan(si)) return 0;
    const double scaled = std::clamp(si / kTripleUnit, double{kTripleMin}, double{kTripleMax});
    return static_cast<std::int32_t>(std::lround(scaled));
}

}  // namespace

Triple read_triple(Bytes b, std::size_t at) {
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < kTripleSize; ++i) word = word << 8 | read_u8(b, at + i);
    return {sign_extend(word >> 43), sign_extend(word >> 22), sign_extend(word >> 1)};
}

void write_triple(std::span<std::byte> b, std::size_t at, const Triple& t) {
    const std::uint64_t word = field_of(t.x) << 43 | field_of(t.y) << 22 | field_of(t.z) << 1;
    for (std::size_t i = 0; i < kTripleSize; ++i) {
        write_u8(b, at + i, static_cast<std::uint8_t>(word >> (56 - 8 * i)));
    }
}

Triple from_si(const dvec3& v) {
    return {nearest(v.x), nearest(v.y), nearest(v.z)};
}

}  // namespace foverig::dk2
