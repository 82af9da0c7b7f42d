#pragma once
#include "devices/recording/control_exchange.h"
#include "devices/recording/device_topics.h"

namespace foverig {

/// A transport whose bytes are recorded on the way: packets with their arrival, control transfers,
/// and the first of a row of faults.
class RecordedTransport final : public Transport {
  public:
    /// All outlive this. `clock` stamps what has no arrival.
    RecordedTransport(Transport& device, Recorder& recorder, const Clock& clock,
                      const RecordedDevice& about);

    NextPacket next(HostTime deadline) override;
    Status control_set(std::uint8_t id, std::uint16_t value,
                       std::span<const std::byte> data) override;
    Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                               std::size_t size) override;
    /// Passed on; what is sent of it later is not in the recording.
    void keep_awake(std::uint8_t id, std::span<const std::byte> data, Nanoseconds period) override {
        device_.keep_awake(id, data, period);
    }

  private:
    void record(const ControlExchange& exchange);

    Transport& device_;
    Recorder& recorder_;
    const Clock& clock_;
    Recorder::TopicId raw_, control_;
    bool faulty_ = false;
};

}  // namespace foverig
