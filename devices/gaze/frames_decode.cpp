#include <fmt/format.h>

#include "devices/crc32.h"
#include "devices/gaze/detail/fields.h"
#include "devices/gaze/frames.h"

namespace foverig::gaze {
namespace {

using detail::read_floats;

constexpr std::size_t kCrcSize = 4;

template <class... Args>
Error bad_frame(fmt::format_string<Args...> text, Args&&... args) {
    return {ErrorCode::invalid_data,
            "gaze frame: " + fmt::format(text, std::forward<Args>(args)...)};
}

FrameHeader read_header(Bytes b) {
    return {.flags = read_u8(b, 7),
            .sequence = read_u32(b, 12),
            .queued_ns = read_u64(b, 16),
            .session = read_u32(b, 24)};
}

EyeBlock read_eye(Bytes b) {
    return {.base_point_mm = read_floats<3>(b, 0),
            .direction = read_floats<3>(b, 12),
            .por_px = read_floats<2>(b, 24),
            .pupil_mm = read_floats<3>(b, 32),
            .pupil_radius_mm = read_f32(b, 44),
            .lens_distance_mm = read_f32(b, 48),
            .screen_distance_mm = read_f32(b, 52),
            .openness = read_f32(b, 56),
            .confidence = read_f32(b, 60),
            .state = static_cast<EyeState>(read_u8(b, 64)),
            .cause = static_cast<EyeCause>(read_u8(b, 65))};
}

SampleFrame read_sample(Bytes b) {
    return {.header = read_header(b),
            .exposure_ns = read_u64(b, 32),
            .camera_frame = read_u32(b, 40),
            .rate_decihertz = read_u16(b, 44),
            .status = read_u16(b, 46),
            .iod_mm = read_f32(b, 48),
            .ipd_mm = read_f32(b, 52),
            .base_point_mm = read_floats<3>(b, 56),
            .direction = read_floats<3>(b, 68),
            .por_px = read_floats<2>(b, 80),
            .left = read_eye(b.subspan(88, EyeBlock::kSize)),
            .right = read_eye(b.subspan(156, EyeBlock::kSize)),
            .mapping_distance_mm = read_f32(b, 224),
            .vergence_distance_mm = read_f32(b, 228),
            .temperature_centi_c = read_s16(b, 232),
            .calibration_id = read_u16(b, 234),
            .calibration_points = read_u8(b, 236),
            .calibration_quality = read_u8(b, 237),
            .dropped_by_device = read_u32(b, 240)};
}

EventFrame read_event(Bytes b) {
    return {.header = read_header(b),
            .start_ns = read_u64(b, 32),
            .end_ns = read_u64(b, 40),
            .kind = static_cast<EventKind>(read_u8(b, 48)),
            .eye = static_cast<EventEye>(read_u8(b, 49)),
            .phase = static_cast<EventPhase>(read_u8(b, 50)),
            .direction_at_start = read_floats<3>(b, 52),
            .direction_at_end = read_floats<3>(b, 64),
            .amplitude_deg = read_f32(b, 76),
            .peak_deg_s = read_f32(b, 80),
            .mean_por_px = read_floats<2>(b, 84),
            .first_camera_frame = read_u32(b, 92),
            .last_camera_frame = read_u32(b, 96)};
}

CalibrationFrame read_calibration(Bytes b) {
    return {.header = read_header(b),
            .calibration_id = read_u32(b, 32),
            .points = read_u8(b, 36),
            .current_point = read_u8(b, 37),
            .state = static_cast<CalibrationState>(read_u8(b, 38)),
            .reason = static_cast<CalibrationReason>(read_u8(b, 39)),
            .target_por_px = read_floats<2>(b, 40),
            .target_direction = read_floats<3>(b, 48),
            .accuracy_deg = read_floats<2>(b, 60),
            .precision_deg = read_floats<2>(b, 68)};
}

HeartbeatFrame read_heartbeat(Bytes b) {
    return {.header = read_header(b),
            .now_ns = read_u64(b, 32),
            .usb_sof = read_u32(b, 40),
            .samples_sent = read_u32(b, 44)};
}

template <class FrameOfType>
Result<Frame> body(Bytes b, std::uint8_t minor, FrameOfType (*read)(Bytes)) {
    const bool fits = minor > FrameHeader::kMinor ? b.size() >= FrameOfType::kSize
                                                  : b.size() == FrameOfType::kSize;
    if (!fits) {
        return bad_frame("type {} has {} bytes, expected {}", static_cast<int>(FrameOfType::kType),
                         b.size(), FrameOfType::kSize);
    }
    return Frame(read(b));
}

}  // namespace

Result<Frame> decode_frame(Bytes b) {
    if (b.size() < FrameHeader::kSize + kCrcSize)
        return bad_frame("{} bytes, less than a header", b.size());
    if (read_u32(b, 0) != detail::kMagic)
        return bad_frame("magic {:08x}, expected SGZ1", read_u32(b, 0));
    if (read_u8(b, 4) != FrameHeader::kMajor)
        return bad_frame("version {}, expected 1", read_u8(b, 4));
    if (read_u16(b, 8) != b.size())
        return bad_frame("{} bytes, header says {}", b.size(), read_u16(b, 8));
    if (read_u16(b, 10) != FrameHeader::kSize)
        return bad_frame("header of {} bytes, expected 32", read_u16(b, 10));
    const std::uint32_t stored = read_u32(b, b.size() - kCrcSize);
    const std::uint32_t computed = crc32(b.first(b.size() - kCrcSize));
    if (stored != computed) return bad_frame("CRC {:08x}, expected {:08x}", stored, computed);
    const std::uint8_t minor = read_u8(b, 5);
    switch (static_cast<FrameType>(read_u8(b, 6))) {
        case FrameType::sample:
            return body(b, minor, read_sample);
        case FrameType::event:
            return body(b, minor, read_event);
        case FrameType::calibration:
            return body(b, minor, read_calibration);
        case FrameType::heartbeat:
            return body(b, minor, read_heartbeat);
    }
    return bad_frame("unknown type {}", read_u8(b, 6));
}

}  // namespace foverig::gaze
