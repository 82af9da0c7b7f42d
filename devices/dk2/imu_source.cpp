#include "devices/dk2/imu_source.h"

#include "devices/dk2/detail/get_report.h"

namespace foverig::dk2 {
namespace {

using detail::get_report;

constexpr std::size_t kKeptReadbacks = 64, kKeptExposures = 256;  // 4 s of flashes
constexpr Nanoseconds kSetUpPause{250'000'000};  // between two tries with a headset that came back
constexpr Nanoseconds kCorrectionPause{100'000'000};  // reports in flight still have the old format

/// What LibOVR, OUVRT and OpenHMD ask of a DK2 for blinking LEDs (DEVICES.md 1.5).
const TrackingReport kBlinking{.enable = true,
                               .auto_increment = true,
                               .use_carrier = true,
                               .exposure_us = 350,
                               .frame_interval_us = 16666,
                               .duty = 0x7F};

template <class Report>
Status set(Transport& transport, Report report, std::uint16_t& command_id) {
    report.command_id = ++command_id;
    return transport.control_set(Report::kId, 0, report.encode());
}

}  // namespace

Dk2ImuSource::Dk2ImuSource(Transport& transport, HostTime now,
                           const FactoryCalibration& calibration, const ImuSourceConfig& config)
    : transport_(&transport),
      config_(config),
      calibration_(calibration),
      decoder_(calibration),
      clock_map_(config.clock_map),
      next_correction_(now) {}

Result<Dk2ImuSource> Dk2ImuSource::open(Transport& transport, HostTime now,
                                        const ImuSourceConfig& config) {
    const auto factory = get_report<FactoryCalibrationReport>(transport);
    if (!factory) return factory.error();
    FactoryCalibration calibration = FactoryCalibration::from(*factory);
    // A headset that tells none has the factory's offset at every temperature.
    if (auto offsets = read_gyro_offsets(transport, to_si(factory->gyro_offset))) {
        calibration.gyro_offsets = std::move(offsets).value();
    }
    Dk2ImuSource source(transport, now, calibration, config);

    if (auto status = source.set_up(); !status) return status.error();
    return source;
}

Status Dk2ImuSource::set_up() {
    const auto device_config = get_report<ConfigReport>(*transport_);
    if (!device_config) return device_config.error();
    ConfigReport wanted = *device_config;
    // LibOVR's choice for the DK2: raw values from the device, the matrix applied here in double.
    wanted.use_calibration = false;
    wanted.raw = false;
    wanted.sensor_coordinates = false;
    wanted.command_keep_alive = true;
    wanted.interval = config_.interval;
    if (auto status = set(*transport_, wanted, command_id_); !status) return status;

    // Another program may have left smaller ones, which clip a quick turn.
    if (auto status = set(*transport_, RangeReport{}, command_id_); !status) return status;

    const auto display = get_report<DisplayReport>(*transport_);
    if (!display) return display.error();
    DisplayReport panel = *display;
    panel.read_pixel = config_.read_pixel;
    panel.use_rolling = true;
    panel.persistence_rows = config_.persistence_rows;
    if (auto status = set(*transport_, panel, command_id_); !status) return status;

    if (config_.light_leds) {
        if (auto status = set(*transport_, kBlinking, command_id_); !status) return status;
    }
    const KeepAliveMuxReport report = awake();
    transport_->keep_awake(KeepAliveMuxReport::kId, report.encode(), config_.keep_alive_period);
    return transport_->control_set(KeepAliveMuxReport::kId, 0, report.encode());
}

KeepAliveMuxReport Dk2ImuSource::awake() {
    return {.command_id = ++command_id_, .timeout_ms = config_.keep_alive_timeout_ms};
}

/// A headset that comes back has forgotten what it was told.
void Dk2ImuSource::set_up_again(HostTime now) {
    if (!was_gone_ || now < next_set_up_) return;
    const Status status = set_up();
    was_gone_ = !status;
    if (status) return;
    failed_requests_.count(status.error());
    next_set_up_ = now + kSetUpPause;
}

Next<ImuSample> Dk2ImuSource::next(HostTime deadline) {
    while (ready_.empty()) {
        NextPacket got = transport_->next(deadline);
        if (const auto* packet = std::get_if<Packet>(&got)) {
            set_up_again(packet->arrival);
            take(*packet);
        } else if (std::holds_alternative<Timeout>(got)) {
            return Timeout{};
        } else if (auto* fault = std::get_if<Fault>(&got)) {
            was_gone_ = true;
            decoder_.expect_restart();
            return std::move(*fault);
        } else {
            return EndOfStream{};
        }
    }
    return ready_.pop_front();
}

void Dk2ImuSource::take(const Packet& packet) {
    Result<DecodedReport> decoded = decoder_.decode(packet.bytes);
    const bool is_report1 = !packet.bytes.empty() && read_u8(packet.bytes, 0) == InputReport1::kId;
    if (is_report1 && packet.arrival >= next_correction_) {
        ++format_switches_;
        next_correction_ = packet.arrival + kCorrectionPause;
        // Report 17 says which input report it wants, too.
        const auto report17 = awake().encode();
        const Status status = transport_->control_set(KeepAliveMuxReport::kId, 0, report17);
        if (!status) failed_requests_.count(status.error());
    }
    if (!decoded) {
        ++counts_.rejected;
        return;
    }
    if (decoded->restarted) {
        ++counts_.reconnects;
        clock_map_.reset();
    }
    counts_.lost += decoded->lost;
    counts_.samples += decoded->samples.size();
    // A time continued by count is no measurement of the device's clock.
    if (!is_report1) clock_map_.update(decoded->samples.back().device_time, packet.arrival);
    for (const ImuSample& decoded_sample : decoded->samples) {
        ImuSample& s = ready_.push_back(decoded_sample);
        s.host_time = clock_map_.to_host(s.device_time);
        s.arrival = packet.arrival;
    }
    if (!is_report1) {
        note_panel(decoded->panel);
        note_exposure(decoded->exposure);
    }
    decoder_.take_back(std::move(decoded).value());
}

void Dk2ImuSource::note_panel(PanelReadback panel) {
    if (panel_seen_ && panel.frame_count == last_frame_count_) return;
    panel_seen_ = true;
    last_frame_count_ = panel.frame_count;
    panel.vsync = clock_map_.to_host(panel.vsync_device);
    readbacks_.push_back(panel);
    if (readbacks_.size() > kKeptReadbacks) (void)readbacks_.pop_front();
}

void Dk2ImuSource::note_exposure(LedExposure exposure) {
    if (exposure.count == 0 || exposure.count == last_exposure_count_) return;
    last_exposure_count_ = exposure.count;
    exposure.start = clock_map_.to_host(exposure.start_device);
    exposures_.push_back(exposure);
    if (exposures_.size() > kKeptExposures) (void)exposures_.pop_front();
}

std::vector<LedExposure> Dk2ImuSource::take_exposures() {
    return exposures_.take();
}

std::vector<PanelReadback> Dk2ImuSource::take_panel_readbacks() {
    return readbacks_.take();
}

}  // namespace foverig::dk2
