#pragma once
// Between the thread that reads a device and the one that asks for packets.
#include <condition_variable>
#include <mutex>
#include <optional>

#include "devices/ring.h"
#include "devices/transport.h"

namespace foverig::hardware {

/// Packets in order of arrival, and whether the device is there. Safe for one reader thread and one
/// that asks.
class PacketQueue {
  public:
    /// 16 s of a DK2.
    static constexpr std::size_t kCapacity = 16384;

    /// `clock` runs in real time, may be read by any thread, and outlives the queue.
    /// Beyond `capacity` the oldest goes: packets, which the source then counts as lost, and of
    /// losses between them all but the newest.
    explicit PacketQueue(const Clock& clock, std::size_t capacity = kCapacity)
        : clock_(clock), capacity_(capacity) {}

    /// Came just now; `rest` is the packet's second part, where it has one.
    void push(Bytes packet, Bytes rest = {});
    /// The device is gone: gives at least one Fault, behind the packets before it.
    void lost(const Error& why);
    void found();

    /// As Transport::next.
    NextPacket next(HostTime deadline);

  private:
    using Item = std::variant<Packet, Fault>;

    void add(Item item);
    std::optional<NextPacket> take(HostTime deadline);

    const Clock& clock_;
    std::size_t capacity_;
    std::mutex mutex_;
    std::condition_variable news_;
    BytePool pool_;
    Ring<Item> items_;
    std::optional<Fault> untold_;  // of a loss that gave way; before all items
    std::optional<Error> gone_;
};

}  // namespace foverig::hardware
