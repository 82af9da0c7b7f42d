#pragma once
// One connection to one device, from being opened to being unplugged.
#include "devices/hardware/packet_queue.h"

namespace foverig::hardware {

class Link {
  public:
    virtual ~Link() = default;

    /// Waits a moment for packets and pushes what came; an error says that the device is gone.
    /// Called by the reader thread only.
    virtual Status read(PacketQueue& packets) = 0;
    /// As Transport's; called by any one thread while `read` runs on another.
    virtual Status control_set(std::uint8_t id, std::uint16_t value, Bytes data) = 0;
    virtual Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                                       std::size_t size) = 0;
    /// As Transport's: `read` does it. Called as control_set is.
    virtual void keep_awake(std::uint8_t, Bytes /*data*/, Nanoseconds /*period*/) {}
};

}  // namespace foverig::hardware
