#include "devices/camera/frame.h"

#include <fmt/format.h>

#include <algorithm>

namespace foverig::camera {
namespace {

constexpr std::size_t kLargestImage = std::size_t{64} << 20;
constexpr std::size_t kMostPixels = kLargestImage / 2;  // of MJPG: as many as YUYV may have

Error refused(const std::string& why) {
    return {ErrorCode::invalid_data, "camera frame refused: " + why};
}

std::size_t bytes_per_pixel(std::uint32_t format) {
    return format == kYuyv ? 2 : 1;
}

Result<FrameHeader> fields_of(Bytes b) {
    if (b.size() < FrameHeader::kSize || read_u32(b, 0) != FrameHeader::kMagic) {
        return refused("no frame header (expected FCF1 and 32 bytes)");
    }
    const FrameHeader h{.format = read_u32(b, 4),
                        .width_px = read_u16(b, 8),
                        .height_px = read_u16(b, 10),
                        .stride_bytes = read_u32(b, 12),
                        .sequence = read_u32(b, 16),
                        .age_us = read_u32(b, 20),
                        .damaged = (read_u32(b, 24) & 1u) != 0,
                        .image_bytes = read_u32(b, 28)};
    if (h.image_bytes != b.size() - FrameHeader::kSize || h.image_bytes > kLargestImage) {
        return refused(fmt::format("{} bytes of image, its header says {}",
                                   b.size() - FrameHeader::kSize, h.image_bytes));
    }
    return h;
}

}  // namespace

Result<FrameHeader> decode_header(Bytes b) {
    const Result<FrameHeader> fields = fields_of(b);
    if (!fields) return fields;
    const FrameHeader& h = *fields;
    if (h.format != kGrey && h.format != kYuyv) {
        return refused(fmt::format("format {:#010x}; expected GREY or YUYV", h.format));
    }
    const std::size_t row_bytes = h.width_px * bytes_per_pixel(h.format);
    if (row_bytes == 0 || h.height_px == 0 || h.stride_bytes < row_bytes) {
        return refused(fmt::format("{} x {} pixels in rows of {} bytes", h.width_px, h.height_px,
                                   h.stride_bytes));
    }
    const std::size_t needed = std::size_t{h.stride_bytes} * (h.height_px - 1U) + row_bytes;
    if (h.image_bytes < needed) {
        return refused(fmt::format("{} bytes of image; its size asks {}", h.image_bytes, needed));
    }
    return h;
}

Result<FrameHeader> decode_any_header(Bytes b) {
    const Result<FrameHeader> fields = fields_of(b);
    if (!fields || fields->format != kMjpeg) return fields ? decode_header(b) : fields;
    const std::size_t pixels = std::size_t{fields->width_px} * fields->height_px;
    if (pixels == 0 || pixels > kMostPixels || fields->image_bytes == 0) {
        return refused(fmt::format("{} x {} pixels of MJPG in {} bytes", fields->width_px,
                                   fields->height_px, fields->image_bytes));
    }
    return fields;
}

std::array<std::byte, FrameHeader::kSize> encode_header(const FrameHeader& header) {
    std::array<std::byte, FrameHeader::kSize> b{};
    write_u32(b, 0, FrameHeader::kMagic);
    write_u32(b, 4, header.format);
    write_u16(b, 8, header.width_px);
    write_u16(b, 10, header.height_px);
    write_u32(b, 12, header.stride_bytes);
    write_u32(b, 16, header.sequence);
    write_u32(b, 20, header.age_us);
    write_u32(b, 24, header.damaged ? 1 : 0);
    write_u32(b, 28, header.image_bytes);
    return b;
}

std::vector<std::byte> encode_frame(FrameHeader header, Bytes image) {
    header.image_bytes = static_cast<std::uint32_t>(image.size());
    const auto head = encode_header(header);
    std::vector<std::byte> b(head.size() + image.size());
    std::copy(image.begin(), image.end(), std::copy(head.begin(), head.end(), b.begin()));
    return b;
}

GreyView tracker_image(const FrameHeader& header, Bytes packet) {
    return {.width_px = static_cast<int>(header.width_px * bytes_per_pixel(header.format)),
            .height_px = header.height_px,
            .stride_bytes = header.stride_bytes,
            .bytes = packet.subspan(FrameHeader::kSize)};
}

}  // namespace foverig::camera
