#include "rig/output/kept_images.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "tests/rig/session/fake_renderer.h"

namespace foverig {
namespace {

namespace fs = std::filesystem;

FrameInput input_of(std::uint32_t frame) {
    return {.frame = frame, .eyes = {EyeInput{}, EyeInput{}}};
}

std::vector<std::uint32_t> kept_of(const Scenario& scenario, std::uint32_t frames) {
    KeptImages images(scenario);
    FakeRenderer renderer;
    std::vector<std::uint32_t> kept;
    for (std::uint32_t i = 0; i < frames; ++i) {
        const double share = static_cast<double>(i + 1) / frames;
        if (images.frame_done(input_of(i), renderer, share)) kept.push_back(i);
    }
    return kept;
}

TEST(KeptImages, SpreadsOverTheRunAndEndsWithTheLastFrame) {
    EXPECT_EQ(kept_of({}, 90), (std::vector<std::uint32_t>{29, 59, 89}));
    EXPECT_EQ(kept_of({}, 2), (std::vector<std::uint32_t>{0, 1}));
}

TEST(KeptImages, KeepsExactlyTheFramesAskedFor) {
    Scenario s;
    s.images.frames = {0, 5};
    EXPECT_EQ(kept_of(s, 10), (std::vector<std::uint32_t>{0, 5}));
}

TEST(KeptImages, DisturbsNoFrameOnTheWallClock) {
    Scenario s;
    s.clock = "wall";
    EXPECT_EQ(kept_of(s, 10), (std::vector<std::uint32_t>{9}));
}

TEST(KeptImages, KeepsTheLastFrameOfARunThatEndedEarly) {
    KeptImages images(Scenario{});
    FakeRenderer renderer;
    images.run_done(input_of(4), renderer);
    EXPECT_FALSE(images.empty());
}

TEST(KeptImages, WritesWhatIsThereAndNamesIt) {
    const fs::path folder =
        fs::path(testing::TempDir()) / ("kept_images_" + std::to_string(getpid()));
    KeptImages images(Scenario{});
    FakeRenderer renderer;
    FakeRenderer full;
    images.run_done(input_of(7), renderer);
    images.compare_with(full, [] { return false; });
    const auto list = images.write(folder, nullptr);
    // Two eyes with final, full, sampling and error each; the fake has no resampling mask.
    EXPECT_EQ(list.size(), 8U);
    for (const auto& image : list) {
        EXPECT_TRUE(fs::exists(folder / image["file"].get<std::string>())) << image.dump();
        EXPECT_EQ(image["frame"], 7);
        if (image["kind"] == "error") {
            EXPECT_EQ(image["mean_absolute_error"], 0.0);
        }
    }
    fs::remove_all(folder);
}

TEST(Difference, IsSeenAndMagnified) {
    const Image black{1, 1, {vec3(0.0F)}};
    const Image grey{1, 1, {vec3(linear_from_srgb(0.05F))}};
    const Image apart = difference(black, grey, 8.0F);
    EXPECT_NEAR(srgb_from_linear(apart.pixels[0].x), 0.4, 1e-4);
    EXPECT_EQ(difference(grey, grey, 8.0F).pixels[0], vec3(0.0F));
}

}  // namespace
}  // namespace foverig
