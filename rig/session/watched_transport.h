#pragma once
// A transport whose losses are told the moment they show, and kept for the run's records.
#include <functional>
#include <string>
#include <vector>

#include "devices/transport.h"
#include "rig/records/run_record.h"

namespace foverig {

/// Takes one sentence for a person.
using Notice = std::function<void(const std::string&)>;

class WatchedTransport final : public Transport {
  public:
    /// All outlive this; `notice` may be set to another later. `clock` says when a loss showed,
    /// `meanwhile` what a run does without the device.
    WatchedTransport(Transport& device, std::string name, const Clock& clock, const Notice& notice,
                     const char* meanwhile = "its last sample stands")
        : device_(device),
          name_(std::move(name)),
          clock_(clock),
          notice_(notice),
          meanwhile_(meanwhile) {}

    NextPacket next(HostTime deadline) override;
    Status control_set(std::uint8_t id, std::uint16_t value,
                       std::span<const std::byte> data) override {
        return device_.control_set(id, value, data);
    }
    Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                               std::size_t size) override {
        return device_.control_get(id, value, size);
    }
    void keep_awake(std::uint8_t id, std::span<const std::byte> data, Nanoseconds period) override {
        device_.keep_awake(id, data, period);
    }

    /// In their order.
    const std::vector<Outage>& outages() const { return outages_; }

  private:
    void lost(const Error& why);
    void back(HostTime arrival);

    Transport& device_;
    std::string name_;
    const Clock& clock_;
    const Notice& notice_;
    const char* meanwhile_;
    std::vector<Outage> outages_;
};

}  // namespace foverig
