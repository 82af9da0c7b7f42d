#pragma once
#include "devices/transport.h"

namespace foverig {

/// A tracker camera with a headset of its own before it: nobody else drives that one, so its LEDs
/// are told to blink, and it is kept awake.
class StagedCamera final : public Transport {
  public:
    /// All outlive this; the headset is used by nobody else.
    StagedCamera(Transport& camera, Transport& headset, const Clock& clock);

    NextPacket next(HostTime deadline) override;
    Status control_set(std::uint8_t id, std::uint16_t value,
                       std::span<const std::byte> data) override {
        return camera_.control_set(id, value, data);
    }
    Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                               std::size_t size) override {
        return camera_.control_get(id, value, size);
    }

  private:
    void light(HostTime now);

    Transport& camera_;
    Transport& headset_;
    const Clock& clock_;
    HostTime tell_again_;
    bool dark_ = true;  // it was not told to blink since it was plugged in
};

}  // namespace foverig
