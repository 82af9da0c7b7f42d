#pragma once
// The DK2's microcontroller from plugging in to unplugging: it samples, packs and queues reports in
// the order of time. Knows nothing of the host but when it polls.
#include <cstdint>
#include <optional>
#include <vector>

#include "simulators/dk2/feature_bank.h"
#include "simulators/dk2/imu_model.h"
#include "simulators/dk2/led_light.h"
#include "simulators/dk2/panel_sensor.h"
#include "simulators/dk2/report_wire.h"
#include "simulators/dk2/sample_packer.h"
#include "simulators/faults/device_clock.h"

namespace foverig {

class Dk2Firmware {
  public:
    struct Settings {
        const motion::HeadMotion* head =
            nullptr;                         ///< outlives the device; motion time is host time
        const PanelSensor* panel = nullptr;  ///< may be null: no panel fields
        Dk2Faults faults{};
        std::uint64_t seed = 0;
        HostTime plugged_in{};
        Nanoseconds poll_phase{100'000};  ///< USB frames against the first sample
    };
    explicit Dk2Firmware(const Settings& settings);

    /// Does everything that happens up to and at `until`; reports go out on `wire`.
    void advance(HostTime until, ReportWire& wire);
    /// When something happens next.
    HostTime next_event() const;

    /// The first flash of the LEDs that starts after `t`, as they are set now.
    std::optional<LedFlash> flash_after(HostTime t) const;

    Status set(Bytes report, HostTime now);
    Result<std::vector<std::byte>> get(std::uint8_t id) { return features_.get(id); }

  private:
    void sample();
    void poll(ReportWire& wire);
    void queue_if_due(HostTime now);
    std::vector<std::byte> report11(const SamplePacker::Packed& packed, HostTime now);
    std::vector<std::byte> report1(const SamplePacker::Packed& packed) const;
    void fill_panel(dk2::InputReport11& report, HostTime now);
    void fill_tracking(dk2::InputReport11& report, HostTime now) const;
    std::uint32_t stamp_us(HostTime t) const;
    HostTime sample_time(std::uint64_t index) const;
    HostTime first_poll_after(HostTime t) const;
    std::int16_t temperature_centi_c(HostTime now) const;

    Settings settings_;
    ImuModel imu_;
    FeatureBank features_;
    SimulatedDeviceClock clock_;
    SamplePacker packer_;
    motion::Draws jitter_, stamps_;
    std::uint64_t samples_ = 0;
    std::uint64_t reports_ = 0;
    HostTime next_sample_;
    std::optional<std::vector<std::byte>> endpoint_;  // waits for the host's next poll
    HostTime next_poll_{};
    std::uint8_t grey_ = 0;
};

}  // namespace foverig
