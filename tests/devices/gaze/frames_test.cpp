#include "devices/gaze/frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>

#include "devices/crc32.h"
#include "tests/devices/byte_text.h"
#include "tests/devices/gaze/golden_sample.h"

namespace foverig::gaze {
namespace {

using test::bytes_of;
using test::copy_of;

std::vector<std::byte> resealed(std::vector<std::byte> b) {
    write_u32(b, b.size() - 4, crc32(Bytes(b).first(b.size() - 4)));
    return b;
}

TEST(Crc32, CheckValue) {
    constexpr std::string_view text = "123456789";
    EXPECT_EQ(crc32(std::as_bytes(std::span(text))), 0xCBF43926u);
    EXPECT_EQ(crc32({}), 0u);
}

TEST(SampleFrame, EncodesTheGoldenFrame) {
    const auto b = test::golden_sample().encode();
    EXPECT_EQ(copy_of(b), bytes_of(test::kGoldenSampleHex));
    EXPECT_EQ(read_u32(b, 244), 0x4D50454Du);
}

TEST(SampleFrame, DecodesTheGoldenFrame) {
    const auto frame = decode_frame(bytes_of(test::kGoldenSampleHex));
    ASSERT_TRUE(frame) << frame.error().text;
    const auto* sample = std::get_if<SampleFrame>(&*frame);
    ASSERT_NE(sample, nullptr);
    EXPECT_EQ(sample->header, test::golden_sample().header);
    EXPECT_EQ(sample->exposure_ns, 1'000'000'000'000u);
    EXPECT_EQ(sample->status, 0x000F);
    EXPECT_EQ(sample->left.base_point_mm, (Vec3f{32, 0, -22}));
    EXPECT_EQ(sample->right.por_px, (Vec2f{1440, 540}));
    EXPECT_FLOAT_EQ(sample->right.confidence, 0.95f);
    EXPECT_TRUE(std::isnan(sample->vergence_distance_mm));
    EXPECT_EQ(copy_of(sample->encode()), bytes_of(test::kGoldenSampleHex));
}

TEST(SampleFrame, MissingNumbersAreTheOneQuietNan) {
    SampleFrame f;
    f.vergence_distance_mm = -std::numeric_limits<float>::signaling_NaN();
    EXPECT_EQ(read_u32(f.encode(), 228), 0x7FC00000u);
    EXPECT_EQ(read_u32(f.encode(), 88), 0x7FC00000u);
}

TEST(EventFrame, RoundTripsAtItsOffsets) {
    EventFrame f;
    f.header.sequence = 3;
    f.start_ns = 5;
    f.end_ns = 0x0102030405060708;
    f.kind = EventKind::saccade;
    f.eye = EventEye::right;
    f.phase = EventPhase::end;
    f.direction_at_start = {0, 0, 1};
    f.amplitude_deg = 10;
    f.last_camera_frame = 99;
    const auto b = f.encode();
    EXPECT_EQ(copy_of(Bytes(b).subspan(40, 12)), bytes_of("08 07 06 05 04 03 02 01 02 02 02 00"));
    EXPECT_EQ(read_f32(b, 60), 1);
    EXPECT_EQ(read_f32(b, 76), 10);
    EXPECT_EQ(read_u32(b, 96), 99u);
    const auto back = decode_frame(b);
    ASSERT_TRUE(back);
    EXPECT_EQ(copy_of(std::get<EventFrame>(*back).encode()), copy_of(b));
}

TEST(CalibrationFrame, RoundTripsAtItsOffsets) {
    CalibrationFrame f;
    f.calibration_id = 7;
    f.points = 5;
    f.current_point = 2;
    f.state = CalibrationState::done;
    f.reason = CalibrationReason::host_abort;
    f.accuracy_deg = {0.5f, 0.75f};
    f.precision_deg = {0.125f, 0.25f};
    const auto b = f.encode();
    EXPECT_EQ(b.size(), 80u);
    EXPECT_EQ(copy_of(Bytes(b).subspan(32, 8)), bytes_of("07 00 00 00 05 02 05 04"));
    EXPECT_EQ(read_f32(b, 64), 0.75f);
    EXPECT_EQ(read_f32(b, 72), 0.25f);
    EXPECT_EQ(copy_of(std::get<CalibrationFrame>(*decode_frame(b)).encode()), copy_of(b));
}

TEST(HeartbeatFrame, RoundTripsAtItsOffsets) {
    HeartbeatFrame f;
    f.now_ns = 77;
    f.samples_sent = 61;
    const auto b = f.encode();
    EXPECT_EQ(copy_of(Bytes(b).subspan(32, 16)),
              bytes_of("4d 00 00 00 00 00 00 00 ff ff ff ff 3d 00 00 00"));
    EXPECT_EQ(copy_of(std::get<HeartbeatFrame>(*decode_frame(b)).encode()), copy_of(b));
}

TEST(DecodeFrame, NoLengthIsAMultipleOf64) {
    for (const std::size_t size :
         {SampleFrame::kSize, EventFrame::kSize, CalibrationFrame::kSize, HeartbeatFrame::kSize}) {
        EXPECT_NE(size % 64, 0u);
    }
}

TEST(DecodeFrame, RejectsEveryTruncationAndEveryFlippedBit) {
    const std::vector<std::byte> good = bytes_of(test::kGoldenSampleHex);
    for (std::size_t n = 0; n < good.size(); ++n)
        EXPECT_FALSE(decode_frame(Bytes(good).first(n))) << n;
    for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
        std::vector<std::byte> bad = good;
        bad[bit / 8] ^= static_cast<std::byte>(1 << bit % 8);
        EXPECT_FALSE(decode_frame(bad)) << bit;
    }
}

TEST(DecodeFrame, RejectsOtherMajorsTypesAndLengthsEvenWithAGoodCrc) {
    const std::vector<std::byte> good = bytes_of(test::kGoldenSampleHex);
    const auto with = [&](std::size_t at, int value) {
        std::vector<std::byte> b = good;
        b[at] = static_cast<std::byte>(value);
        return resealed(std::move(b));
    };
    EXPECT_TRUE(decode_frame(with(7, 0)));
    EXPECT_FALSE(decode_frame(with(4, 2)));
    EXPECT_FALSE(decode_frame(with(6, 0)));
    EXPECT_FALSE(decode_frame(with(6, 2)));  // an event of 248 bytes
    EXPECT_FALSE(decode_frame(with(6, 5)));
    EXPECT_FALSE(decode_frame(with(8, 247)));
    EXPECT_FALSE(decode_frame(with(10, 36)));
}

TEST(DecodeFrame, ANewerMinorMayAppendBeforeTheCrc) {
    std::vector<std::byte> longer = bytes_of(test::kGoldenSampleHex);
    longer.insert(longer.end() - 4, 8, std::byte{0xAA});
    write_u16(longer, 8, static_cast<std::uint16_t>(longer.size()));
    EXPECT_FALSE(decode_frame(resealed(longer)));  // 1.0 has one length
    longer[5] = std::byte{1};
    const auto frame = decode_frame(resealed(longer));
    ASSERT_TRUE(frame);
    EXPECT_EQ(std::get<SampleFrame>(*frame).camera_frame, 60u);
    longer.resize(100);
    write_u16(longer, 8, 100);
    EXPECT_FALSE(decode_frame(resealed(longer)));
}

TEST(DecodeFrame, SurvivesRandomBodiesWithGoodSeals) {
    test::Random random(3);
    int accepted = 0;
    const std::size_t sizes[] = {SampleFrame::kSize, EventFrame::kSize, CalibrationFrame::kSize,
                                 HeartbeatFrame::kSize};
    for (int i = 0; i < 20000; ++i) {
        const auto type = random.bits() % 4;
        std::vector<std::byte> b = random.bytes(i % 4 == 0 ? random.bits() % 300 : sizes[type]);
        if (b.size() >= 36 && i % 8 != 1) {
            write_u32(b, 0, 0x315A4753u);
            write_u16(b, 4, 1);
            write_u8(b, 6, static_cast<std::uint8_t>(type + 1));
            write_u16(b, 8, static_cast<std::uint16_t>(b.size()));
            write_u16(b, 10, 32);
            b = resealed(std::move(b));
        }
        accepted += static_cast<bool>(decode_frame(b));
    }
    EXPECT_GT(accepted, 10000);
}

}  // namespace
}  // namespace foverig::gaze
