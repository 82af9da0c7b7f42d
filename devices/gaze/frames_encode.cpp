#include "devices/crc32.h"
#include "devices/gaze/detail/fields.h"
#include "devices/gaze/frames.h"

namespace foverig::gaze {
namespace {

using detail::write_float;
using detail::write_floats;
using Out = std::span<std::byte>;

template <class FrameOfType>
std::array<std::byte, FrameOfType::kSize> begin(const FrameOfType& frame) {
    std::array<std::byte, FrameOfType::kSize> b{};
    write_u32(b, 0, detail::kMagic);
    write_u8(b, 4, FrameHeader::kMajor);
    write_u8(b, 5, FrameHeader::kMinor);
    write_u8(b, 6, static_cast<std::uint8_t>(FrameOfType::kType));
    write_u8(b, 7, frame.header.flags);
    write_u16(b, 8, static_cast<std::uint16_t>(FrameOfType::kSize));
    write_u16(b, 10, static_cast<std::uint16_t>(FrameHeader::kSize));
    write_u32(b, 12, frame.header.sequence);
    write_u64(b, 16, frame.header.queued_ns);
    write_u32(b, 24, frame.header.session);
    return b;
}

void finish(Out b) {
    write_u32(b, b.size() - 4, crc32(b.first(b.size() - 4)));
}

void write_eye(Out b, const EyeBlock& eye) {
    write_floats(b, 0, eye.base_point_mm);
    write_floats(b, 12, eye.direction);
    write_floats(b, 24, eye.por_px);
    write_floats(b, 32, eye.pupil_mm);
    write_float(b, 44, eye.pupil_radius_mm);
    write_float(b, 48, eye.lens_distance_mm);
    write_float(b, 52, eye.screen_distance_mm);
    write_float(b, 56, eye.openness);
    write_float(b, 60, eye.confidence);
    write_u8(b, 64, static_cast<std::uint8_t>(eye.state));
    write_u8(b, 65, static_cast<std::uint8_t>(eye.cause));
}

}  // namespace

std::array<std::byte, SampleFrame::kSize> SampleFrame::encode() const {
    auto b = begin(*this);
    write_u64(b, 32, exposure_ns);
    write_u32(b, 40, camera_frame);
    write_u16(b, 44, rate_decihertz);
    write_u16(b, 46, status);
    write_float(b, 48, iod_mm);
    write_float(b, 52, ipd_mm);
    write_floats(b, 56, base_point_mm);
    write_floats(b, 68, direction);
    write_floats(b, 80, por_px);
    write_eye(Out(b).subspan(88, EyeBlock::kSize), left);
    write_eye(Out(b).subspan(156, EyeBlock::kSize), right);
    write_float(b, 224, mapping_distance_mm);
    write_float(b, 228, vergence_distance_mm);
    write_s16(b, 232, temperature_centi_c);
    write_u16(b, 234, calibration_id);
    write_u8(b, 236, calibration_points);
    write_u8(b, 237, calibration_quality);
    write_u32(b, 240, dropped_by_device);
    finish(b);
    return b;
}

std::array<std::byte, EventFrame::kSize> EventFrame::encode() const {
    auto b = begin(*this);
    write_u64(b, 32, start_ns);
    write_u64(b, 40, end_ns);
    write_u8(b, 48, static_cast<std::uint8_t>(kind));
    write_u8(b, 49, static_cast<std::uint8_t>(eye));
    write_u8(b, 50, static_cast<std::uint8_t>(phase));
    write_floats(b, 52, direction_at_start);
    write_floats(b, 64, direction_at_end);
    write_float(b, 76, amplitude_deg);
    write_float(b, 80, peak_deg_s);
    write_floats(b, 84, mean_por_px);
    write_u32(b, 92, first_camera_frame);
    write_u32(b, 96, last_camera_frame);
    finish(b);
    return b;
}

std::array<std::byte, CalibrationFrame::kSize> CalibrationFrame::encode() const {
    auto b = begin(*this);
    write_u32(b, 32, calibration_id);
    write_u8(b, 36, points);
    write_u8(b, 37, current_point);
    write_u8(b, 38, static_cast<std::uint8_t>(state));
    write_u8(b, 39, static_cast<std::uint8_t>(reason));
    write_floats(b, 40, target_por_px);
    write_floats(b, 48, target_direction);
    write_floats(b, 60, accuracy_deg);
    write_floats(b, 68, precision_deg);
    finish(b);
    return b;
}

std::array<std::byte, HeartbeatFrame::kSize> HeartbeatFrame::encode() const {
    auto b = begin(*this);
    write_u64(b, 32, now_ns);
    write_u32(b, 40, usb_sof);
    write_u32(b, 44, samples_sent);
    finish(b);
    return b;
}

}  // namespace foverig::gaze
