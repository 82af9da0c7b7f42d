#pragma once
// What went over a device's control pipe, and when its stream failed: a message each, beside the
// packets, so that a replay can answer what a driver asks.
#include <optional>

#include "devices/bytes.h"
#include "devices/result.h"
#include "devices/transport.h"

namespace foverig {

struct ControlExchange {
    enum class Kind : std::uint8_t { set = 0, get, fault };

    static constexpr std::size_t kHead = 12;

    Kind kind = Kind::set;
    std::uint8_t id = 0;
    std::uint16_t value = 0;
    std::uint32_t asked_size = 0;      ///< of a get
    std::optional<ErrorCode> error{};  ///< the device refused; `data` is the sentence
    std::vector<std::byte> data{};     ///< of a set: sent; of a get: answered

    std::vector<std::byte> encode() const;
    static Result<ControlExchange> decode(Bytes bytes);
    bool operator==(const ControlExchange&) const = default;

    std::string text() const;  ///< `data` as a sentence
};

}  // namespace foverig
