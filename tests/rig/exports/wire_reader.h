#pragma once
// Protobuf's wire format, read without a schema: fields by number, each as it stands in the bytes.
#include <bit>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace foverig::test {

struct WireField {
    std::uint64_t number = 0;  ///< of wire types 0 and 1
    std::string_view bytes;    ///< of wire type 2

    double as_double() const { return std::bit_cast<double>(number); }
};

using WireMessage = std::multimap<std::uint32_t, WireField>;

class WireReader {
  public:
    explicit WireReader(std::string_view bytes) : bytes_(bytes) {}

    WireMessage message() {
        WireMessage fields;
        while (!bytes_.empty()) {
            const std::uint64_t tag = varint();
            WireField field;
            switch (tag & 7U) {
                case 0:
                    field.number = varint();
                    break;
                case 1:
                    field.number = fixed64();
                    break;
                case 2:
                    field.bytes = take(varint());
                    break;
                default:
                    throw std::runtime_error("wire type that protobuf has not");
            }
            fields.emplace(static_cast<std::uint32_t>(tag >> 3U), field);
        }
        return fields;
    }

  private:
    std::string_view take(std::uint64_t count) {
        if (count > bytes_.size()) throw std::runtime_error("field beyond the end");
        const std::string_view taken = bytes_.substr(0, count);
        bytes_.remove_prefix(count);
        return taken;
    }

    std::uint64_t varint() {
        std::uint64_t value = 0;
        for (unsigned shift = 0;; shift += 7) {
            const auto byte = static_cast<unsigned char>(take(1)[0]);
            value |= std::uint64_t{byte & 0x7FU} << shift;
            if (byte < 0x80U) return value;
        }
    }

    std::uint64_t fixed64() {
        std::uint64_t value = 0;
        const std::string_view bytes = take(8);
        for (unsigned i = 0; i < 8; ++i)
            value |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
        return value;
    }

    std::string_view bytes_;
};

inline WireMessage read_wire(std::string_view bytes) {
    return WireReader(bytes).message();
}

}  // namespace foverig::test
