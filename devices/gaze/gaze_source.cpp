#include "devices/gaze/gaze_source.h"

#include <fmt/format.h>

#include <algorithm>

namespace foverig::gaze {
namespace {

constexpr std::size_t kKeptEvents = 64;
constexpr Nanoseconds kSetUpPause{250'000'000};  // between two tries with a tracker that came back
constexpr std::uint64_t kLatestNs = std::uint64_t{1}
                                    << 62;  // 146 years: beyond it a stamp is noise

std::uint16_t rate_bit(std::uint16_t rate_hz) {
    switch (rate_hz) {
        case 60:
            return 1;
        case 120:
            return 2;
        case 250:
            return 4;
        default:
            return 0;
    }
}

GazeTime time_of(std::uint64_t ns) {
    return GazeTime(Nanoseconds(static_cast<std::int64_t>(ns)));
}

/// "60, 250 Hz".
std::string rates_text(std::uint16_t rates) {
    std::string text;
    for (const std::uint16_t rate_hz : std::initializer_list<std::uint16_t>{60, 120, 250}) {
        if ((rates & rate_bit(rate_hz)) == 0) continue;
        text += fmt::format("{}{}", text.empty() ? "" : ", ", rate_hz);
    }
    return text.empty() ? "none that SGZ1 knows" : text + " Hz";
}

std::optional<Error> unfit(const StoredCalibration& calibration, const Info& info) {
    if (calibration.serial != info.serial) {
        return Error{ErrorCode::invalid_data,
                     fmt::format("the calibration is of tracker {}, and this is {}; calibrate this "
                                 "one (foverig calibrate)",
                                 calibration.serial, info.serial)};
    }
    if ((info.capabilities & capability::save_calibration) == 0) {
        return Error{ErrorCode::unsupported,
                     "the tracker takes no calibration from a file; calibrate it each time that it "
                     "is plugged in (foverig calibrate)"};
    }
    return std::nullopt;
}

bool times_are_sane(const SampleFrame& f) {
    return f.exposure_ns <= f.header.queued_ns;
}

}  // namespace

GazeSource::GazeSource(Transport& transport, const Clock& clock, const Info& info,
                       const GazeSourceConfig& config)
    : transport_(&transport),
      clock_(&clock),
      config_(config),
      info_(info),
      clock_map_(config.clock_map),
      next_sync_(clock.now()) {}

Result<GazeSource> GazeSource::open(Transport& transport, const Clock& clock,
                                    const GazeSourceConfig& config) {
    const auto bytes = transport.control_get(request::get_info, 0, Info::kSize);
    if (!bytes) return bytes.error();
    const auto info = Info::decode(*bytes);
    if (!info) return info.error();
    if (info->major != FrameHeader::kMajor) {
        return Error{ErrorCode::unsupported,
                     fmt::format("gaze tracker speaks version {}, expected 1", info->major)};
    }
    if (config.rate_hz != 0 && (info->rates & rate_bit(config.rate_hz)) == 0) {
        return Error{ErrorCode::unsupported,
                     fmt::format("the tracker has no rate of {} Hz; expected one of its own: {}",
                                 config.rate_hz, rates_text(info->rates))};
    }
    if (config.calibration) {
        if (auto reason = unfit(*config.calibration, *info)) return *reason;
    }
    GazeSource source(transport, clock, *info, config);
    if (auto s = source.set_up(); !s) return s.error();
    return source;
}

Status GazeSource::set_up() {
    // A tracker left streaming by someone else would refuse a new rate.
    if (auto s = stop(); !s) return s;
    if (config_.rate_hz != 0) {
        if (auto s = transport_->control_set(request::set_rate, config_.rate_hz, {}); !s) return s;
    }
    if (auto s = transport_->control_set(request::set_options, 0, encode_options(config_.options));
        !s)
        return s;
    if (auto s =
            transport_->control_set(request::set_mapping, 0, encode_mapping(config_.mapping_mm));
        !s)
        return s;
    if (config_.calibration) {
        if (auto s = transport_->control_set(request::cal_blob, 0, config_.calibration->blob); !s)
            return s;
    }
    return transport_->control_set(request::start, 0, {});
}

/// A tracker that comes back is idle, at its own rate.
void GazeSource::set_up_again() {
    if (!next_set_up_ || clock_->now() < *next_set_up_) return;
    const Status status = set_up();
    if (status) {
        next_set_up_.reset();
        return;
    }
    failed_requests_.count(status.error());
    next_set_up_ = clock_->now() + kSetUpPause;
}

Status GazeSource::stop() {
    return transport_->control_set(request::stop, 0, {});
}

Next<GazeSample> GazeSource::next(HostTime deadline) {
    while (ready_.empty()) {
        if (clock_->now() >= next_sync_) sync_time();
        NextPacket got = transport_->next(deadline);
        if (const auto* packet = std::get_if<Packet>(&got)) {
            set_up_again();
            take(*packet);
        } else if (std::holds_alternative<Timeout>(got)) {
            set_up_again();
            return Timeout{};
        } else if (auto* fault = std::get_if<Fault>(&got)) {
            if (!next_set_up_) next_set_up_ = clock_->now();
            return std::move(*fault);
        } else {
            return EndOfStream{};
        }
    }
    return ready_.pop_front();
}

void GazeSource::take(const Packet& packet) {
    const Result<Frame> frame = decode_frame(packet.bytes);
    if (!frame) {
        ++counts_.rejected;
        return;
    }
    const FrameHeader& header =
        std::visit([](const auto& f) -> const FrameHeader& { return f.header; }, *frame);
    const auto* sample = std::get_if<SampleFrame>(&*frame);
    if (header.queued_ns >= kLatestNs || (sample && !times_are_sane(*sample))) {
        ++counts_.rejected;
        return;
    }
    const FrameSequence::Step step = sequence_.advance(header);
    if (!step.accepted) {
        ++counts_.rejected;
        return;
    }
    if (step.new_session) {
        ++counts_.reconnects;
        last_camera_frame_.reset();
    }
    counts_.lost += step.lost;
    gap_before_next_sample_ |=
        step.lost > 0 || step.new_session || (header.flags & frame_flag::discontinuity) != 0;
    follow_clock(header, packet.arrival);

    if (sample) {
        take_sample(*sample, packet.arrival, gap_before_next_sample_);
        gap_before_next_sample_ = false;
    } else if (const auto* event = std::get_if<EventFrame>(&*frame)) {
        events_.push_back(*event);
        if (events_.size() > kKeptEvents) (void)events_.pop_front();
    } else if (const auto* calibration = std::get_if<CalibrationFrame>(&*frame)) {
        calibrations_.push_back(*calibration);
        if (calibrations_.size() > kKeptEvents) (void)calibrations_.pop_front();
    }
}

void GazeSource::follow_clock(const FrameHeader& header, HostTime arrival) {
    // Stamps do not run back, so that one which does says the clock began anew, flagged or not.
    if ((header.flags & frame_flag::clock_reset) != 0 || header.queued_ns < last_queued_ns_)
        clock_map_.reset();
    last_queued_ns_ = header.queued_ns;
    clock_map_.update(time_of(header.queued_ns), arrival);
}

void GazeSource::take_sample(const SampleFrame& frame, HostTime arrival, bool gap) {
    if (last_camera_frame_) {
        const std::uint32_t ahead = frame.camera_frame - *last_camera_frame_;
        if (ahead > 0 && ahead < 1u << 31) missed_exposures_ += ahead - 1;
    }
    last_camera_frame_ = frame.camera_frame;
    dropped_by_device_ = frame.dropped_by_device;
    GazeSample& s = ready_.push_back(to_sample(frame));
    s.host_time = clock_map_.to_host(s.device_time);
    s.arrival = arrival;
    s.gap = gap;
    ++counts_.samples;
}

// Host = middle of the round trip, kept only for the shortest quarter of trips (DEVICES.md 4.5.6).
void GazeSource::sync_time() {
    next_sync_ = clock_->now() + config_.time_sync_period;
    const HostTime before = clock_->now();
    const auto bytes =
        transport_->control_get(request::get_time, ++cookie_, DeviceTimeReply::kSize);
    const HostTime after = clock_->now();
    if (!bytes) {
        failed_requests_.count(bytes.error());
        return;
    }
    const auto reply = DeviceTimeReply::decode(*bytes);
    if (!reply || reply->cookie != cookie_ || reply->device_ns >= kLatestNs) {
        ++failed_requests_.refused;
        return;
    }
    const Nanoseconds trip = after - before;
    round_trips_[trips_++ % round_trips_.size()] = trip;
    const std::size_t kept = std::min(trips_, round_trips_.size());
    auto sorted = round_trips_;
    const auto quarter = sorted.begin() + (kept - 1) / 4;
    std::nth_element(sorted.begin(), quarter, sorted.begin() + kept);
    if (trip <= *quarter) clock_map_.update(time_of(reply->device_ns), before + trip / 2);
}

std::vector<EventFrame> GazeSource::take_events() {
    return events_.take();
}

std::vector<CalibrationFrame> GazeSource::take_calibrations() {
    return calibrations_.take();
}

}  // namespace foverig::gaze
