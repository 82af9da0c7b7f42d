#pragma once
// A device on the desk as a Transport: one thread reads it, and opens it again when it was
// unplugged.
#include <functional>
#include <memory>
#include <thread>

#include "devices/hardware/link.h"
#include "devices/hardware/patience.h"

namespace foverig::hardware {

/// SCHED_FIFO of the readers, of 1..99: above what is not real time, below the kernel's own.
inline constexpr int kReaderPriority = 10;

class LiveTransport final : public Transport {
  public:
    using Open = std::function<Result<std::unique_ptr<Link>>()>;

    struct Settings {
        Nanoseconds retry_period{250'000'000};  ///< from a loss or a vain try to the next try
        bool realtime = true;                   ///< the reader runs as SCHED_FIFO where it may
        std::size_t queue_capacity = PacketQueue::kCapacity;  ///< packets
    };

    /// Opens the device now; its error is why it cannot. `clock` runs in real time, may be read by
    /// any thread, and outlives the transport.
    static Result<std::unique_ptr<LiveTransport>> open(const Clock& clock, Open open_link,
                                                       const Settings& settings);
    ~LiveTransport() override;

    /// While unplugged: Fault (closed). What is asked of the device then fails in the same way, and
    /// at once with not_asked where it let a request run out of time not long ago (patience.h).
    NextPacket next(HostTime deadline) override { return packets_.next(deadline); }
    Status control_set(std::uint8_t id, std::uint16_t value,
                       std::span<const std::byte> data) override;
    Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                               std::size_t size) override;
    void keep_awake(std::uint8_t id, std::span<const std::byte> data, Nanoseconds period) override;

  private:
    LiveTransport(const Clock& clock, Open open_link, std::shared_ptr<Link> link,
                  const Settings& settings);

    void read_until_stopped(const std::stop_token& stop);
    Status reopen();
    template <class Request>
    auto ask(Request request) -> decltype(request(std::declval<Link&>()));
    std::shared_ptr<Link> link() const;
    void set_link(std::shared_ptr<Link> link);

    const Clock& clock_;
    Open open_link_;
    Settings settings_;
    PacketQueue packets_;
    mutable std::mutex mutex_;
    std::condition_variable_any stopping_;
    std::shared_ptr<Link> link_;  // null while unplugged; a control transfer keeps its own
    Patience patience_;           // with this link
    std::function<void(Link&)> keep_awake_;  // empty: nobody asked for it
    std::jthread reader_;                    // last: stops first
};

}  // namespace foverig::hardware
