#pragma once
// The tracker's processor: exposes, measures, queues and numbers frames in the order of time
// (DEVICES.md 4.5). Knows nothing of the host but its requests.
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "devices/gaze/requests.h"
#include "devices/transport.h"
#include "simulators/faults/device_clock.h"
#include "simulators/gaze/point_procedure.h"
#include "simulators/gaze/tracker_model.h"

namespace foverig {

class GazeFirmware {
  public:
    static constexpr Nanoseconds kLatency{12'000'000};  ///< mid-exposure to queue (5.5)
    static constexpr Nanoseconds kUsbTransfer{1'000'000};
    static constexpr Nanoseconds kHeartbeatPeriod{1'000'000'000};

    struct Settings {
        const motion::EyeMotion* eyes = nullptr;  ///< outlives the device
        GazeFaults faults{};
        std::uint64_t seed = 0;
        HostTime plugged_in{};
    };
    explicit GazeFirmware(const Settings& settings);

    /// Does everything that happens up to and at `until`; packets join `wire` in order of arrival.
    void advance(HostTime until, std::deque<Packet>& wire);
    /// When something happens next; far away while idle.
    HostTime next_event() const;

    Status set(std::uint8_t request, std::uint16_t value, Bytes data, HostTime now);
    Result<std::vector<std::byte>> get(std::uint8_t request, std::uint16_t value, HostTime now);

  private:
    struct Queued {
        HostTime at;
        gaze::SampleFrame frame;
        PointProcedure::Sight raw;
    };
    struct QueuedCalibration {
        HostTime at;
        gaze::CalibrationFrame frame;
    };
    /// SIM_FAULT's orders that are still to be carried out.
    struct Orders {
        int drop = 0, spoil = 0, repeat = 0;
        int stall = 0;  ///< requests
        HostTime eyes_lost_until{}, blink_until{};
        std::optional<Side> blink_of{};  ///< none: of both eyes
    };

    static Error stall(const std::string& why);
    bool stalls_as_ordered();
    void drift(double ppm, HostTime now);
    std::optional<gaze::EyeCause> unseen(HostTime now) const;
    bool running() const;
    Status start(HostTime now);
    void stop();
    Status set_rate(std::uint16_t hz);
    Status order(const gaze::SimFault& fault, HostTime now);
    Status order_blink(const gaze::SimFault& fault, HostTime now);
    Status start_calibration(std::uint16_t points, Bytes data, HostTime now);
    Status validate(std::uint16_t points, Bytes data, HostTime now);
    Status accept_point(Bytes data, HostTime now);
    Status abort_points(HostTime now);
    Status set_calibration(Bytes data);
    gaze::CalibrationBlob calibration() const;
    void begin_points(PointProcedure::Kind kind, std::vector<gaze::Vec2f> targets_px, HostTime now);
    void forget_calibration();
    void follow_points(const Queued& queued);
    void tell_points(HostTime now);
    void expose();
    void queue_sample(std::deque<Packet>& wire);
    void queue_heartbeat(std::deque<Packet>& wire);
    void queue_calibration(std::deque<Packet>& wire);
    void jump_clock(Nanoseconds step);
    HostTime exposure_time(std::uint64_t index) const;
    Nanoseconds latency(std::uint64_t index) const;
    gaze::FrameHeader header(HostTime queued_at);
    void send(std::vector<std::byte> bytes, HostTime queued_at, std::deque<Packet>& wire);
    bool happens(double chance, std::uint64_t stream) const;

    Settings settings_;
    SimulatedDeviceClock clock_;
    TrackerModel tracker_;
    gaze::DeviceStatus status_;
    Orders orders_;
    std::uint16_t rate_hz_ = 60;
    std::uint32_t sessions_ = 0;
    std::uint64_t exposures_ = 0;  // since START
    std::uint32_t sequence_ = 0;
    std::uint8_t next_flags_ = 0;
    HostTime started_{}, next_heartbeat_{};
    std::optional<HostTime> clock_jump_at_;
    std::deque<Queued> measured_;  // on their way through the tracker
    std::optional<PointProcedure> points_;
    std::uint16_t calibrations_ = 0;  // ids given out
    std::deque<QueuedCalibration> told_;
};

}  // namespace foverig
