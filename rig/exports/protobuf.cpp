#include "rig/exports/protobuf.h"

#include <bit>

namespace foverig::exports {
namespace {

enum WireType : std::uint64_t { kVarint = 0, kFixed64 = 1, kLength = 2 };

std::uint64_t tag(std::uint32_t field, WireType type) {
    return std::uint64_t{field} << 3U | type;
}

}  // namespace

void ProtobufMessage::put_varint(std::uint64_t value) {
    for (; value >= 0x80U; value >>= 7U) bytes_ += static_cast<char>((value & 0x7FU) | 0x80U);
    bytes_ += static_cast<char>(value);
}

void ProtobufMessage::put_fixed64(std::uint64_t value) {
    for (unsigned shift = 0; shift < 64; shift += 8)
        bytes_ += static_cast<char>(value >> shift & 0xFFU);
}

ProtobufMessage& ProtobufMessage::varint(std::uint32_t field, std::uint64_t value) {
    put_varint(tag(field, kVarint));
    put_varint(value);
    return *this;
}

ProtobufMessage& ProtobufMessage::fixed64(std::uint32_t field, std::uint64_t value) {
    put_varint(tag(field, kFixed64));
    put_fixed64(value);
    return *this;
}

ProtobufMessage& ProtobufMessage::number(std::uint32_t field, double value) {
    return fixed64(field, std::bit_cast<std::uint64_t>(value));
}

ProtobufMessage& ProtobufMessage::text(std::uint32_t field, std::string_view value) {
    put_varint(tag(field, kLength));
    put_varint(value.size());
    bytes_ += value;
    return *this;
}

}  // namespace foverig::exports
