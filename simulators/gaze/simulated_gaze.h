#pragma once
// A gaze tracker that is not there: SGZ1 frames from the eyes' motion. One thread uses it.
#include <deque>
#include <optional>

#include "devices/transport.h"
#include "simulators/gaze/gaze_firmware.h"

namespace foverig {

/// Idle until START, as the real one. Bytes are made as time passes on `clock`, up to the deadline
/// that is asked for and no further; `next` waits on the clock where the next packet lies ahead.
/// Motion time is host time. Not simulated: events; a blink of one eye alone comes only by an
/// order; a tracker that is plugged in again has lost its calibration.
class SimulatedGaze final : public Transport {
  public:
    struct Settings {
        GazeFaults faults{};
        std::uint64_t seed = 0;
    };

    /// Plugged in now. `clock` and `eyes` outlive the device.
    SimulatedGaze(Clock& clock, const motion::EyeMotion& eyes)
        : SimulatedGaze(clock, eyes, Settings{}) {}
    SimulatedGaze(Clock& clock, const motion::EyeMotion& eyes, const Settings& settings);

    /// While unplugged: Fault (closed), and once where it was unplugged and back between two calls.
    NextPacket next(HostTime deadline) override;
    Status control_set(std::uint8_t request, std::uint16_t value,
                       std::span<const std::byte> data) override;
    Result<std::vector<std::byte>> control_get(std::uint8_t request, std::uint16_t value,
                                               std::size_t size) override;

  private:
    struct Outage {
        HostTime from, to;
    };

    void plug_in(HostTime now);
    void cut_wire(HostTime at);  ///< what would arrive later is lost
    void advance(HostTime until);
    void unplug_now(HostTime now, Nanoseconds duration);
    HostTime unplugged_at() const {
        return outages_.empty() ? HostTime::max() : outages_.front().from;
    }

    Clock& clock_;
    const motion::EyeMotion& eyes_;
    Settings settings_;
    std::deque<Outage> outages_;  // to come, apart, in order: ordered ones before the faults' own
    HostTime plugged_again_at_{HostTime::max()};  // of the one that goes on
    bool fault_due_ = false;                      // nobody was told yet that it was unplugged
    std::optional<GazeFirmware> firmware_;        // none while unplugged
    std::deque<Packet> wire_;                     // in order of arrival
};

}  // namespace foverig
