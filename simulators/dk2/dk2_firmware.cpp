#include "simulators/dk2/dk2_firmware.h"

#include <algorithm>
#include <cmath>

namespace foverig {
namespace {

constexpr Nanoseconds kUsbFrame{1'000'000};
constexpr double kStampAtPlugIn_s = 2.0;
constexpr double kStampWrap_s = 4294.967296;
constexpr std::uint32_t kBackwards_us = 3000;
constexpr int kPatternFrames = 10;

SimulatedDeviceClock device_clock(const Dk2Firmware::Settings& s) {
    return SimulatedDeviceClock(
        {.start = s.plugged_in,
         .start_s = s.faults.wrap > 0.0 ? kStampWrap_s - s.faults.wrap : kStampAtPlugIn_s,
         .drift_ppm = s.faults.clock_drift,
         .wander_ppm = s.faults.clock_wander},
        s.seed);
}

FeatureBank::StoredOffset stored_offset(const Dk2Faults& faults, const ImuModel& imu) {
    if (faults.temperature_table <= 0.0) return {};
    return [imu](double celsius) { return imu.gyro_at_rest_rad_s(celsius); };
}

// The firmware shows the pattern's frame first and steps on after it.
std::uint8_t pattern_of(const dk2::TrackingReport& tracking, std::int64_t exposures) {
    if (!tracking.auto_increment || tracking.pattern == 0xFF) return tracking.pattern;
    return static_cast<std::uint8_t>((tracking.pattern + exposures - 1) % kPatternFrames);
}

}  // namespace

Dk2Firmware::Dk2Firmware(const Settings& settings)
    : settings_(settings),
      imu_(settings.faults, settings.seed),
      features_(settings.plugged_in, imu_.factory().report(), stored_offset(settings.faults, imu_)),
      clock_(device_clock(settings)),
      jitter_(settings.seed, 610),
      stamps_(settings.seed, 611),
      next_sample_(sample_time(0)) {}

HostTime Dk2Firmware::sample_time(std::uint64_t index) const {
    const double period_ns = 1e6 * (1.0 + 1e-6 * settings_.faults.rate_error);
    HostTime t = settings_.plugged_in +
                 Nanoseconds(std::llround(static_cast<double>(index + 1) * period_ns));
    if (settings_.faults.jitter > 0.0) {
        t += from_seconds(1e-6 * settings_.faults.jitter * jitter_.uniform(index, -1.0, 1.0));
    }
    return t;
}

HostTime Dk2Firmware::first_poll_after(HostTime t) const {
    const Nanoseconds since = t - settings_.plugged_in - settings_.poll_phase;
    const std::int64_t frames = since.count() < 0 ? 0 : since / kUsbFrame + 1;
    return settings_.plugged_in + settings_.poll_phase + frames * kUsbFrame;
}

HostTime Dk2Firmware::next_event() const {
    return endpoint_ ? std::min(next_sample_, next_poll_) : next_sample_;
}

void Dk2Firmware::advance(HostTime until, ReportWire& wire) {
    while (next_event() <= until) {
        if (endpoint_ && next_poll_ <= next_sample_) {
            poll(wire);
        } else {
            sample();
        }
    }
}

void Dk2Firmware::sample() {
    const HostTime now = next_sample_;
    auto slot = imu_.measure(settings_.head->at(to_seconds(now.time_since_epoch())), samples_,
                             to_seconds(now - settings_.plugged_in), features_.range());
    if (features_.config().use_calibration) slot = imu_.factory().corrected(slot);
    packer_.add(slot, static_cast<std::uint16_t>(samples_), stamp_us(now));
    next_sample_ = sample_time(++samples_);
    queue_if_due(now);
}

void Dk2Firmware::poll(ReportWire& wire) {
    wire.send(std::move(*endpoint_), next_poll_);
    endpoint_.reset();
    queue_if_due(next_poll_);
}

void Dk2Firmware::queue_if_due(HostTime now) {
    if (endpoint_ || packer_.pending() <= features_.config().interval || !features_.alive(now)) {
        return;
    }
    const SamplePacker::Packed packed = packer_.packed();
    ++reports_;
    endpoint_ = features_.input_report() == dk2::InputReport1::kId ? report1(packed)
                                                                   : report11(packed, now);
    packer_.clear();
    next_poll_ = first_poll_after(now);
}

Status Dk2Firmware::set(Bytes report, HostTime now) {
    Status status = features_.set(report, now);
    if (status && read_u8(report, 0) == dk2::ConfigReport::kId) packer_.clear();
    return status;
}

std::uint32_t Dk2Firmware::stamp_us(HostTime t) const {
    return static_cast<std::uint32_t>((clock_.at_ns(t) + 500) / 1000);
}

std::int16_t Dk2Firmware::temperature_centi_c(HostTime now) const {
    const double celsius = imu_.temperature_c(to_seconds(now - settings_.plugged_in));
    return static_cast<std::int16_t>(std::lround(100.0 * celsius));
}

std::vector<std::byte> Dk2Firmware::report11(const SamplePacker::Packed& packed, HostTime now) {
    dk2::InputReport11 report;
    report.last_command_id = features_.last_command_id();
    report.num_samples = packed.num_samples;
    report.sample_count = packed.sample_count;
    report.temperature_centi_c = temperature_centi_c(now);
    report.sample_timestamp_us = packed.newest_stamp_us;
    if (stamps_.uniform(reports_) < settings_.faults.backwards_stamp) {
        report.sample_timestamp_us -= kBackwards_us;
    }
    report.slots = packed.slots;
    fill_panel(report, now);
    fill_tracking(report, now);
    return to_vector(report.encode());
}

std::vector<std::byte> Dk2Firmware::report1(const SamplePacker::Packed& packed) const {
    dk2::InputReport1 report;
    report.num_samples = packed.num_samples;
    report.sample_count = packed.sample_count;
    report.last_command_id = features_.last_command_id();
    report.temperature_centi_c = temperature_centi_c(next_sample_);
    report.slots = {packed.slots[0], packed.slots[1], {}};
    // Three slots here: with more than two samples the mean stands for the first two of them.
    if (packed.num_samples > 2) report.slots = {packed.slots[0], packed.slots[0], packed.slots[1]};
    return to_vector(report.encode());
}

void Dk2Firmware::fill_panel(dk2::InputReport11& report, HostTime now) {
    if (settings_.panel == nullptr) return;
    const auto reading = settings_.panel->reading_at(now, features_.display().read_pixel);
    if (!reading) return;
    if (reading->grey) grey_ = *reading->grey;
    report.frame_count = reading->frame_count;
    report.frame_timestamp_us = stamp_us(reading->vsync);
    report.frame_id = grey_;
}

void Dk2Firmware::fill_tracking(dk2::InputReport11& report, HostTime now) const {
    const dk2::TrackingReport& tracking = features_.tracking();
    report.tracking_pattern = tracking.pattern;
    if (!tracking.enable || tracking.frame_interval_us == 0) return;
    // Each exposure follows the last at a fixed interval from the SET that enabled the LEDs.
    const auto interval = std::chrono::microseconds(tracking.frame_interval_us);
    const std::int64_t exposures = (now - features_.tracking_since()) / interval;
    if (exposures < 1) return;
    report.tracking_count = static_cast<std::uint16_t>(exposures);
    report.tracking_timestamp_us = stamp_us(features_.tracking_since() + exposures * interval);
    report.tracking_pattern = pattern_of(tracking, exposures);
}

std::optional<LedFlash> Dk2Firmware::flash_after(HostTime t) const {
    const dk2::TrackingReport& tracking = features_.tracking();
    if (!tracking.enable || tracking.frame_interval_us == 0) return std::nullopt;
    const auto interval = std::chrono::microseconds(tracking.frame_interval_us);
    const Nanoseconds since = std::max(Nanoseconds{0}, t - features_.tracking_since());
    const std::int64_t exposures = since / interval + 1;
    const HostTime start = features_.tracking_since() + exposures * interval;
    if (!features_.alive(start)) return std::nullopt;
    return LedFlash{.start = start,
                    .length = std::chrono::microseconds(tracking.exposure_us),
                    .pattern = pattern_of(tracking, exposures)};
}

}  // namespace foverig
