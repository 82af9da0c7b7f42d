#include "simulators/dk2/feature_bank.h"

#include <fmt/format.h>

#include <algorithm>

#include "devices/dk2/identity_reports.h"
#include "devices/dk2/led_reports.h"
#include "simulators/dk2/led_table.h"

namespace foverig {
namespace {

constexpr std::size_t kBins = 7, kSamplesPerBin = 5;  // of the temperature table
constexpr std::int16_t kFirstBin_centi_c = 1500, kBinWidth_centi_c = 500;
constexpr std::uint32_t kStored_unix_s = 1405123200;  // any time but 0, which is never
// As of a device that never went through a factory, the serial is the UUID's beginning.
constexpr const char* kUuid = "FOVERIGSIM01AAAAAAAA";

/// The smallest of a chip's ranges that holds `asked`, or its largest.
template <class T>
T next_range(const std::array<T, 4>& ranges, T asked) {
    const auto found = std::lower_bound(ranges.begin(), ranges.end(), asked);
    return found == ranges.end() ? ranges.back() : *found;
}

dk2::RangeReport rounded_up(dk2::RangeReport asked) {
    asked.accel_g = next_range<std::uint8_t>({2, 4, 8, 16}, asked.accel_g);
    asked.gyro_deg_s = next_range<std::uint16_t>({250, 500, 1000, 2000}, asked.gyro_deg_s);
    asked.mag_milligauss =
        next_range<std::uint16_t>({4000, 8000, 12000, 16000}, asked.mag_milligauss);
    return asked;
}

std::size_t step(std::size_t& next, std::size_t count) {
    const std::size_t now = next;
    next = (now + 1) % count;
    return now;
}

/// Stores a report that decodes; its text is the decoder's otherwise.
template <class Report>
Status store(Report& kept, Bytes report) {
    auto decoded = Report::decode(report);
    if (!decoded) return decoded.error();
    kept = *decoded;
    return Done{};
}

dk2::PositionReport position(std::size_t index) {
    dk2::PositionReport report;
    report.index = static_cast<std::uint16_t>(index);
    report.count = kLedTable.size() + 1;
    if (index == kLedTable.size()) {
        report.position_um = kImuPosition_um;
        report.kind = dk2::PositionReport::Kind::imu;
    } else {
        report.position_um = kLedTable[index].position_um;
        report.normal = kLedTable[index].normal;
    }
    return report;
}

dk2::PatternReport pattern(std::size_t index) {
    return {.sequence = dk2::PatternReport::sequence_of(kLedTable[index].code),
            .index = static_cast<std::uint16_t>(index),
            .count = kLedTable.size()};
}

}  // namespace

/// Where offsets were stored, each bin's first sample holds one, at its target.
dk2::TemperatureReport FeatureBank::temperature_cell(std::size_t cell) const {
    const auto bin = static_cast<std::uint8_t>(cell / kSamplesPerBin);
    dk2::TemperatureReport report{
        .bins = kBins,
        .bin = bin,
        .samples_per_bin = kSamplesPerBin,
        .sample = static_cast<std::uint8_t>(cell % kSamplesPerBin),
        .target_centi_c = static_cast<std::int16_t>(kFirstBin_centi_c + bin * kBinWidth_centi_c)};
    if (!stored_offset_ || report.sample > 0) return report;
    report.version = 2;
    report.actual_centi_c = report.target_centi_c;
    report.unix_time_s = kStored_unix_s;
    report.gyro_offset = dk2::from_si(stored_offset_(0.01 * report.actual_centi_c));
    return report;
}

bool FeatureBank::alive(HostTime now) const {
    return !config_.command_keep_alive ||
           now - last_set_ < std::chrono::milliseconds(keep_alive_.timeout_ms);
}

Status FeatureBank::set(Bytes report, HostTime now) {
    if (report.size() < 3) {
        return Error{ErrorCode::invalid_data,
                     fmt::format("a DK2 feature report of {} bytes has no header", report.size())};
    }
    Status status = Done{};
    switch (read_u8(report, 0)) {
        case dk2::ConfigReport::kId:
            status = store(config_, report);
            config_.sample_rate_hz = 1000;
            break;
        case dk2::RangeReport::kId:
            status = store(range_, report);
            range_ = rounded_up(range_);
            break;
        case dk2::RegisterReport::kId:
            status = store(register_, report);
            break;
        case dk2::Dk1KeepAliveReport::kId: {
            dk2::Dk1KeepAliveReport old_format;
            status = store(old_format, report);
            if (!status) break;
            keep_alive_.timeout_ms = old_format.timeout_ms;
            // The firmware's own quirk: this also selects the DK1's input report.
            input_report_ = dk2::InputReport1::kId;
            break;
        }
        case dk2::TrackingReport::kId:
            status = store(tracking_, report);
            if (status) tracking_since_ = now;
            break;
        case dk2::DisplayReport::kId: {
            const dk2::DisplayReport before = display_;
            status = store(display_, report);
            display_.shutter = before.shutter;
            display_.pixel_settle_us = before.pixel_settle_us;
            display_.total_rows = before.total_rows;
            break;
        }
        case dk2::KeepAliveMuxReport::kId:
            status = store(keep_alive_, report);
            if (status) input_report_ = keep_alive_.input_report == 1 ? 1 : 11;
            break;
        default:
            return Error{ErrorCode::unsupported,
                         fmt::format("the simulated DK2 does not take feature report {}",
                                     read_u8(report, 0))};
    }
    if (!status) return status;
    last_set_ = now;
    last_command_id_ = read_u16(report, 1);
    return status;
}

Result<std::vector<std::byte>> FeatureBank::get(std::uint8_t id) {
    auto answered = answer(id);
    if (!answered) return answered;
    std::vector<std::byte> report = std::move(answered).value();
    write_u16(report, 1, last_command_id_);
    return report;
}

Result<std::vector<std::byte>> FeatureBank::answer(std::uint8_t id) {
    switch (id) {
        case dk2::ConfigReport::kId:
            return to_vector(config_.encode());
        case dk2::FactoryCalibrationReport::kId:
            return to_vector(factory_.encode());
        case dk2::RangeReport::kId:
            return to_vector(range_.encode());
        case dk2::RegisterReport::kId:
            return to_vector(register_.encode());
        case dk2::Dk1KeepAliveReport::kId:
            return to_vector(
                dk2::Dk1KeepAliveReport{.timeout_ms = keep_alive_.timeout_ms}.encode());
        case dk2::DisplayInfoReport::kId:
            return to_vector(dk2::DisplayInfoReport{}.encode());
        case dk2::SerialReport::kId:
            return to_vector(dk2::SerialReport{.serial = kUuid}.encode());
        case dk2::TrackingReport::kId:
            return to_vector(tracking_.encode());
        case dk2::DisplayReport::kId:
            return to_vector(display_.encode());
        case dk2::MagCalibrationReport::kId:
            return to_vector(dk2::MagCalibrationReport{}.encode());
        case dk2::PositionReport::kId:
            return to_vector(position(step(next_position_, kLedTable.size() + 1)).encode());
        case dk2::PatternReport::kId:
            return to_vector(pattern(step(next_pattern_, kLedTable.size())).encode());
        case dk2::KeepAliveMuxReport::kId:
            return to_vector(keep_alive_.encode());
        case dk2::ManufacturingReport::kId: {
            dk2::ManufacturingReport never_made;
            never_made.stage = static_cast<std::uint8_t>(step(next_stage_, never_made.stages));
            return to_vector(never_made.encode());
        }
        case dk2::UuidReport::kId:
            return to_vector(dk2::UuidReport{.uuid = kUuid}.encode());
        case dk2::TemperatureReport::kId:
            return to_vector(temperature_cell(step(next_cell_, kBins * kSamplesPerBin)).encode());
        case dk2::GyroOffsetReport::kId:
            return to_vector(dk2::GyroOffsetReport{}.encode());
        case dk2::LensDistortionReport::kId:
            return to_vector(dk2::LensDistortionReport{}.encode());
        default:
            return Error{ErrorCode::unsupported,
                         fmt::format("the simulated DK2 does not answer feature report {}", id)};
    }
}

}  // namespace foverig
