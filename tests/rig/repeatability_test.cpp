// Two lockstep runs at a fixed cost: same images, same frames.csv, whatever the threads.
#include <gtest/gtest.h>

#include "tests/rig/program_bench.h"

namespace foverig {
namespace {

using test::foverig;
using test::Outcome;
using test::same_bytes;
namespace fs = std::filesystem;

/// Enough tiles, history and noisy light that a race would have something to spoil: two eyes of 16
/// tiles, masks and textures, area light, occlusion, post-process, faulty devices.
constexpr const char* kBusy = R"(
scene = "atrium"
scene_detail = 0.3
pipeline = "reprojected"
clock = "lockstep"
cost = "fixed:9"
frames = 8
settle_s = 0.05
[display]
eye_width_px = 200
eye_height_px = 248
[lights]
areas_m = [-1, 4, -1, 2, 0, 0, 0, 0, 2]
[lighting]
area_samples = 4
ao_samples = 4
[faults]
dk2.noise = 1.0
gaze.dropout = 0.1
[images]
frames = [0, 3, 7]
error = false
)";

class Repeatability : public test::ProgramBench {
  protected:
    Outcome busy_run(const fs::path& out, int threads) const {
        const fs::path scenario = root_ / "busy.toml";
        std::ofstream(scenario) << kBusy;
        return foverig({"run", scenario.string(), "--out", (root_ / out).string(), "--set",
                        "threads=" + std::to_string(threads)});
    }

    void expect_same(const fs::path& a, const fs::path& b) const {
        EXPECT_TRUE(same_bytes(root_ / a / "frames.csv", root_ / b / "frames.csv"));
        std::size_t images = 0;
        for (const auto& image : fs::directory_iterator(root_ / a / "images")) {
            ++images;
            EXPECT_TRUE(same_bytes(image.path(), root_ / b / "images" / image.path().filename()))
                << image.path();
        }
        EXPECT_GE(images, 3U * (2U * 3U + 1U)) << "final and two masks an eye, and the panel";
    }
};

TEST_F(Repeatability, ByteForByteAtFixedCostOnAnyNumberOfThreads) {
    for (const auto& [out, threads] : {std::pair{"two", 2}, {"again", 2}, {"one", 1}}) {
        const Outcome run = busy_run(out, threads);
        ASSERT_EQ(run.code, 0) << run.err;
    }
    expect_same("two", "again");
    expect_same("two", "one");
}

}  // namespace
}  // namespace foverig
