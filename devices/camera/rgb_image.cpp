#include "devices/camera/rgb_image.h"

#include <algorithm>

#include "devices/camera/jpeg.h"

namespace foverig::camera {
namespace {

constexpr int kShift = 16;

/// Of 65536 parts; BT.601 (ITU-R BT.601-7, 2.5.1) for luma 16..235 and chroma 16..240.
constexpr int fixed(double factor) {
    return static_cast<int>(factor * (1 << kShift) + 0.5);
}
constexpr int kLuma = fixed(255.0 / 219.0);
constexpr int kRedOfV = fixed(1.402 * 255.0 / 224.0);
constexpr int kGreenOfU = fixed(0.344136 * 255.0 / 224.0);
constexpr int kGreenOfV = fixed(0.714136 * 255.0 / 224.0);
constexpr int kBlueOfU = fixed(1.772 * 255.0 / 224.0);

std::uint8_t byte_of(int parts) {
    return static_cast<std::uint8_t>(std::clamp((parts + (1 << (kShift - 1))) >> kShift, 0, 255));
}

void yuyv_row(const std::uint8_t* yuyv, int width_px, std::uint8_t* rgb) {
    for (int x = 0; x < width_px; ++x) {
        const std::uint8_t* pair = yuyv + 4 * (x / 2);
        const int y = kLuma * (yuyv[2 * x] - 16);
        const int u = pair[1] - 128;
        const int v = pair[3] - 128;
        rgb[3 * x] = byte_of(y + kRedOfV * v);
        rgb[3 * x + 1] = byte_of(y - kGreenOfU * u - kGreenOfV * v);
        rgb[3 * x + 2] = byte_of(y + kBlueOfU * u);
    }
}

void grey_row(const std::uint8_t* grey, int width_px, std::uint8_t* rgb) {
    for (int x = 0; x < width_px; ++x) std::fill_n(rgb + 3 * x, 3, grey[x]);
}

}  // namespace

Status to_rgb(const FrameHeader& header, Bytes packet, RgbImage& image) {
    image.width_px = header.width_px;
    image.height_px = header.height_px;
    const Bytes bytes = packet.subspan(FrameHeader::kSize, header.image_bytes);
    if (header.format == kMjpeg) return decode_jpeg(bytes, image);
    const std::size_t row_bytes = std::size_t{3} * header.width_px;
    image.bytes.resize(row_bytes * header.height_px);
    if (header.format == kYuyv && header.width_px % 2 != 0) {
        return Error{ErrorCode::invalid_data, "camera frame refused: YUYV of an odd width"};
    }
    const auto* from = reinterpret_cast<const std::uint8_t*>(bytes.data());
    for (std::size_t y = 0; y < header.height_px; ++y) {
        const auto row = header.format == kYuyv ? yuyv_row : grey_row;
        row(from + y * header.stride_bytes, header.width_px, image.bytes.data() + y * row_bytes);
    }
    return Done{};
}

}  // namespace foverig::camera
