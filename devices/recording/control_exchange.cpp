#include "devices/recording/control_exchange.h"

#include <algorithm>

namespace foverig {

// u8 kind, u8 id, u16 value, u32 asked size, u8 outcome (0 good, else 1 + error code), 3 reserved.
std::vector<std::byte> ControlExchange::encode() const {
    std::vector<std::byte> out(kHead + data.size());
    write_u8(out, 0, static_cast<std::uint8_t>(kind));
    write_u8(out, 1, id);
    write_u16(out, 2, value);
    write_u32(out, 4, asked_size);
    write_u8(out, 8, error ? static_cast<std::uint8_t>(1 + static_cast<int>(*error)) : 0);
    std::copy(data.begin(), data.end(), out.begin() + kHead);
    return out;
}

Result<ControlExchange> ControlExchange::decode(Bytes bytes) {
    constexpr auto kLastKind = static_cast<std::uint8_t>(Kind::fault);
    constexpr auto kLastOutcome = 1 + static_cast<int>(ErrorCode::not_asked);
    if (bytes.size() < kHead || read_u8(bytes, 0) > kLastKind || read_u8(bytes, 8) > kLastOutcome) {
        return Error{ErrorCode::invalid_data, "a recorded control transfer is malformed"};
    }
    ControlExchange exchange;
    exchange.kind = static_cast<Kind>(read_u8(bytes, 0));
    exchange.id = read_u8(bytes, 1);
    exchange.value = read_u16(bytes, 2);
    exchange.asked_size = read_u32(bytes, 4);
    if (const int outcome = read_u8(bytes, 8); outcome > 0) {
        exchange.error = static_cast<ErrorCode>(outcome - 1);
    }
    exchange.data = to_vector(bytes.subspan(kHead));
    return exchange;
}

std::string ControlExchange::text() const {
    return {reinterpret_cast<const char*>(data.data()), data.size()};
}

}  // namespace foverig
