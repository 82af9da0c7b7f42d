#include "devices/camera/lens.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace foverig::camera {
namespace {

const Lens kOdd{693.5, 691.25, 360.5, 250.75, -0.33, 0.12, 0.001, -0.0005, -0.01};

// Offsets of DEVICES.md 1.8.4, which two sources agree on.
TEST(LensBlock, HoldsItsNumbersWhereTheDeviceDoes) {
    const auto block = encode_lens_block(kOdd);
    ASSERT_EQ(block.size(), 122u);
    EXPECT_EQ(read_u32(block, 0), 0xE2978900u);
    EXPECT_EQ(read_u16(block, 4), 122);
    EXPECT_EQ(read_u16(block, 6), 1);
    EXPECT_EQ(read_u16(block, 8), 9);
    const std::array<std::pair<std::size_t, double>, 9> places{{{18, 693.5},
                                                                {30, 691.25},
                                                                {42, 360.5},
                                                                {54, 250.75},
                                                                {66, -0.33},
                                                                {78, 0.12},
                                                                {90, 0.001},
                                                                {102, -0.0005},
                                                                {114, -0.01}}};
    for (const auto& [at, value] : places) {
        EXPECT_EQ(std::bit_cast<double>(read_u64(block, at)), value) << at;
    }
    EXPECT_EQ(decode_lens_block(block).value(), kOdd);
}

TEST(LensBlock, IsRefusedWhereItIsNoneOrHoldsNoNumber) {
    const auto block = encode_lens_block(kOdd);
    EXPECT_FALSE(decode_lens_block(Bytes(block).first(121)));
    for (const std::size_t at : {0u, 4u, 6u, 8u, 16u, 112u}) {
        auto bad = block;
        bad[at] ^= std::byte{1};
        EXPECT_FALSE(decode_lens_block(bad)) << at;
    }
    for (const double value : {std::nan(""), HUGE_VAL, 0.0, -500.0}) {
        auto bad = block;
        write_u64(bad, 18, std::bit_cast<std::uint64_t>(value));
        EXPECT_FALSE(decode_lens_block(bad)) << value;
    }
    EXPECT_FALSE(decode_lens_block(std::vector<std::byte>(122, std::byte{0xFF})));
}

TEST(Lens, SeesTheDesignsSeventyDegrees) {
    const double edge = std::tan(35.0 * 3.14159265358979 / 180.0);
    EXPECT_NEAR(Lens{}.project({edge, 0, 1}).value().x, 751.5, 0.01);
    EXPECT_EQ(Lens{}.project({0, 0, 2}).value(), dvec2(375.5, 239.5));
    EXPECT_FALSE(Lens{}.project({0, 0, -1}));
    EXPECT_FALSE(Lens{}.project({0, 0, 0}));
}

// Barrel distortion turns back on itself far out, where a second point would fall on each pixel.
TEST(Lens, HasNoPixelWhereItsDistortionFoldsBack) {
    const Lens barrel{.k1 = -0.3};
    EXPECT_TRUE(barrel.project({0.9, 0, 1}));
    EXPECT_FALSE(barrel.project({1.2, 0, 1}));
}

}  // namespace
}  // namespace foverig::camera
