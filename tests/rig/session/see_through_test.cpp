#include "rig/session/see_through.h"

#include <gtest/gtest.h>

#include "devices/fusion/rotation.h"
#include "rig/failure.h"
#include "rig/live/live_window.h"
#include "rig/open_scene.h"
#include "rig/scenario/keys.h"
#include "rig/session/device_streams.h"

namespace foverig {
namespace {

Scenario with_room() {
    Scenario s;
    s.see_through.camera = "sim";
    s.motion.head = "look";
    return s;
}

TEST(SeeThrough, IsNotThereUnlessItIsAskedFor) {
    ManualClock clock;
    const Scenario s;
    const auto world = make_world(s, clock);
    EXPECT_EQ(SeeThrough::open(s, *world, clock), nullptr);
}

TEST(SeeThrough, ShowsTheNewestPictureOfTheHeadAsItWas) {
    ManualClock clock;
    const Scenario s = with_room();
    const auto world = make_world(s, clock);
    DeviceStreams devices(s, *world, clock, nullptr);
    const auto camera = SeeThrough::open(s, *world, clock);
    EXPECT_FALSE(camera->picture(clock.now(), devices.head())) << "nothing came yet";
    EXPECT_FALSE(camera->instants());
    devices.run_for(from_seconds(1.0));
    const auto seen = camera->picture(clock.now(), devices.head());
    ASSERT_TRUE(seen);
    EXPECT_TRUE(seen->changed);
    EXPECT_EQ(seen->width_px, 640);
    EXPECT_EQ(seen->srgb.size(), 640u * 480u * 3u);
    EXPECT_NEAR(seen->tan_half_width, std::tan(glm::radians(30.0)), 1e-12);
    // The newest frame arrived at most a thirtieth of a second ago, 35 ms after its exposure.
    const double age_ms = to_ms(clock.now() - camera->instants()->taken);
    EXPECT_GE(age_ms, 35.0);
    EXPECT_LE(age_ms, 35.0 + 34.0);
    const dquat truth = *world->true_head(camera->instants()->taken);
    EXPECT_LT(glm::degrees(angle_between(seen->world_from_camera, truth)), 0.5);
    EXPECT_FALSE(camera->picture(clock.now(), devices.head())->changed);
    devices.run_for(from_seconds(1.0));
    EXPECT_TRUE(camera->picture(clock.now(), devices.head())->changed);
    const DeviceRecord record = camera->record();
    EXPECT_EQ(record.name, "see_through");
    EXPECT_EQ(record.counts.samples, 59u) << "all that came, though two were shown";
    EXPECT_NEAR(record.rate_hz.value(), 30.0, 0.01);
    EXPECT_EQ(record.counts.lost, 0u);
}

TEST(SeeThrough, ACameraThatIsNotThereIsSaid) {
    ManualClock clock;
    Scenario s;
    s.see_through.camera = "/nowhere/video7";
    const auto world = make_world(s, clock);
    EXPECT_THROW(SeeThrough::open(s, *world, clock), DeviceError);
}

TEST(SeeThrough, NeedsAWindow) {
    EXPECT_THROW(LiveWindow::open(with_room()), UsageError);
}

TEST(SeeThrough, MakesTheScenesBackgroundTheDisplaysKey) {
    Scenario s;
    s.scene = "cornell";
    s.scene_detail = 0.1;
    const vec3 key(kNothingMet[0], kNothingMet[1], kNothingMet[2]);
    EXPECT_NE(open_scene(s)->background, key);
    EXPECT_EQ(open_scene(s, true)->background, key);
    EXPECT_EQ(vec3(unpack_half4(pack_half4(vec4(key, 0.0F)))), key) << "exact in halves";
}

TEST(SeeThrough, TheKeyTakesNodesAndIdentifiersOnly) {
    Scenario s;
    const Key* key = find_key("see_through.camera");
    ASSERT_NE(key, nullptr);
    for (const char* good : {"", "sim", "/dev/video3", "046d:0825"}) {
        EXPECT_FALSE(key->set(s, KeyValue(std::string(good)))) << good;
        EXPECT_EQ(s.see_through.camera, good);
    }
    for (const char* bad : {"webcam", "046d", "video0"}) {
        EXPECT_TRUE(key->set(s, KeyValue(std::string(bad)))) << bad;
    }
}

}  // namespace
}  // namespace foverig
