#include "devices/dk2/about.h"

#include <gmock/gmock.h>

#include "devices/dk2/calibration_reports.h"
#include "tests/devices/byte_text.h"
#include "tests/devices/fake_transport.h"

namespace foverig::dk2 {
namespace {

using test::copy_of;
using test::FakeTransport;
using testing::HasSubstr;
using testing::Not;

constexpr std::uint32_t kJuly12th2014_s = 1405123200;

/// A headset of six stages that begins to tell them at the fourth.
class MadeHeadset {
  public:
    explicit MadeHeadset(std::uint32_t result_of_stage_2 = ManufacturingReport::kPassed)
        : result_of_stage_2_(result_of_stage_2) {
        device.answer_by = [this](std::uint8_t id, std::uint16_t) { return answer(id); };
    }
    FakeTransport device;
    RangeReport range;
    RegisterReport written;

  private:
    Result<std::vector<std::byte>> answer(std::uint8_t id) {
        switch (id) {
            case SerialReport::kId:
                return copy_of(SerialReport{.serial = "ABCDEFGHIJKL"}.encode());
            case UuidReport::kId:
                return copy_of(UuidReport{.uuid = "ABCDEFGHIJKLMNOPQRST"}.encode());
            case MagCalibrationReport::kId:
                return copy_of(MagCalibrationReport{.version = 2}.encode());
            case RangeReport::kId:
                return copy_of(range.encode());
            case RegisterReport::kId:
                return copy_of(written.encode());
            case ManufacturingReport::kId: {
                const auto stage = static_cast<std::uint8_t>(next_stage_++ % 6);
                return copy_of(ManufacturingReport{.stages = 6,
                                                   .stage = stage,
                                                   .unix_time_s = kJuly12th2014_s - 86400U * stage,
                                                   .result = stage == 2 ? result_of_stage_2_ : 1}
                                   .encode());
            }
            default:
                return Error{ErrorCode::unsupported, "not asked for"};
        }
    }

    std::uint32_t result_of_stage_2_;
    int next_stage_ = 3;
};

TEST(About, TellsAHeadsetThatIsAsItWasMade) {
    MadeHeadset headset;
    const auto about = read_about(headset.device);
    ASSERT_TRUE(about) << about.error().text;
    ASSERT_EQ(about->stages.size(), 6U);
    EXPECT_EQ(about->stages[5].stage, 5);
    EXPECT_EQ(text_of(*about),
              "factory number ABCDEFGHIJKL, UUID ABCDEFGHIJKLMNOPQRST; made 2014-07-12, 6 factory "
              "tests stored, all passed; magnetometer calibrated (version 2)");
    EXPECT_TRUE(headset.device.sets.empty());
}

TEST(About, TellsWhatFailedAndWhatAProgramLeft) {
    MadeHeadset headset(4);
    headset.range.gyro_deg_s = 250;
    headset.written = {.chip = RegisterReport::Chip::mpu6500, .address = 0x1D, .payload = 0x03};
    const auto about = read_about(headset.device);
    ASSERT_TRUE(about) << about.error().text;
    const std::string text = text_of(*about);
    EXPECT_THAT(text, HasSubstr("stage 2 ended with 4"));
    EXPECT_THAT(text, Not(HasSubstr("all passed")));
    EXPECT_THAT(text, HasSubstr("ranges of 4 g and 250 deg/s"));
    EXPECT_THAT(text, HasSubstr("0x03 to register 0x1d of chip 3"));
}

TEST(About, SaysWhichReportFailed) {
    FakeTransport device;
    device.answers[SerialReport::kId] = copy_of(SerialReport{}.encode());
    const auto about = read_about(device);
    ASSERT_FALSE(about);
    EXPECT_EQ(about.error().code, ErrorCode::unsupported);
}

}  // namespace
}  // namespace foverig::dk2
