// What is said of a tracker camera that cannot be set up.
#include "rig/session/device_streams.h"

#include <gmock/gmock.h>

#include "tests/rig/session/altered_world.h"

namespace foverig {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// A camera whose extension unit goes with a certain loss: it comes back as any other camera.
class CameraThatForgets final : public Transport {
  public:
    /// `after` losses: 0, it never had one.
    CameraThatForgets(Transport& camera, int after) : camera_(camera), left_(after) {}

    NextPacket next(HostTime deadline) override {
        auto got = camera_.next(deadline);
        const bool lost = std::holds_alternative<Fault>(got);
        if (lost && !was_lost_) --left_;
        was_lost_ = lost;
        return got;
    }
    Status control_set(std::uint8_t id, std::uint16_t value,
                       std::span<const std::byte> data) override {
        if (left_ <= 0) return gone();
        return camera_.control_set(id, value, data);
    }
    Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                               std::size_t size) override {
        if (left_ <= 0) return gone();
        return camera_.control_get(id, value, size);
    }

  private:
    static Error gone() { return {ErrorCode::unsupported, "it has no extension unit"}; }

    Transport& camera_;
    int left_;
    bool was_lost_ = false;
};

/// Of 1.2 s in which the camera is unplugged from 0.3 to 0.5 s.
std::vector<std::string> said_of_a_camera_that_forgets(int after) {
    Scenario scenario;
    scenario.tracking.camera = true;
    scenario.faults.camera.unplug_at = 0.3;
    scenario.faults.camera.unplug_for = 0.2;
    ManualClock clock;
    test::AlteredWorld world(scenario, clock);
    CameraThatForgets camera(*world.tracker_camera(), after);
    world.camera_instead = &camera;
    DeviceStreams devices(scenario, world, clock, nullptr);
    std::vector<std::string> said;
    devices.tell([&](const std::string& text) { said.push_back(text); });
    devices.run_for(from_seconds(1.2));
    return said;
}

TEST(DeviceStreams, SayAtOnceThatACameraIsTakenAsItIs) {
    EXPECT_THAT(
        said_of_a_camera_that_forgets(0),
        ElementsAre(AllOf(HasSubstr("camera is not set up"), HasSubstr("with the design's lens"),
                          HasSubstr("it has no extension unit")),
                    HasSubstr("camera is lost"), HasSubstr("camera is back")))
        << "what was said and is as it was is not said again";
}

TEST(DeviceStreams, SayThatACameraCameBackAndIsTakenAsItIs) {
    EXPECT_THAT(
        said_of_a_camera_that_forgets(1),
        ElementsAre(HasSubstr("camera is lost"), HasSubstr("camera is back"),
                    AllOf(HasSubstr("camera is not set up"), HasSubstr("that it told before"),
                          HasSubstr("it has no extension unit"))));
}

TEST(DeviceStreams, SayNothingOfACameraThatIsSetUpAgain) {
    EXPECT_THAT(said_of_a_camera_that_forgets(2),
                ElementsAre(HasSubstr("camera is lost"), HasSubstr("camera is back")));
}

}  // namespace
}  // namespace foverig
