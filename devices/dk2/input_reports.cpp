#include "devices/dk2/input_reports.h"

#include <fmt/format.h>

namespace foverig::dk2 {
namespace {

constexpr std::size_t kSlotSize = 16;

Error bad_report(std::string text) {
    return {ErrorCode::invalid_data, std::move(text)};
}

template <std::size_t n>
std::array<InertialSlot, n> read_slots(Bytes b, std::size_t at) {
    std::array<InertialSlot, n> slots;
    for (std::size_t i = 0; i < n; ++i) {
        slots[i] = {read_triple(b, at + i * kSlotSize),
                    read_triple(b, at + i * kSlotSize + kTripleSize)};
    }
    return slots;
}

template <std::size_t n>
void write_slots(std::span<std::byte> b, std::size_t at, const std::array<InertialSlot, n>& slots) {
    for (std::size_t i = 0; i < n; ++i) {
        write_triple(b, at + i * kSlotSize, slots[i].accel);
        write_triple(b, at + i * kSlotSize + kTripleSize, slots[i].gyro);
    }
}

std::array<std::int16_t, 3> read_mag(Bytes b, std::size_t at) {
    return {read_s16(b, at), read_s16(b, at + 2), read_s16(b, at + 4)};
}

void write_mag(std::span<std::byte> b, std::size_t at, const std::array<std::int16_t, 3>& mag) {
    for (std::size_t i = 0; i < 3; ++i) write_s16(b, at + 2 * i, mag[i]);
}

bool sample_number_is_good(std::uint8_t n) {
    return n >= 1 && n <= kMaxNumSamples;
}

}  // namespace

Result<InputReport11> InputReport11::decode(Bytes b) {
    if (b.size() != kSize) {
        return bad_report(fmt::format("DK2 report 11 has {} bytes, expected 64", b.size()));
    }
    if (read_u8(b, 0) != kId) {
        return bad_report(fmt::format("DK2 report has id {}, expected 11", read_u8(b, 0)));
    }
    InputReport11 r;
    r.last_command_id = read_u16(b, 1);
    r.num_samples = read_u8(b, 3);
    r.sample_count = read_u16(b, 4);
    r.temperature_centi_c = read_s16(b, 6);
    r.sample_timestamp_us = read_u32(b, 8);
    r.slots = read_slots<2>(b, 12);
    r.mag_1e4_gauss = read_mag(b, 44);
    r.frame_count = read_u16(b, 50);
    r.frame_timestamp_us = read_u32(b, 52);
    r.frame_id = read_u8(b, 56);
    r.tracking_pattern = read_u8(b, 57);
    r.tracking_count = read_u16(b, 58);
    r.tracking_timestamp_us = read_u32(b, 60);
    if (!sample_number_is_good(r.num_samples)) {
        return bad_report(
            fmt::format("DK2 report 11 holds {} samples, expected 1..254", r.num_samples));
    }
    return r;
}

std::array<std::byte, InputReport11::kSize> InputReport11::encode() const {
    std::array<std::byte, kSize> b{};
    write_u8(b, 0, kId);
    write_u16(b, 1, last_command_id);
    write_u8(b, 3, num_samples);
    write_u16(b, 4, sample_count);
    write_s16(b, 6, temperature_centi_c);
    write_u32(b, 8, sample_timestamp_us);
    write_slots(b, 12, slots);
    write_mag(b, 44, mag_1e4_gauss);
    write_u16(b, 50, frame_count);
    write_u32(b, 52, frame_timestamp_us);
    write_u8(b, 56, frame_id);
    write_u8(b, 57, tracking_pattern);
    write_u16(b, 58, tracking_count);
    write_u32(b, 60, tracking_timestamp_us);
    return b;
}

Result<InputReport1> InputReport1::decode(Bytes b) {
    if (b.size() < kSize || b.size() > InputReport11::kSize) {
        return bad_report(fmt::format("DK2 report 1 has {} bytes, expected 62", b.size()));
    }
    if (read_u8(b, 0) != kId) {
        return bad_report(fmt::format("DK2 report has id {}, expected 1", read_u8(b, 0)));
    }
    InputReport1 r;
    r.num_samples = read_u8(b, 1);
    r.sample_count = read_u16(b, 2);
    r.last_command_id = read_u16(b, 4);
    r.temperature_centi_c = read_s16(b, 6);
    r.slots = read_slots<3>(b, 8);
    r.mag_1e4_gauss = read_mag(b, 56);
    if (!sample_number_is_good(r.num_samples)) {
        return bad_report(
            fmt::format("DK2 report 1 holds {} samples, expected 1..254", r.num_samples));
    }
    return r;
}

std::array<std::byte, InputReport1::kSize> InputReport1::encode() const {
    std::array<std::byte, kSize> b{};
    write_u8(b, 0, kId);
    write_u8(b, 1, num_samples);
    write_u16(b, 2, sample_count);
    write_u16(b, 4, last_command_id);
    write_s16(b, 6, temperature_centi_c);
    write_slots(b, 8, slots);
    write_mag(b, 56, mag_1e4_gauss);
    return b;
}

}  // namespace foverig::dk2
