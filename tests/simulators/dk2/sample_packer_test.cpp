#include "simulators/dk2/sample_packer.h"

#include <gtest/gtest.h>

namespace foverig {
namespace {

dk2::InertialSlot slot(std::int32_t v) {
    return {.accel = {v, -v, 0}, .gyro = {2 * v, 0, -v}};
}

/// Samples `from`..`to` with their number as value, count and, in ms, stamp.
SamplePacker packed_with(int from, int to) {
    SamplePacker packer;
    for (int i = from; i <= to; ++i) {
        packer.add(slot(i), static_cast<std::uint16_t>(i), static_cast<std::uint32_t>(1000 * i));
    }
    return packer;
}

TEST(SamplePacker, OneSampleLeavesTheSecondSlotZero) {
    const auto packed = packed_with(7, 7).packed();
    EXPECT_EQ(packed.num_samples, 1);
    EXPECT_EQ(packed.sample_count, 7);
    EXPECT_EQ(packed.slots[0], slot(7));
    EXPECT_EQ(packed.slots[1], dk2::InertialSlot{});
}

TEST(SamplePacker, TwoSamplesStandAsTheyCame) {
    const auto packed = packed_with(7, 8).packed();
    EXPECT_EQ(packed.num_samples, 2);
    EXPECT_EQ(packed.sample_count, 7);
    EXPECT_EQ(packed.slots[0], slot(7));
    EXPECT_EQ(packed.slots[1], slot(8));
    EXPECT_EQ(packed.newest_stamp_us, 8000u);
}

TEST(SamplePacker, MoreBecomeAMeanAndTheNewest) {
    const auto packed = packed_with(7, 10).packed();  // mean of 7, 8, 9
    EXPECT_EQ(packed.num_samples, 4);
    EXPECT_EQ(packed.sample_count, 7);
    EXPECT_EQ(packed.slots[0], slot(8));
    EXPECT_EQ(packed.slots[1], slot(10));
}

TEST(SamplePacker, AccelerationsAreDividedTowardsZeroAndRatesRounded) {
    // Mean of 7 and 8 in the accelerometer: 7 and -7. In the gyro 2 * 7.5 = 15 and -7.5, to -8.
    const auto packed = packed_with(7, 9).packed();
    EXPECT_EQ(packed.slots[0].accel, (dk2::Triple{7, -7, 0}));
    EXPECT_EQ(packed.slots[0].gyro, (dk2::Triple{15, 0, -8}));
}

TEST(SamplePacker, The255thDropsTheMean) {
    EXPECT_EQ(packed_with(1, 254).packed().num_samples, 254);
    const auto packed = packed_with(1, 255).packed();
    EXPECT_EQ(packed.num_samples, 2);
    EXPECT_EQ(packed.sample_count, 254);
    EXPECT_EQ(packed.slots[0], slot(254));
    EXPECT_EQ(packed.slots[1], slot(255));
}

TEST(SamplePacker, CountWrapsAtSixteenBits) {
    SamplePacker packer;
    packer.add(slot(1), 0xFFFF, 0);
    packer.add(slot(2), 0x0000, 1000);
    EXPECT_EQ(packer.packed().sample_count, 0xFFFF);
}

}  // namespace
}  // namespace foverig
