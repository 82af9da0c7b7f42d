#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "renderer/half.h"

namespace foverig {
namespace {

/// IEEE 754 binary16 by its definition.
double value_of(std::uint16_t bits) {
    const int exponent = (bits >> 10) & 31;
    const int fraction = bits & 1023;
    const double sign = (bits & 0x8000) != 0 ? -1.0 : 1.0;
    if (exponent == 31)
        return fraction != 0 ? std::numeric_limits<double>::quiet_NaN()
                             : sign * std::numeric_limits<double>::infinity();
    if (exponent == 0) return sign * std::ldexp(fraction, -24);
    return sign * std::ldexp(1024 + fraction, exponent - 25);
}

std::uint16_t lane(Half4 h, int i) {
    return static_cast<std::uint16_t>(h.bits >> (16 * i));
}

TEST(Half4, EveryHalfUnpacksToItsValueInEveryLane) {
    for (std::uint32_t bits = 0; bits < 65536; ++bits) {
        const double expected = value_of(static_cast<std::uint16_t>(bits));
        for (int i = 0; i < 4; ++i) {
            const double value = unpack_half4({std::uint64_t{bits} << (16 * i)})[i];
            if (std::isnan(expected))
                ASSERT_TRUE(std::isnan(value));
            else
                ASSERT_EQ(value, expected) << bits;
        }
    }
}

TEST(Half4, EveryHalfSurvivesTheRoundTrip) {
    for (std::uint32_t bits = 0; bits < 65536; ++bits) {
        if (std::isnan(value_of(static_cast<std::uint16_t>(bits)))) continue;
        const std::uint64_t all = bits * 0x0001000100010001ULL;
        ASSERT_EQ(pack_half4(unpack_half4({all})).bits, all);
    }
}

TEST(Half4, RoundsToNearestAndTiesToEven) {
    for (std::uint16_t low = 0; low < 0x7BFF; ++low) {
        const double a = value_of(low);
        const double b = value_of(static_cast<std::uint16_t>(low + 1));
        const auto middle = static_cast<float>(0.5 * (a + b));
        const float below = std::nextafter(middle, 0.0F);
        const float above = std::nextafter(middle, 1.0e9F);
        const Half4 h = pack_half4({below, middle, above, -middle});
        const auto even = static_cast<std::uint16_t>((low & 1) == 0 ? low : low + 1);
        ASSERT_EQ(lane(h, 0), low);
        ASSERT_EQ(lane(h, 1), even);
        ASSERT_EQ(lane(h, 2), low + 1);
        ASSERT_EQ(lane(h, 3), even | 0x8000);
    }
}

TEST(Half4, TooLargeIsInfiniteAndNanStaysNan) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const vec4 v = unpack_half4(pack_half4({65504.0F, 65520.0F, -1.0e30F, nan}));
    EXPECT_EQ(v.x, 65504.0F);
    EXPECT_EQ(v.y, std::numeric_limits<float>::infinity());
    EXPECT_EQ(v.z, -std::numeric_limits<float>::infinity());
    EXPECT_TRUE(std::isnan(v.w));
}

TEST(MeanHalf4, IsTheMeanOfItsTaps) {
    Half4 image[8];
    vec4 sum(0.0F);
    for (int i = 0; i < 8; ++i) {
        image[i] = pack_half4({static_cast<float>(i), 8.0F * static_cast<float>(i),
                               -static_cast<float>(i * i), 0.5F});
        sum += unpack_half4(image[i]);
    }
    int indices[8 * 3] = {};
    for (int k = 0; k < 8; ++k) indices[3 * k] = 7 - k;
    EXPECT_EQ(unpack_half4(mean_half4<8>(image, indices, 3)), sum / 8.0F);
    EXPECT_EQ(mean_half4<1>(image, indices, 3).bits, image[7].bits);
}

}  // namespace
}  // namespace foverig
