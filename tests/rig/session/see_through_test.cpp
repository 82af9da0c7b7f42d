#include "rig/session/see_through.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "devices/fusion/rotation.h"
#include "rig/failure.h"
#include "rig/live/live_window.h"
#include "rig/open_scene.h"
#include "rig/require_devices.h"
#include "rig/scenario/keys.h"
#include "rig/scenario/parse.h"
#include "rig/session/device_streams.h"
#include "rig/session/see_through_lens.h"
#include "simulators/replay/recording.h"

namespace foverig {
namespace {

Scenario with_room() {
    Scenario s;
    s.see_through.camera = "sim";
    s.motion.head = "look";
    return s;
}

constexpr auto kAsked = DeviceStreams::SeesThrough::where_asked;

TEST(SeeThrough, IsNotThereUnlessItIsAskedFor) {
    ManualClock clock;
    const Scenario s;
    const auto world = make_world(s, clock);
    EXPECT_EQ(DeviceStreams(s, *world, clock, nullptr, kAsked).see_through(), nullptr);
    const Scenario asked = with_room();
    const auto with = make_world(asked, clock);
    EXPECT_EQ(DeviceStreams(asked, *with, clock, nullptr).see_through(), nullptr) << "not shown";
}

TEST(SeeThrough, ShowsTheNewestPictureOfTheHeadAsItWas) {
    ManualClock clock;
    const Scenario s = with_room();
    const auto world = make_world(s, clock);
    DeviceStreams devices(s, *world, clock, nullptr, kAsked);
    SeeThrough* camera = devices.see_through();
    ASSERT_NE(camera, nullptr);
    EXPECT_FALSE(camera->picture(devices.head())) << "nothing came yet";
    EXPECT_FALSE(camera->instants());
    devices.run_for(from_seconds(1.0));
    const auto seen = camera->picture(devices.head());
    ASSERT_TRUE(seen);
    EXPECT_TRUE(seen->changed);
    EXPECT_EQ(seen->width_px, 640);
    EXPECT_EQ(seen->srgb.size(), 640u * 480u * 3u);
    EXPECT_EQ(std::get<camera::Lens>(seen->lens), camera::ideal_lens(640, 480, 60.0));
    // The newest frame arrived at most a thirtieth of a second ago, 35 ms after its exposure.
    const double age_ms = to_ms(clock.now() - camera->instants()->taken);
    EXPECT_GE(age_ms, 35.0);
    EXPECT_LE(age_ms, 35.0 + 34.0);
    const dquat truth = *world->true_head(camera->instants()->taken);
    EXPECT_LT(glm::degrees(angle_between(seen->world_from_camera, truth)), 0.5);
    EXPECT_FALSE(camera->picture(devices.head())->changed);
    devices.run_for(from_seconds(1.0));
    EXPECT_TRUE(camera->picture(devices.head())->changed);
    const DeviceRecord record = devices.records().back();
    EXPECT_EQ(record.name, "see_through");
    EXPECT_EQ(record.origin, Origin::simulated);
    EXPECT_EQ(record.counts.samples, 59u) << "all that came, though two were shown";
    EXPECT_NEAR(record.rate_hz.value(), 30.0, 0.01);
    EXPECT_EQ(record.counts.lost, 0u);
}

TEST(SeeThrough, ACameraThatIsNotThereIsSaid) {
    ManualClock clock;
    Scenario s;
    s.see_through.camera = "/nowhere/video7";
    const auto world = make_world(s, clock);
    EXPECT_THROW(world->see_through_camera(), DeviceError);
    EXPECT_EQ(world->origin("see_through"), Origin::hardware) << "though all else is simulated";
    EXPECT_EQ(world->origin("dk2"), Origin::simulated);
}

TEST(SeeThrough, ACameraOnADeskNeedsTheWallsClock) {
    Scenario s;
    EXPECT_NO_THROW(require_see_through(s));
    s.see_through.camera = "046d:0825";
    EXPECT_THROW(require_see_through(s), UsageError);
    s.devices = "replay:desk.mcap";
    EXPECT_NO_THROW(require_see_through(s)) << "its frames are recorded";
    s.devices = "sim";
    s.clock = "wall";
    EXPECT_NO_THROW(require_see_through(s));
}

class RecordedSeeThrough : public testing::Test {
  protected:
    void SetUp() override { std::filesystem::remove(file_); }
    void TearDown() override { std::filesystem::remove(file_); }

    struct Seen {
        std::vector<std::uint8_t> picture;
        SampleInstants instants;
        DeviceRecord record;
    };
    Seen run(const Scenario& s, SessionRecording* recording) {
        ManualClock clock;
        const auto world = make_world(s, clock);
        DeviceStreams devices(s, *world, clock, recording, kAsked);
        devices.run_for(from_seconds(1.0));
        const auto picture = devices.see_through()->picture(devices.head());
        EXPECT_TRUE(picture);
        return {{picture->srgb.begin(), picture->srgb.end()},
                *devices.see_through()->instants(),
                devices.records().back()};
    }
    Scenario replaying(Scenario s) const {
        s.devices = "replay:" + file_;
        return s;
    }

    std::string file_ =
        testing::TempDir() + "foverig_see_through_" + std::to_string(getpid()) + ".mcap";
};

TEST_F(RecordedSeeThrough, ReplaysTheSameFramesAtTheSameTimes) {
    const Scenario s = with_room();
    Seen first;
    {
        SessionRecording recording(file_, s);
        first = run(s, &recording);
        const RecordingRecord written = recording.end();
        EXPECT_EQ(written.dropped, 0u);
        EXPECT_GT(written.bytes, 28u * 640 * 480 * 2);
    }
    const Recording opened = Recording::open(file_).value();
    const mcap::Channel* raw = opened.summary().channel("/see_through/raw");
    ASSERT_NE(raw, nullptr);
    EXPECT_EQ(raw->message_encoding, "x-fcf1");
    EXPECT_EQ(opened.summary().statistics->messages_of.at(raw->id), first.record.counts.samples);
    const Seen again = run(replaying(s), nullptr);
    EXPECT_EQ(again.picture, first.picture);
    EXPECT_EQ(again.instants.taken, first.instants.taken);
    EXPECT_EQ(again.instants.arrived, first.instants.arrived);
    EXPECT_EQ(again.record.name, "see_through");
    EXPECT_EQ(again.record.origin, Origin::recorded);
    EXPECT_EQ(again.record.recorded_from, Origin::simulated);
    EXPECT_EQ(again.record.counts.samples, first.record.counts.samples);
    EXPECT_EQ(again.record.rate_hz, first.record.rate_hz);
}

TEST_F(RecordedSeeThrough, ARecordingWithoutItsFramesSaysSo) {
    {
        const Scenario without;
        ManualClock clock;
        const auto world = make_world(without, clock);
        SessionRecording recording(file_, without);
        DeviceStreams devices(without, *world, clock, &recording, kAsked);
        devices.run_for(from_seconds(0.2));
        recording.end();
    }
    ManualClock clock;
    const Scenario s = replaying(with_room());
    const auto world = make_world(s, clock);
    EXPECT_THROW(world->see_through_camera(), InputError);
}

TEST(SeeThrough, ALensIsThatOfTheSizeThatIsAskedForInProportion) {
    SeeThroughSettings s;
    s.lens_px = {500.0, 510.0, 330.0, 250.0};
    s.distortion = {-0.3, 0.1, 0.001, -0.002, -0.01};
    const camera::Lens asked{500.0, 510.0, 330.0, 250.0, -0.3, 0.1, 0.001, -0.002, -0.01};
    EXPECT_EQ(std::get<camera::Lens>(lens_of(s, 640, 480)), asked);
    const auto half = std::get<camera::Lens>(lens_of(s, 320, 240));
    // A direction falls on the same place of the picture.
    const dvec3 ahead(0.2, -0.1, 1.0);
    const dvec2 whole_px = asked.project(ahead).value(), half_px = half.project(ahead).value();
    EXPECT_NEAR((half_px.x + 0.5) / 320, (whole_px.x + 0.5) / 640, 1e-12);
    EXPECT_NEAR((half_px.y + 0.5) / 240, (whole_px.y + 0.5) / 480, 1e-12);
}

TEST(SeeThrough, AFisheyeIsOneWhereItIsCalibratedAsOne) {
    SeeThroughSettings s;
    s.fisheye = {0.0, 0.0, 0.0, 0.0};
    s.fov_deg = 160.0;
    // The edges of the picture, half a pixel beyond the centres of the outermost, are 160 apart.
    const auto ideal = std::get<camera::FisheyeLens>(lens_of(s, 640, 480));
    const dvec3 left = ideal.ray_at({-0.5, 239.5}).value();
    EXPECT_NEAR(glm::degrees(std::atan2(-left.x, left.z)), 80.0, 1e-9);
    s.fisheye = {-0.01, 0.02, -0.003, 0.0004};
    s.lens_px = {300.0, 310.0, 330.0, 250.0};
    const camera::FisheyeLens::Numbers whole{
        300.0, 310.0, 330.0, 250.0, {-0.01, 0.02, -0.003, 4e-4}};
    EXPECT_EQ(std::get<camera::FisheyeLens>(lens_of(s, 640, 480)).numbers(), whole);
}

TEST(SeeThrough, ALensHasOneModel) {
    Scenario s;
    s.see_through.distortion = {-0.3, 0.1, 0.0, 0.0, 0.0};
    EXPECT_NO_THROW(complete_scenario(s));
    s.see_through.fisheye = {0.0, 0.0, 0.0, 0.0};
    EXPECT_THROW(complete_scenario(s), UsageError);
}

TEST(SeeThrough, LensKeysTakeAllTheirNumbersOrNone) {
    Scenario s;
    const Key* lens = find_key("see_through.lens_px");
    const Key* bend = find_key("see_through.distortion");
    const Key* fisheye = find_key("see_through.fisheye");
    ASSERT_TRUE(lens != nullptr && bend != nullptr && fisheye != nullptr);
    using Numbers = std::vector<double>;
    EXPECT_FALSE(lens->set(s, KeyValue(Numbers{500, 500, 320, 240})));
    EXPECT_FALSE(bend->set(s, KeyValue(Numbers{-0.3, 0.1, 0, 0, 0})));
    EXPECT_EQ(s.see_through.lens_px.size(), 4u);
    for (const Numbers& bad : {Numbers{500}, Numbers{0, 500, 320, 240}, Numbers(8, 500.0),
                               Numbers{500, 500, 320, std::nan("")}})
        EXPECT_TRUE(lens->set(s, KeyValue(bad)));
    for (const Numbers& bad : {Numbers{-0.3}, Numbers(10, 0.0)})
        EXPECT_TRUE(bend->set(s, KeyValue(bad)));
    EXPECT_TRUE(bend->set(s, KeyValue(Numbers{-0.3, 0.1, 0, 0}))) << "a fisheye has four";
    EXPECT_FALSE(fisheye->set(s, KeyValue(Numbers{-0.01, 0.02, 0, 0})));
    EXPECT_TRUE(fisheye->set(s, KeyValue(Numbers{-0.3, 0.1, 0, 0, 0})));
    EXPECT_FALSE(lens->set(s, KeyValue(Numbers{})));
    EXPECT_TRUE(s.see_through.lens_px.empty());
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
