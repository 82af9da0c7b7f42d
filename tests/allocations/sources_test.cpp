// Issue 4, bar 5: no allocation per sample on the way from a read() to whoever asks.
#include <gtest/gtest.h>

#include "devices/camera/tracker_camera.h"
#include "devices/dk2/imu_source.h"
#include "devices/gaze/gaze_source.h"
#include "simulators/dk2/simulated_dk2.h"
#include "simulators/gaze/simulated_gaze.h"
#include "simulators/motion/catalog.h"
#include "tests/allocations/stepped_desk.h"

namespace foverig::test {
namespace {

constexpr int kWarmUp = 2000;
constexpr int kSamples = 10'000;

/// What the program allocated while `source` gave kSamples, after a warm-up.
template <class Source>
std::size_t allocations_of_samples(Source& source, const SharedClock& clock) {
    const auto take = [&](int count) {
        while (count > 0) {
            const auto next = source.next(clock.now() + Nanoseconds(std::int64_t{1'000'000'000}));
            if (std::holds_alternative<typename Source::Sample>(next)) --count;
            if (std::holds_alternative<Fault>(next)) return;
        }
    };
    take(kWarmUp);
    const std::size_t before = allocations();
    take(kSamples);
    return allocations() - before;
}

TEST(Allocations, AreCounted) {
    const std::size_t before = allocations();
    EXPECT_NE(std::make_unique<int>(1), nullptr);
    EXPECT_EQ(allocations() - before, 1U);
}

TEST(Allocations, NoneForASampleOfTheHeadset) {
    SharedClock clock;
    const auto head = motion::make_head("look", 3).value();
    SimulatedDk2 device(clock, *head, {.faults = {.noise = 1, .host_delay = 1.0}});
    SteppedDesk desk(device, clock);
    auto source = dk2::Dk2ImuSource::open(desk, clock.now()).value();
    EXPECT_EQ(allocations_of_samples(source, clock), 0U);
    EXPECT_EQ(source.counts().samples, std::uint64_t{kWarmUp} + kSamples);
    EXPECT_EQ(source.counts().lost + source.counts().rejected, 0U);
}

TEST(Allocations, NoneForASampleOfTheGazeTracker) {
    SharedClock clock;
    const auto eyes = motion::make_eye("scan", 3).value();
    SimulatedGaze device(clock, *eyes);
    SteppedDesk desk(device, clock);
    auto source = gaze::GazeSource::open(desk, clock, {.rate_hz = 250}).value();
    EXPECT_EQ(allocations_of_samples(source, clock), 0U);
    EXPECT_EQ(source.counts().samples, std::uint64_t{kWarmUp} + kSamples);
    EXPECT_EQ(source.counts().lost + source.counts().rejected, 0U);
}

/// Small frames, 60 a second; no extension unit.
class SmallCamera final : public Transport {
  public:
    explicit SmallCamera(SharedClock& clock) : clock_(clock) {}
    NextPacket next(HostTime) override {
        clock_.sleep_until(clock_.now() + Nanoseconds(16'666'667));
        const std::vector<std::byte> image(64 * 48, std::byte{7});
        return Packet{
            clock_.now(),
            camera::encode_frame(
                {.width_px = 64, .height_px = 48, .stride_bytes = 64, .sequence = ++sequence_},
                image)};
    }
    Status control_set(std::uint8_t, std::uint16_t, Bytes) override { return none(); }
    Result<std::vector<std::byte>> control_get(std::uint8_t, std::uint16_t, std::size_t) override {
        return none();
    }

  private:
    static Error none() { return {ErrorCode::unsupported, "no extension unit"}; }

    SharedClock& clock_;
    std::uint32_t sequence_ = 0;
};

TEST(Allocations, NoneForAFrameOfTheCamera) {
    SharedClock clock;
    SmallCamera device(clock);
    SteppedDesk desk(device, clock);
    auto source = camera::TrackerCamera::open(desk, camera::Sync::free_running).value();
    EXPECT_EQ(allocations_of_samples(source, clock), 0U);
    EXPECT_EQ(source.counts().lost + source.counts().rejected, 0U);
}

}  // namespace
}  // namespace foverig::test
