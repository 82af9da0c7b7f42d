#include "rig/records/frames_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "rig/failure.h"
#include "rig/records/columns.h"

namespace foverig {
namespace {

HostTime at_ms(double ms) {
    return HostTime(from_seconds(ms * 1e-3));
}

FrameRecord shown_frame() {
    FrameRecord f;
    f.frame = 3;
    f.wake_up = at_ms(100);
    f.begin = at_ms(100.5);
    f.pose = {at_ms(99), at_ms(100)};
    f.submit = at_ms(110);
    f.present = at_ms(112);
    f.vsync = at_ms(113);
    f.shown_vsync = 8;
    f.photon = at_ms(121);
    f.render_ms = 9.25;
    f.passes = {{"trace_primary", 4.5}, {"shade", 0.1}};
    f.rays.primary = 12'345'678'901ULL;
    return f;
}

std::filesystem::path written(const std::string& text) {
    // Tests run side by side, each as a process.
    const auto file = std::filesystem::path(testing::TempDir()) /
                      ("frames_csv_test_" + std::to_string(getpid()) + ".csv");
    std::ofstream(file) << text;
    return file;
}

TEST(FramesCsv, ReadsBackWhatWasWritten) {
    const auto table =
        read_frames_csv(written(frames_csv({shown_frame(), shown_frame()}, WallTimes::keep)));
    EXPECT_EQ(table.frames, 2U);
    EXPECT_EQ(table.column("vsync_ns")[1], 113e6);
    EXPECT_EQ(table.column("frame_time_ms")[0], 11.5);
    EXPECT_EQ(table.column("motion_to_photon_ms")[0], 22.0);
    EXPECT_EQ(table.column("rays_primary")[0], 12345678901.0);
    EXPECT_EQ(table.column("pass.trace_primary_ms")[0], 4.5);
    EXPECT_EQ(table.column("render_ms")[0], 9.25);
}

TEST(FramesCsv, WritesAbsentAsNaAndNotAsZero) {
    FrameRecord dropped = shown_frame();
    dropped.drop();
    const auto table = read_frames_csv(written(frames_csv({dropped}, WallTimes::keep)));
    EXPECT_EQ(table.column("gaze_ns")[0], std::nullopt);
    EXPECT_EQ(table.column("gaze_to_photon_ms")[0], std::nullopt);
    EXPECT_EQ(table.column("photon_ns")[0], std::nullopt);
    EXPECT_EQ(table.column("dropped")[0], 1.0);
    EXPECT_EQ(table.column("late")[0], 1.0);
}

TEST(FramesCsv, GivesAPassThatDidNotRunNoTime) {
    FrameRecord other = shown_frame();
    other.passes = {{"reproject", 2.0}};
    const auto table =
        read_frames_csv(written(frames_csv({shown_frame(), other}, WallTimes::keep)));
    EXPECT_EQ(table.column("pass.shade_ms")[1], std::nullopt);
    EXPECT_EQ(table.column("pass.reproject_ms")[0], std::nullopt);
    EXPECT_EQ(table.column("pass.reproject_ms")[1], 2.0);
}

TEST(FramesCsv, LeavesWallTimesOutWhereTheCostIsFixed) {
    FrameRecord slower = shown_frame();
    slower.render_ms = 77.0;
    slower.passes = {{"shade", 50.0}};
    EXPECT_EQ(frames_csv({shown_frame()}, WallTimes::omit), frames_csv({slower}, WallTimes::omit));
}

TEST(FramesCsv, KeepsInstantsExact) {
    FrameRecord f = shown_frame();
    f.present = HostTime(Nanoseconds(9'007'199'254'740'993));  // 2^53 + 1: no double holds it
    EXPECT_THAT(frames_csv({f}, WallTimes::omit), testing::HasSubstr(",9007199254740993,"));
}

TEST(FramesCsv, NamesFileAndLineOfABrokenCell) {
    try {
        read_frames_csv(written("frame,x\n0,1\n1,abc\n"));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr(".csv:3"));
    }
    EXPECT_THROW(read_frames_csv(written("frame,x\n0\n")), InputError);
    EXPECT_THROW(read_frames_csv("no/such/frames.csv"), InputError);
}

TEST(FrameColumns, AreAllDifferentAndDefined) {
    std::vector<std::string> ids;
    for (const Column& column : frame_columns()) ids.push_back(column.id);
    std::sort(ids.begin(), ids.end());
    EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end());
}

}  // namespace
}  // namespace foverig
