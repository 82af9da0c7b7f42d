#include "rig/text/digest.h"

namespace foverig {
namespace {

constexpr unsigned __int128 kPrime = (static_cast<unsigned __int128>(1) << 88) | 0x13Bu;

}  // namespace

Digest& Digest::add(std::string_view bytes) {
    for (const char byte : bytes) hash_ = (hash_ ^ static_cast<unsigned char>(byte)) * kPrime;
    return *this;
}

std::string Digest::hex() const {
    std::string digits;
    for (int shift = 124; shift >= 0; shift -= 4)
        digits += "0123456789abcdef"[static_cast<unsigned>(hash_ >> shift) & 15U];
    return digits;
}

}  // namespace foverig
