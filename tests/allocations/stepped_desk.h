#pragma once
// A simulated device behind the threads and queues of one on a desk, a packet at a time.
#include <atomic>
#include <functional>
#include <semaphore>

#include "devices/hardware/live_transport.h"
#include "tests/allocations/counted_new.h"

namespace foverig::test {

/// Any thread may read it; it jumps as a ManualClock does.
class SharedClock final : public Clock {
  public:
    HostTime now() const override { return now_; }
    void sleep_until(HostTime deadline) override { now_ = std::max(deadline, now_.load()); }

  private:
    std::atomic<HostTime> now_{HostTime{}};
};

/// The reader thread of a LiveTransport reads the next packet when the one before was taken, so
/// that no run depends on how the threads are scheduled. What the simulator allocates is not
/// counted.
class SteppedDesk final : public Transport {
  public:
    /// `device` and `clock` outlive this.
    SteppedDesk(Transport& device, SharedClock& clock)
        : live_(std::move(hardware::LiveTransport::open(
                              clock,
                              [this, &device, &clock] {
                                  return Result<std::unique_ptr<hardware::Link>>(
                                      std::make_unique<StepLink>(device, clock, turn_));
                              },
                              {.realtime = false}))
                    .value()) {}

    NextPacket next(HostTime deadline) override {
        if (!std::exchange(under_way_, true)) turn_.release();
        NextPacket got = live_->next(deadline);
        if (std::holds_alternative<Packet>(got)) under_way_ = false;
        return got;
    }
    Status control_set(std::uint8_t id, std::uint16_t value, Bytes data) override {
        return live_->control_set(id, value, data);
    }
    Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                               std::size_t size) override {
        return live_->control_get(id, value, size);
    }
    void keep_awake(std::uint8_t id, Bytes data, Nanoseconds period) override {
        live_->keep_awake(id, data, period);
    }

  private:
    using Turn = std::counting_semaphore<1>;

    class StepLink final : public hardware::Link {
      public:
        StepLink(Transport& device, const Clock& clock, Turn& turn)
            : device_(device), clock_(clock), turn_(turn) {}

        Status read(hardware::PacketQueue& packets) override {
            if (!turn_.try_acquire_for(std::chrono::milliseconds(10))) return Done{};
            if (const auto packet = packet_of_device()) packets.push(packet->bytes);
            return Done{};
        }
        Status control_set(std::uint8_t id, std::uint16_t value, Bytes data) override {
            const NotCounted simulator;
            return device_.control_set(id, value, data);
        }
        /// The answer is a vector: a request is no packet.
        Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                                   std::size_t size) override {
            const NotCounted simulator;
            return device_.control_get(id, value, size);
        }
        void keep_awake(std::uint8_t id, Bytes data, Nanoseconds period) override {
            const NotCounted simulator;
            device_.keep_awake(id, data, period);
        }

      private:
        std::optional<Packet> packet_of_device() {
            const NotCounted simulator;
            NextPacket next =
                device_.next(clock_.now() + Nanoseconds(std::int64_t{10'000'000'000}));
            if (auto* packet = std::get_if<Packet>(&next)) return std::move(*packet);
            return std::nullopt;
        }

        Transport& device_;
        const Clock& clock_;
        Turn& turn_;
    };

    Turn turn_{0};
    bool under_way_ = false;  // a packet was asked for and not yet taken
    std::unique_ptr<hardware::LiveTransport> live_;
};

}  // namespace foverig::test
