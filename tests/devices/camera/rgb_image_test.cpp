#include "devices/camera/rgb_image.h"

#include <gtest/gtest.h>

#include <cstring>

#include "tests/devices/camera/jpeg_of.h"

namespace foverig::camera {
namespace {

using Rgb = std::array<int, 3>;

RgbImage converted(const FrameHeader& header, Bytes bytes) {
    const auto packet = encode_frame(header, bytes);
    const auto decoded = decode_any_header(packet);
    EXPECT_TRUE(decoded) << decoded.error().text;
    RgbImage image;
    const Status status = to_rgb(*decoded, packet, image);
    EXPECT_TRUE(status) << status.error().text;
    return image;
}

Rgb at(const RgbImage& image, int x, int y) {
    const std::uint8_t* p = image.bytes.data() + 3 * (y * image.width_px + x);
    return {p[0], p[1], p[2]};
}

/// Red grows to the right and green downwards.
std::vector<std::byte> jpeg_of_gradient(int width_px, int height_px) {
    RgbImage image{.width_px = width_px, .height_px = height_px, .bytes = {}};
    for (int y = 0; y < height_px; ++y) {
        for (int x = 0; x < width_px; ++x) {
            image.bytes.insert(image.bytes.end(),
                               {static_cast<std::uint8_t>(2 * x), static_cast<std::uint8_t>(3 * y),
                                std::uint8_t{40}});
        }
    }
    return test::jpeg_of(image);
}

const FrameHeader kJpegHeader{.format = kMjpeg, .width_px = 96, .height_px = 64, .stride_bytes = 0};

void expect_gradient(const RgbImage& image) {
    for (const auto& [x, y] : {std::pair{8, 8}, {48, 32}, {90, 60}}) {
        const Rgb got = at(image, x, y);
        EXPECT_NEAR(got[0], 2 * x, 5);
        EXPECT_NEAR(got[1], 3 * y, 5);
        EXPECT_NEAR(got[2], 40, 6);
    }
}

// ITU-R BT.801 / SMPTE EG 1: 75 % colour bars as 8-bit BT.601 Y, Cb, Cr; 75 % of 255 is 191.
TEST(RgbImage, ColourBarsAreTheStandards) {
    struct Bar {
        int y, cb, cr;
        Rgb rgb;
    };
    for (const Bar& bar : {Bar{180, 128, 128, {191, 191, 191}}, Bar{162, 44, 142, {191, 191, 0}},
                           Bar{131, 156, 44, {0, 191, 191}}, Bar{112, 72, 58, {0, 191, 0}},
                           Bar{84, 184, 198, {191, 0, 191}}, Bar{65, 100, 212, {191, 0, 0}},
                           Bar{35, 212, 114, {0, 0, 191}}, Bar{16, 128, 128, {0, 0, 0}},
                           Bar{235, 128, 128, {255, 255, 255}}}) {
        const std::array pair{std::byte(bar.y), std::byte(bar.cb), std::byte(bar.y),
                              std::byte(bar.cr)};
        const RgbImage image =
            converted({.format = kYuyv, .width_px = 2, .height_px = 1, .stride_bytes = 4}, pair);
        for (int x = 0; x < 2; ++x) {
            for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(at(image, x, 0)[c], bar.rgb[c], 1);
        }
    }
}

TEST(RgbImage, RowsMayBePadded) {
    std::vector<std::byte> bytes(2 * 16, std::byte{0});
    bytes[16 + 3] = std::byte{200};
    const RgbImage image =
        converted({.format = kGrey, .width_px = 4, .height_px = 2, .stride_bytes = 16}, bytes);
    EXPECT_EQ(image.bytes.size(), 24u);
    EXPECT_EQ(at(image, 3, 1), (Rgb{200, 200, 200}));
    EXPECT_EQ(at(image, 3, 0), (Rgb{0, 0, 0}));
}

TEST(RgbImage, ReadsMotionJpeg) {
    expect_gradient(converted(kJpegHeader, jpeg_of_gradient(96, 64)));
}

// USB Video Class 1.1, MJPEG payload: a camera may leave the standard Huffman tables out.
TEST(RgbImage, ReadsMotionJpegWithoutItsHuffmanTables) {
    const auto whole = jpeg_of_gradient(96, 64);
    std::vector<std::byte> bare(whole.begin(), whole.begin() + 2);
    std::size_t pos = 2;
    while (whole[pos + 1] != std::byte{0xDA}) {  // segments before the scan
        const std::size_t size = 2 + (std::to_integer<std::size_t>(whole[pos + 2]) << 8U |
                                      std::to_integer<std::size_t>(whole[pos + 3]));
        if (whole[pos + 1] != std::byte{0xC4}) {
            bare.insert(bare.end(), whole.begin() + static_cast<std::ptrdiff_t>(pos),
                        whole.begin() + static_cast<std::ptrdiff_t>(pos + size));
        }
        pos += size;
    }
    bare.insert(bare.end(), whole.begin() + static_cast<std::ptrdiff_t>(pos), whole.end());
    ASSERT_LT(bare.size() + 300, whole.size());
    expect_gradient(converted(kJpegHeader, bare));
}

TEST(RgbImage, RefusesWhatIsNoPictureOfTheStreamsSize) {
    RgbImage image;
    const auto refused = [&](FrameHeader header, Bytes bytes) {
        const auto packet = encode_frame(header, bytes);
        header.image_bytes = static_cast<std::uint32_t>(bytes.size());
        return !to_rgb(header, packet, image);
    };
    const auto jpeg = jpeg_of_gradient(96, 64);
    FrameHeader other = kJpegHeader;
    other.width_px = 98;
    EXPECT_TRUE(refused(other, jpeg));
    EXPECT_TRUE(refused(kJpegHeader, Bytes(jpeg).first(20)));
    EXPECT_TRUE(refused(kJpegHeader, Bytes(jpeg).subspan(100)));
    const std::array<std::byte, 6> odd{};
    EXPECT_TRUE(refused({.format = kYuyv, .width_px = 3, .height_px = 1, .stride_bytes = 6}, odd));
}

/// Found by fuzzing: 900 bytes asked for 12.9 GB.
TEST(RgbImage, TakesNoMemoryForASizeThatOnlyTheHeaderSays) {
    FrameHeader header = kJpegHeader;
    header.width_px = header.height_px = 5000;
    RgbImage image;
    const auto packet = encode_frame(header, jpeg_of_gradient(96, 64));
    EXPECT_FALSE(to_rgb(decode_any_header(packet).value(), packet, image));
    EXPECT_EQ(image.bytes.capacity(), 0U);
    header.width_px = header.height_px = 65500;
    EXPECT_FALSE(decode_any_header(encode_frame(header, jpeg_of_gradient(96, 64))));
}

TEST(AnyFrameHeader, TakesCompressedFramesThatTheTrackerRefuses) {
    const auto packet = encode_frame(kJpegHeader, std::array<std::byte, 5>{});
    EXPECT_TRUE(decode_any_header(packet));
    EXPECT_FALSE(decode_header(packet));
    EXPECT_FALSE(decode_any_header(encode_frame(kJpegHeader, {}))) << "nothing in it";
    EXPECT_FALSE(decode_any_header(encode_frame({.format = 7}, std::array<std::byte, 5>{})));
}

}  // namespace
}  // namespace foverig::camera
