#include "devices/dk2/decoder.h"

#include <algorithm>

namespace foverig::dk2 {
namespace {

constexpr Nanoseconds kSampleInterval{1'000'000};
constexpr std::uint16_t kMostLost = 0x7FFF;  // of a 16-bit count: beyond it lies the past

Error refused(const char* why) {
    return {ErrorCode::invalid_data, std::string("DK2 report refused: ") + why};
}

}  // namespace

Result<DecodedReport> Dk2Decoder::decode(Bytes packet) {
    if (!packet.empty() && read_u8(packet, 0) == InputReport1::kId) return decode1(packet);
    return decode11(packet);
}

Result<DecodedReport> Dk2Decoder::decode11(Bytes packet) {
    const Result<InputReport11> report = InputReport11::decode(packet);
    if (!report) return report.error();
    const StampUnwrapper::Verdict verdict = stamps_.advance(report->sample_timestamp_us);
    if (verdict == StampUnwrapper::Verdict::duplicate) {
        ++duplicates_;
        return refused("same time stamp as the one before");
    }
    if (verdict == StampUnwrapper::Verdict::backwards) {
        ++backwards_;
        return refused("its time stamp runs backwards");
    }
    DecodedReport out;
    out.restarted = verdict == StampUnwrapper::Verdict::restarted;
    if (out.restarted) counting_ = false;
    out.lost = count(report->sample_count, report->num_samples);
    out.last_command_id = report->last_command_id;
    out.panel = {.frame_count = report->frame_count,
                 .vsync_device = stamps_.near(report->frame_timestamp_us),
                 .vsync = {},
                 .grey = report->frame_id};
    out.exposure = {.count = report->tracking_count,
                    .pattern = report->tracking_pattern,
                    .start_device = stamps_.near(report->tracking_timestamp_us),
                    .start = {}};
    expand(out, report->slots, report->num_samples, report->temperature_centi_c, stamps_.now());
    return out;
}

Result<DecodedReport> Dk2Decoder::decode1(Bytes packet) {
    const Result<InputReport1> report = InputReport1::decode(packet);
    if (!report) return report.error();
    if (!counting_) return refused("report 1 has no time, and no report 11 came before it");
    if (missing_before(report->sample_count) > kMostLost) {
        ++backwards_;
        return refused("its count of samples runs backwards");
    }
    DecodedReport out;
    out.is_report1 = true;
    out.lost = count(report->sample_count, report->num_samples);
    out.last_command_id = report->last_command_id;
    const Dk2Time newest = newest_ + (out.lost + report->num_samples) * kSampleInterval;
    expand(out, report->slots, report->num_samples, report->temperature_centi_c, newest);
    return out;
}

std::uint16_t Dk2Decoder::missing_before(std::uint16_t sample_count) const {
    return static_cast<std::uint16_t>(sample_count - static_cast<std::uint16_t>(next_sequence_));
}

std::uint16_t Dk2Decoder::count(std::uint16_t sample_count, std::uint8_t num_samples) {
    if (!counting_) {
        counting_ = true;
        // Of a device that started again, numbers still go up.
        const std::uint64_t epoch = (next_sequence_ + 0xFFFF) & ~std::uint64_t{0xFFFF};
        next_sequence_ = epoch + sample_count + num_samples;
        return 0;
    }
    const std::uint16_t lost = missing_before(sample_count);
    next_sequence_ += std::uint64_t{lost} + num_samples;
    return lost;
}

void Dk2Decoder::expand(DecodedReport& out, std::span<const InertialSlot> slots, int num_samples,
                        std::int16_t temperature_centi_c, Dk2Time newest) {
    const int last_slot = std::min<int>(num_samples, static_cast<int>(slots.size())) - 1;
    out.samples = std::move(spare_);
    out.samples.assign(static_cast<std::size_t>(num_samples), {});
    for (int k = 0; k < num_samples; ++k) {
        // Slot 0 stands for all samples that the other slots do not hold: it is their mean.
        const int before_newest = num_samples - 1 - k;
        const InertialSlot& slot =
            slots[static_cast<std::size_t>(std::max(0, last_slot - before_newest))];
        ImuSample& s = out.samples[static_cast<std::size_t>(k)];
        s.device_time = newest - before_newest * kSampleInterval;
        s.sequence = next_sequence_ - static_cast<std::uint64_t>(before_newest) - 1;
        s.accel_m_s2 = calibration_.accel(slot.accel);
        s.temperature_c = 0.01 * temperature_centi_c;
        s.gyro_rad_s = calibration_.gyro(slot.gyro, s.temperature_c);
    }
    out.samples.front().gap = out.lost > 0 || out.restarted;
    newest_ = newest;
}

}  // namespace foverig::dk2
