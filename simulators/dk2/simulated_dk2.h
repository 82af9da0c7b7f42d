#pragma once
// A DK2 that is not there: report 11 bytes from a head's motion. One thread uses it.
#include <memory>
#include <optional>

#include "devices/transport.h"
#include "simulators/dk2/dk2_firmware.h"

namespace foverig {

/// Bytes are made as time passes on `clock`, up to the deadline that is asked for and no further;
/// `next` waits on the clock where the next packet lies ahead. Motion time is host time.
class SimulatedDk2 final : public Transport, public LedLight {
  public:
    struct Settings {
        Dk2Faults faults{};
        std::uint64_t seed = 0;
        const PanelSensor* panel = nullptr;  ///< outlives the device; null: no panel
        Nanoseconds poll_phase{100'000};     ///< USB frames against the first sample, under 1 ms
    };

    /// Plugged in now. `clock` and `head` outlive the device.
    SimulatedDk2(Clock& clock, const motion::HeadMotion& head)
        : SimulatedDk2(clock, head, Settings{}) {}
    SimulatedDk2(Clock& clock, const motion::HeadMotion& head, const Settings& settings);

    /// While unplugged: Fault (closed), and once where it was unplugged and back between two calls.
    NextPacket next(HostTime deadline) override;
    Status control_set(std::uint8_t id, std::uint16_t value,
                       std::span<const std::byte> data) override;
    Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                               std::size_t size) override;
    /// At the instants when it is due, whenever `next` is called after them.
    void keep_awake(std::uint8_t id, std::span<const std::byte> data, Nanoseconds period) override;
    std::optional<LedFlash> flash_after(HostTime t) const override;

  private:
    void plug_in(HostTime now);
    void advance(HostTime until);
    void run_firmware(HostTime until);

    /// What LiveTransport's reader does for a headset on the desk.
    struct KeepAlive {
        std::vector<std::byte> report;
        Nanoseconds period;
        HostTime due;
    };

    Clock& clock_;
    const motion::HeadMotion& head_;
    Settings settings_;
    HostTime unplugged_at_{HostTime::max()}, plugged_again_at_{HostTime::max()};
    bool fault_due_ = false;                 // nobody was told yet that it was unplugged
    std::unique_ptr<Dk2Firmware> firmware_;  // null while unplugged
    std::optional<KeepAlive> keep_alive_;
    ReportWire wire_;
};

}  // namespace foverig
