#pragma once
// One image of a camera as it goes over the bytes seam: a header of ours with what the kernel says
// of a buffer, then the buffer's bytes. Little-endian; 32 bytes:
//   0 u32 "FCF1"  4 u32 fourcc  8 u16 width  10 u16 height  12 u32 stride, bytes  16 u32 sequence
//   20 u32 age, us: from the frame's time stamp to its arrival  24 u32 flags, bit 0 damaged
//   28 u32 bytes of image
#include <array>
#include <cstdint>
#include <vector>

#include "devices/bytes.h"
#include "devices/result.h"

namespace foverig::camera {

constexpr std::uint32_t fourcc(char a, char b, char c, char d) {
    return static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b) << 8 |
           static_cast<std::uint32_t>(c) << 16 | static_cast<std::uint32_t>(d) << 24;
}
inline constexpr std::uint32_t kGrey = fourcc('G', 'R', 'E', 'Y');
inline constexpr std::uint32_t kYuyv = fourcc('Y', 'U', 'Y', 'V');
inline constexpr std::uint32_t kMjpeg = fourcc('M', 'J', 'P', 'G');  ///< of stride 0

struct FrameHeader {
    static constexpr std::size_t kSize = 32;
    static constexpr std::uint32_t kMagic = fourcc('F', 'C', 'F', '1');

    std::uint32_t format = kGrey;
    std::uint16_t width_px = 752, height_px = 480;  ///< as the driver counts them
    std::uint32_t stride_bytes = 752;
    std::uint32_t sequence = 0;  ///< of the driver: a gap is frames it lost
    std::uint32_t age_us = 0;
    bool damaged = false;  ///< the driver says that bytes are missing
    std::uint32_t image_bytes = 0;

    bool operator==(const FrameHeader&) const = default;
};

/// Grey pixels in rows; the bytes are somebody else's.
struct GreyView {
    int width_px = 0, height_px = 0;
    std::size_t stride_bytes = 0;
    Bytes bytes;

    const std::uint8_t* row(int y) const {
        return reinterpret_cast<const std::uint8_t*>(bytes.data()) +
               static_cast<std::size_t>(y) * stride_bytes;
    }
};

/// Checks magic, sizes and format (GREY or YUYV).
Result<FrameHeader> decode_header(Bytes packet);
/// The same for any camera's frame: MJPG too, of which only the header can be checked.
Result<FrameHeader> decode_any_header(Bytes packet);
std::array<std::byte, FrameHeader::kSize> encode_header(const FrameHeader& header);
/// Header and image; the header's image_bytes is set here.
std::vector<std::byte> encode_frame(FrameHeader header, Bytes image);

/// The tracker camera's image: GREY as it is, or the YUYV of half the width that the DK2's camera
/// advertises, which holds the same bytes (DEVICES.md 1.8). `packet` is one that decode_header
/// took, and outlives the view.
GreyView tracker_image(const FrameHeader& header, Bytes packet);

}  // namespace foverig::camera
