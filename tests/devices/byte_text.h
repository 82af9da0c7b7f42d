#pragma once
// Bytes written as hexadecimal text, for golden vectors; and seeded random bytes.
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "devices/bytes.h"

namespace foverig::test {

inline std::vector<std::byte> bytes_of(std::string_view hex) {
    std::vector<std::byte> out;
    int digits = 0, value = 0;
    for (const char c : hex) {
        if (c == ' ' || c == '\n') continue;
        value = 16 * value + (c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10);
        if (++digits % 2 == 0) {
            out.push_back(static_cast<std::byte>(value));
            value = 0;
        }
    }
    return out;
}

template <class Container>
std::vector<std::byte> copy_of(const Container& bytes) {
    return {bytes.begin(), bytes.end()};
}

/// splitmix64: the same numbers everywhere.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
        z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
        z = (z ^ z >> 27) * 0x94D049BB133111EBu;
        return z ^ z >> 31;
    }
    double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }  ///< [0, 1)
    std::vector<std::byte> bytes(std::size_t n) {
        std::vector<std::byte> out(n);
        for (std::byte& b : out) b = static_cast<std::byte>(bits() & 0xFF);
        return out;
    }

  private:
    std::uint64_t state_;
};

}  // namespace foverig::test
