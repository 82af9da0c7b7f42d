#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace foverig::exports {

/// The bytes of a protobuf message, field by field (protobuf.dev, "Encoding"); as much of it as a
/// trace needs.
class ProtobufMessage {
  public:
    ProtobufMessage& varint(std::uint32_t field, std::uint64_t value);
    ProtobufMessage& fixed64(std::uint32_t field, std::uint64_t value);
    ProtobufMessage& number(std::uint32_t field, double value);
    ProtobufMessage& text(std::uint32_t field, std::string_view value);
    ProtobufMessage& message(std::uint32_t field, const ProtobufMessage& value) {
        return text(field, value.bytes_);
    }

    const std::string& bytes() const { return bytes_; }

  private:
    void put_varint(std::uint64_t value);
    void put_fixed64(std::uint64_t value);

    std::string bytes_;
};

}  // namespace foverig::exports
