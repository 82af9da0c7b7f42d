#include "simulators/dk2/feature_bank.h"

#include <fmt/format.h>

#include "devices/dk2/led_reports.h"
#include "simulators/dk2/led_table.h"

namespace foverig {
namespace {

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
    switch (id) {
        case dk2::ConfigReport::kId:
            return to_vector(config_.encode());
        case dk2::FactoryCalibrationReport::kId:
            return to_vector(dk2::FactoryCalibrationReport{}.encode());
        case dk2::RangeReport::kId:
            return to_vector(range_.encode());
        case dk2::DisplayInfoReport::kId:
            return to_vector(dk2::DisplayInfoReport{}.encode());
        case dk2::SerialReport::kId:
            return to_vector(dk2::SerialReport{0, "FOVERIGSIM01"}.encode());
        case dk2::TrackingReport::kId:
            return to_vector(tracking_.encode());
        case dk2::DisplayReport::kId:
            return to_vector(display_.encode());
        case dk2::PositionReport::kId: {
            const std::size_t index = next_position_;
            next_position_ = (index + 1) % (kLedTable.size() + 1);
            return to_vector(position(index).encode());
        }
        case dk2::PatternReport::kId: {
            const std::size_t index = next_pattern_;
            next_pattern_ = (index + 1) % kLedTable.size();
            return to_vector(pattern(index).encode());
        }
        case dk2::KeepAliveMuxReport::kId:
            return to_vector(keep_alive_.encode());
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
