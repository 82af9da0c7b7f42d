#pragma once
// The bytes seam. Hardware, recordings and simulators all enter here, so that decoders, counter
// wraps and clock mapping run in every test.
#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "devices/byte_pool.h"
#include "devices/result.h"
#include "devices/time.h"

namespace foverig {

struct Timeout {};
struct EndOfStream {};
struct Fault {
    Error error;
};

struct Packet {
    HostTime arrival{};  ///< when the host had it
    BytePool::Held bytes;
};

/// Four outcomes, told apart; 0 never means two things.
using NextPacket = std::variant<Packet, Timeout, EndOfStream, Fault>;

/// A stream of stamped packets with control transfers beside it.
class Transport {
  public:
    virtual ~Transport() = default;
    /// The oldest packet that arrived by `deadline`.
    virtual NextPacket next(HostTime deadline) = 0;
    /// HID feature report SET/GET, or a vendor control request; `id` is the report or request id.
    virtual Status control_set(std::uint8_t id, std::uint16_t value,
                               std::span<const std::byte> data) = 0;
    virtual Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                                       std::size_t size) = 0;
    /// For a device that falls asleep unless it is spoken to: what reads it does this control_set
    /// each `period` from now on, however long nobody calls `next`, also where it was unplugged and
    /// came back. Without effect where nothing falls asleep.
    virtual void keep_awake(std::uint8_t, std::span<const std::byte> /*data*/,
                            Nanoseconds /*period*/) {}
};

}  // namespace foverig
