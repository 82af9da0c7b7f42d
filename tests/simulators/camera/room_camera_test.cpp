#include "simulators/camera/room_camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "devices/camera/video_camera.h"

namespace foverig {
namespace {

using Rgb = std::array<int, 3>;

HostTime at_s(double s) {
    return HostTime(from_seconds(s));
}

dquat turned_left(double deg) {
    return glm::angleAxis(glm::radians(deg), dvec3(0, 1, 0));
}

Rgb pixel(const camera::RgbImage& image, int x, int y) {
    const std::uint8_t* p = image.bytes.data() + 3 * (y * image.width_px + x);
    return {p[0], p[1], p[2]};
}

camera::Lens usual(double fov_deg = 60.0) {
    return camera::ideal_lens(RoomCamera::kWidth_px, RoomCamera::kHeight_px, fov_deg);
}

camera::RgbImage seen(const dquat& world_from_camera, const camera::AnyLens& lens = usual()) {
    ManualClock clock;
    RoomCamera room(
        clock,
        [&](HostTime) {
            return RigidPose{world_from_camera, dvec3(0)};
        },
        lens);
    camera::VideoCamera camera(room);
    clock.sleep_until(at_s(0.1));
    EXPECT_TRUE(camera.read_until(clock.now()));
    return *camera.image();
}

void expect_hue(const Rgb& got, const dvec3& colour) {
    const double scale = static_cast<double>(got[1]) / colour.g;
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(got[static_cast<std::size_t>(c)], scale * colour[c], 6.0) << c;
    }
}

TEST(RoomCamera, HasAFrameEachThirtiethOfASecondOfTheTimeBefore) {
    ManualClock clock;
    std::vector<HostTime> exposed;
    RoomCamera room(
        clock,
        [&](HostTime t) {
            exposed.push_back(t);
            return RigidPose{};
        },
        usual());
    std::uint32_t frames = 0;
    while (true) {
        const auto next = room.next(at_s(2.0));
        const auto* packet = std::get_if<Packet>(&next);
        if (packet == nullptr) break;
        const auto header = camera::decode_any_header(packet->bytes);
        ASSERT_TRUE(header);
        EXPECT_EQ(header->sequence, frames);
        const HostTime stamp = packet->arrival - std::chrono::microseconds(header->age_us);
        EXPECT_EQ(exposed.back(), stamp - RoomCamera::kToStamp);
        EXPECT_EQ(clock.now(), packet->arrival);
        ++frames;
    }
    EXPECT_EQ(frames, 59u);  // the next arrives at 1.967 s + 0.035 s
}

TEST(RoomCamera, EachWallHasItsColour) {
    const dvec3 ahead(0.45, 0.75, 0.40), left(0.85, 0.35, 0.30), behind(0.80, 0.70, 0.30);
    expect_hue(pixel(seen(turned_left(0)), 310, 230), ahead);
    expect_hue(pixel(seen(turned_left(90)), 310, 230), left);
    expect_hue(pixel(seen(turned_left(180)), 310, 230), behind);
    const dquat up = glm::angleAxis(glm::radians(80.0), dvec3(1, 0, 0));
    expect_hue(pixel(seen(up), 310, 230), {0.90, 0.90, 0.88});
}

/// The wall ahead is 3 m away and its tiles half a metre wide: their edges lie at tangents of
/// sixths.
TEST(RoomCamera, TilesLieWhereTheFieldOfViewPutsThem) {
    for (const double fov_deg : {50.0, 80.0}) {
        const camera::RgbImage image = seen(turned_left(0), usual(fov_deg));
        const double px = 320.0 / std::tan(glm::radians(0.5 * fov_deg));
        for (int edge = -1; edge <= 1; ++edge) {
            const int x = static_cast<int>(std::lround(320.0 + px * edge / 6.0));
            EXPECT_GT(std::abs(pixel(image, x - 3, 230)[1] - pixel(image, x + 3, 230)[1]), 40);
            EXPECT_EQ(pixel(image, x + 3, 230), pixel(image, x + 9, 230));
        }
    }
}

// The same edges where the lens projects them, which is held to OpenCV's in its own test.
TEST(RoomCamera, ALensBendsThem) {
    const camera::Lens lens{400.0, 410.0, 300.0, 230.0, -0.25, 0.05, 0.002, -0.001, 0.0};
    const camera::RgbImage image = seen(turned_left(0), lens);
    for (int edge = -3; edge <= 3; ++edge) {
        const double at = lens.project({edge / 6.0, 0.02, 1.0}).value().x;
        const int x = static_cast<int>(std::lround(at)), y = 238;
        EXPECT_GT(std::abs(pixel(image, x - 3, y)[1] - pixel(image, x + 3, y)[1]), 40) << edge;
        EXPECT_EQ(pixel(image, x + 3, y), pixel(image, x + 9, y)) << edge;
    }
}

// A quarter turn aside lies at the angle's place, where a pinhole has none; the wall's edge at
// 45 degrees. Beyond the picture of the sphere there is nothing.
TEST(RoomCamera, AFisheyeSeesTheWallsBesideIt) {
    const double degree_px = 2.0;
    const camera::FisheyeLens lens({.fx_px = degree_px / glm::radians(1.0),
                                    .fy_px = degree_px / glm::radians(1.0),
                                    .cx_px = 319.5,
                                    .cy_px = 239.5});
    const camera::RgbImage image = seen(turned_left(0), lens);
    const Rgb right = pixel(image, 319 + 180, 236), corner = pixel(image, 319 + 94, 236);
    EXPECT_GT(right[2], right[0]) << "blue";
    EXPECT_GT(corner[2], corner[0]) << "blue just beyond the edge";
    const Rgb ahead = pixel(image, 319 + 86, 236), left = pixel(image, 319 - 180, 236);
    EXPECT_GT(ahead[1], ahead[2]) << "green just before it";
    EXPECT_GT(left[0], left[2]) << "red";
    const camera::FisheyeLens narrow({.fx_px = 50, .fy_px = 50, .cx_px = 319.5, .cy_px = 239.5});
    for (const int level : pixel(seen(turned_left(0), narrow), 319 + 200, 239))
        EXPECT_LE(level, 2) << "200 px of 50 a radian are more than half a turn";
}

}  // namespace
}  // namespace foverig
