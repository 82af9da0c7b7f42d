#include "devices/camera/frame.h"

#include <gtest/gtest.h>

#include <numeric>

namespace foverig::camera {
namespace {

std::vector<std::byte> counting(std::size_t size) {
    std::vector<std::byte> bytes(size);
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::byte>(i * 7 & 0xFF);
    return bytes;
}

const FrameHeader kSmall{
    .width_px = 8, .height_px = 4, .stride_bytes = 8, .sequence = 0x01020304, .age_us = 15000};

TEST(CameraFrame, HeaderLiesWhereItSays) {
    const auto packet = encode_frame(kSmall, counting(32));
    ASSERT_EQ(packet.size(), 64u);
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(packet.data()), 8), "FCF1GREY");
    EXPECT_EQ(read_u16(packet, 8), 8);
    EXPECT_EQ(read_u16(packet, 10), 4);
    EXPECT_EQ(read_u32(packet, 16), 0x01020304u);
    EXPECT_EQ(read_u32(packet, 20), 15000u);
    EXPECT_EQ(read_u32(packet, 28), 32u);
    auto expected = kSmall;
    expected.image_bytes = 32;
    const auto header = decode_header(packet);
    ASSERT_TRUE(header);
    EXPECT_EQ(*header, expected);
}

TEST(CameraFrame, YuyvOfHalfTheWidthIsTheSameImage) {
    const auto image = counting(32);
    const auto grey = encode_frame(kSmall, image);
    FrameHeader half = kSmall;
    half.format = kYuyv;
    half.width_px = 4;
    const auto yuyv = encode_frame(half, image);
    const GreyView a = tracker_image(decode_header(grey).value(), grey);
    const GreyView b = tracker_image(decode_header(yuyv).value(), yuyv);
    ASSERT_EQ(a.width_px, b.width_px);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 8; ++x) EXPECT_EQ(a.row(y)[x], b.row(y)[x]);
    }
}

TEST(CameraFrame, EveryShortenedOrMangledHeaderIsRefused) {
    const auto packet = encode_frame(kSmall, counting(32));
    for (std::size_t size = 0; size < packet.size(); ++size) {
        EXPECT_FALSE(decode_header(Bytes(packet).first(size))) << size;
    }
    for (const std::size_t at : {0u, 4u, 9u, 11u, 13u, 28u}) {
        auto bad = packet;
        bad[at] ^= std::byte{0x7F};
        EXPECT_FALSE(decode_header(bad)) << at;
    }
    for (const std::size_t at : {8u, 10u, 12u}) {
        auto bad = packet;
        write_u16(bad, at, 0);
        EXPECT_FALSE(decode_header(bad)) << at;
    }
}

}  // namespace
}  // namespace foverig::camera
