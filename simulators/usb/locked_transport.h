#pragma once
#include <mutex>

#include "devices/transport.h"

namespace foverig::usb {

/// A transport that several threads may use. None waits long where `next` is never asked to wait.
class LockedTransport final : public Transport {
  public:
    /// `device` outlives this.
    explicit LockedTransport(Transport& device) : device_(device) {}

    NextPacket next(HostTime deadline) override {
        const std::lock_guard lock(mutex_);
        return device_.next(deadline);
    }
    Status control_set(std::uint8_t id, std::uint16_t value,
                       std::span<const std::byte> data) override {
        const std::lock_guard lock(mutex_);
        return device_.control_set(id, value, data);
    }
    Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                               std::size_t size) override {
        const std::lock_guard lock(mutex_);
        return device_.control_get(id, value, size);
    }

  private:
    std::mutex mutex_;
    Transport& device_;
};

}  // namespace foverig::usb
