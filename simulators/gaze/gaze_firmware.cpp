#include "simulators/gaze/gaze_firmware.h"

#include <algorithm>
#include <cmath>

namespace foverig {
namespace {

using gaze::DeviceState;

constexpr double kClockAtPlugIn_s = 1000.0;  // another epoch than the host's and the DK2's
constexpr double kShortestLatency_ms = 8.0, kLongestLatency_ms = 30.0;
constexpr std::size_t kSpoiltByte = 40;

enum Stream : std::uint64_t { kLost = 810, kDropped, kSpoilt, kRepeated, kLatencyDraw };

}  // namespace

GazeFirmware::GazeFirmware(const Settings& settings)
    : settings_(settings),
      clock_({.start = settings.plugged_in,
              .start_s = kClockAtPlugIn_s,
              .drift_ppm = settings.faults.clock_drift},
             settings.seed),
      tracker_(*settings.eyes, settings.faults, settings.seed) {
    if (settings.faults.user > 0.0) return;  // a person whom it does not know
    calibrations_ = status_.calibration_id = 1;
    status_.calibration_points = 5;
}

bool GazeFirmware::running() const {
    return status_.state == DeviceState::streaming || status_.state == DeviceState::calibrating;
}

/// The cameras run on the device's clock, so a fast clock exposes early.
HostTime GazeFirmware::exposure_time(std::uint64_t index) const {
    const double period_s = 1.0 / (rate_hz_ * (1.0 + 1e-6 * settings_.faults.clock_drift));
    return started_ + from_seconds(static_cast<double>(index + 1) * period_s);
}

Nanoseconds GazeFirmware::latency(std::uint64_t index) const {
    const double jitter_ms = settings_.faults.latency_jitter;
    if (jitter_ms <= 0.0) return kLatency;
    const double median_ms = to_ms(kLatency);
    const double drawn_ms = motion::Draws(settings_.seed, kLatencyDraw)
                                .log_normal(index, median_ms, jitter_ms / median_ms);
    return from_seconds(1e-3 * std::clamp(drawn_ms, kShortestLatency_ms, kLongestLatency_ms));
}

HostTime GazeFirmware::next_event() const {
    if (!running()) return HostTime::max();
    HostTime next = std::min(exposure_time(exposures_), next_heartbeat_);
    if (!measured_.empty()) next = std::min(next, measured_.front().at);
    if (clock_jump_at_) next = std::min(next, *clock_jump_at_);
    if (!told_.empty()) next = std::min(next, told_.front().at);
    return next;
}

void GazeFirmware::advance(HostTime until, std::deque<Packet>& wire) {
    for (HostTime now = next_event(); now <= until && now != HostTime::max(); now = next_event()) {
        if (clock_jump_at_ && *clock_jump_at_ == now) {
            clock_jump_at_.reset();
            jump_clock(from_seconds(1e-3 * settings_.faults.time_jump));
        } else if (!told_.empty() && told_.front().at == now) {
            queue_calibration(wire);
        } else if (!measured_.empty() && measured_.front().at == now) {
            queue_sample(wire);
        } else if (next_heartbeat_ == now) {
            queue_heartbeat(wire);
        } else {
            expose();
        }
    }
}

/// Exposures go on from the next one, at the new rate.
void GazeFirmware::drift(double ppm, HostTime now) {
    const HostTime next = exposure_time(exposures_);
    settings_.faults.clock_drift = ppm;
    clock_.drift(now, ppm);
    started_ += next - exposure_time(exposures_);
}

std::optional<gaze::EyeCause> GazeFirmware::unseen(HostTime now) const {
    if (now < orders_.eyes_lost_until) return gaze::EyeCause::simulated_fault;
    if (now < orders_.blink_until && !orders_.blink_of) return gaze::EyeCause::blink;
    return std::nullopt;
}

void GazeFirmware::jump_clock(Nanoseconds step) {
    clock_.jump(step);
    next_flags_ |= gaze::frame_flag::clock_reset;
}

bool GazeFirmware::happens(double chance, std::uint64_t stream) const {
    return chance > 0.0 && motion::Draws(settings_.seed, stream)
                                   .uniform(exposures_ + (std::uint64_t{sessions_} << 40)) < chance;
}

void GazeFirmware::expose() {
    const HostTime now = exposure_time(exposures_);
    const bool low_pass = (status_.options & gaze::option::binocular_low_pass) != 0;
    gaze::SampleFrame frame =
        tracker_.measure(to_seconds(now.time_since_epoch()), rate_hz_, low_pass, unseen(now));
    std::optional<TrackerModel::Gaze> raw_deg = tracker_.raw_deg();
    if (now < orders_.blink_until && orders_.blink_of) {
        shut_eye(frame, *orders_.blink_of);
        raw_deg.reset();
    }
    const bool lost = happens(settings_.faults.lost_exposure, kLost);
    HostTime queue_at = now + latency(exposures_);
    if (!measured_.empty()) queue_at = std::max(queue_at, measured_.back().at);
    frame.camera_frame = static_cast<std::uint32_t>(++exposures_);
    if (lost) return;
    frame.exposure_ns = static_cast<std::uint64_t>(clock_.at_ns(now));
    frame.rate_decihertz = static_cast<std::uint16_t>(10 * rate_hz_);
    frame.mapping_distance_mm = status_.mapping_mm;
    if (std::isinf(status_.mapping_mm)) {
        frame.mapping_distance_mm = frame.vergence_distance_mm;
        frame.status |= gaze::sample_status::dynamic_mapping;
    }
    if (points_) frame.status |= gaze::sample_status::calibrating;
    if (status_.calibration_id == 0) frame.status |= gaze::sample_status::uncalibrated;
    frame.calibration_id = status_.calibration_id;
    frame.calibration_points = status_.calibration_points;
    frame.calibration_quality = status_.calibration_quality;
    measured_.push_back({queue_at, frame, {.exposed = now, .gaze_deg = raw_deg}});
}

gaze::FrameHeader GazeFirmware::header(HostTime queued_at) {
    gaze::FrameHeader header{
        .flags = static_cast<std::uint8_t>(gaze::frame_flag::simulated | next_flags_),
        .sequence = sequence_++,
        .queued_ns = static_cast<std::uint64_t>(clock_.at_ns(queued_at)),
        .session = status_.session};
    if ((status_.options & gaze::option::binocular_low_pass) != 0) {
        header.flags |= gaze::frame_flag::binocular_low_pass;
    }
    next_flags_ = 0;
    return header;
}

void GazeFirmware::queue_sample(std::deque<Packet>& wire) {
    Queued queued = measured_.front();
    measured_.pop_front();
    // What a sample ends is told before it: the host counts the same samples.
    follow_points(queued);
    while (!told_.empty()) queue_calibration(wire);
    queued.frame.header = header(queued.at);
    ++status_.sent;
    auto bytes = to_vector(queued.frame.encode());
    const auto ordered = [](int& count) { return count > 0 && count-- > 0; };
    const bool dropped = ordered(orders_.drop) || happens(settings_.faults.dropout, kDropped);
    const bool spoilt = ordered(orders_.spoil) || happens(settings_.faults.crc_error, kSpoilt);
    const bool repeated = ordered(orders_.repeat) || happens(settings_.faults.duplicate, kRepeated);
    if (dropped) return;
    if (spoilt) bytes[kSpoiltByte] ^= std::byte{1};
    if (repeated) send(bytes, queued.at, wire);
    send(std::move(bytes), queued.at, wire);
}

void GazeFirmware::queue_heartbeat(std::deque<Packet>& wire) {
    gaze::HeartbeatFrame frame;
    frame.header = header(next_heartbeat_);
    frame.now_ns = static_cast<std::uint64_t>(clock_.at_ns(next_heartbeat_));
    frame.samples_sent = status_.sent;
    send(to_vector(frame.encode()), next_heartbeat_, wire);
    next_heartbeat_ += kHeartbeatPeriod;
}

void GazeFirmware::queue_calibration(std::deque<Packet>& wire) {
    QueuedCalibration queued = told_.front();
    told_.pop_front();
    queued.frame.header = header(queued.at);
    send(to_vector(queued.frame.encode()), queued.at, wire);
}

void GazeFirmware::send(std::vector<std::byte> bytes, HostTime queued_at,
                        std::deque<Packet>& wire) {
    wire.push_back({queued_at + kUsbTransfer, std::move(bytes)});
}

}  // namespace foverig
