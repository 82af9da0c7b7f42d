#pragma once
// The golden SGZ1 sample of DEVICES.md 4.5.3.
#include "devices/gaze/frames.h"

namespace foverig::test {

constexpr const char* kGoldenSampleHex =
    "53 47 5a 31 01 00 01 01 f8 00 20 00 2a 00 00 00"
    "00 2b 5c d5 e8 00 00 00 78 56 34 12 00 00 00 00"
    "00 10 a5 d4 e8 00 00 00 3c 00 00 00 58 02 0f 00"
    "00 00 80 42 00 00 7e 42 00 00 00 00 00 00 00 00"
    "00 00 b0 c1 00 00 00 00 00 00 00 00 00 00 80 3f"
    "00 00 f0 43 00 00 07 44 00 00 00 42 00 00 00 00"
    "00 00 b0 c1 00 00 00 00 00 00 00 00 00 00 80 3f"
    "00 00 f0 43 00 00 07 44 00 00 fe 41 00 00 00 00"
    "00 00 20 c1 00 00 00 40 00 00 20 41 00 00 48 42"
    "00 00 80 3f 33 33 73 3f 03 00 00 00 00 00 00 c2"
    "00 00 00 00 00 00 b0 c1 00 00 00 00 00 00 00 00"
    "00 00 80 3f 00 00 b4 44 00 00 07 44 00 00 fe c1"
    "00 00 00 00 00 00 20 c1 00 00 00 40 00 00 20 41"
    "00 00 48 42 00 00 80 3f 33 33 73 3f 03 00 00 00"
    "00 80 bb 44 00 00 c0 7f 35 0c 01 00 05 5a 00 00"
    "00 00 00 00 4d 45 50 4d";

inline gaze::SampleFrame golden_sample() {
    gaze::SampleFrame f;
    f.header = {.flags = gaze::frame_flag::simulated,
                .sequence = 42,
                .queued_ns = 1'000'012'000'000,
                .session = 0x12345678};
    f.exposure_ns = 1'000'000'000'000;
    f.camera_frame = 60;
    f.status = 0x000F;
    f.iod_mm = 64;
    f.ipd_mm = 63.5f;
    f.base_point_mm = {0, 0, -22};
    f.direction = {0, 0, 1};
    f.por_px = {480, 540};
    f.left = {.base_point_mm = {32, 0, -22},
              .direction = {0, 0, 1},
              .por_px = {480, 540},
              .pupil_mm = {31.75f, 0, -10},
              .pupil_radius_mm = 2,
              .lens_distance_mm = 10,
              .screen_distance_mm = 50,
              .openness = 1,
              .confidence = 0.95f,
              .state = gaze::EyeState::tracked};
    f.right = f.left;
    f.right.base_point_mm[0] = -32;
    f.right.por_px[0] = 1440;
    f.right.pupil_mm[0] = -31.75f;
    f.mapping_distance_mm = 1500;
    f.temperature_centi_c = 3125;
    f.calibration_id = 1;
    f.calibration_points = 5;
    f.calibration_quality = 90;
    return f;
}

}  // namespace foverig::test
