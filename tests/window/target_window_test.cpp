#include "rig/live/target_window.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "devices/gaze_angles.h"
#include "simulators/gaze/tracker_geometry.h"
#include "tests/rig/program_bench.h"
#include "tests/window/pictures.h"
#include "tests/window/xvfb.h"

namespace foverig {
namespace {

class TargetWindowTest : public test::OnADesktop {
  protected:
    void SetUp() override {
        OnADesktop::SetUp();
        scenario_.display.kind = "window";
        scenario_.clock = "wall";
        scenario_.window.width_px = 1920;
        window_ = TargetWindow::open(scenario_);
        ASSERT_NE(window_, nullptr);
    }
    test::Shot shown(const TargetWindow::Picture& picture) {
        window_->show(picture);
        window_->show(picture);  // both buffers
        return test::shot_of_framebuffer(1920, 1080);
    }
    /// Where an eye sees the target, in the window.
    static dvec2 place_px(Eye eye, const dvec2& target_deg) {
        const dvec3 d = eye_direction(eye == Eye::left ? Side::left : Side::right,
                                      {.direction = gaze_direction(target_deg)});
        const PanelView view({1920, 1080}, false);
        return view.at_px({eye, EyeMap(true).ndc(eye, dvec2(d.x, d.y) / -d.z)});
    }

    Scenario scenario_;
    std::unique_ptr<TargetWindow> window_;
};

TEST_F(TargetWindowTest, PutsTheTargetBeforeBothEyes) {
    const dvec2 target(-12.0, 8.0);
    const test::Shot shot = shown({.target_deg = target, .text = "look at the dot"});
    test::keep(shot, "calibration_target");
    for (const Eye eye : {Eye::left, Eye::right}) {
        const dvec2 at = place_px(eye, target);
        const int x = static_cast<int>(at.x), y = static_cast<int>(at.y);
        EXPECT_LT(shot.at(x, y)[0], 60) << "the hole to look into";
        EXPECT_GT(shot.at(x + 5, y)[0], 180) << "the disc";
        EXPECT_EQ(shot.at(x + 14, y)[0], 0);
    }
    const test::Shot watched = shown({.target_deg = target, .watched = true});
    const dvec2 at = place_px(Eye::left, target);
    const auto* disc = watched.at(static_cast<int>(at.x) + 5, static_cast<int>(at.y));
    EXPECT_GT(disc[1], disc[0] + 60) << "green while the tracker watches";
}

TEST_F(TargetWindowTest, ShowsNothingBetweenTargets) {
    const test::Shot shot = shown({});
    EXPECT_EQ(*std::max_element(shot.rgb.begin(), shot.rgb.end()), 0);
}

class CalibrateInAWindow : public test::ProgramBench {};

TEST_F(CalibrateInAWindow, TakesTheTimeThatAPersonTakes) {
    const test::Xvfb desktop;
    ASSERT_TRUE(desktop.ready());
    const auto file = root_ / "calibration.json";
    const auto run = test::foverig({"calibrate", "--points", "1", "--display", "window", "--set",
                                    "faults.gaze.user=1", "--out", file.string()});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.err.find("a window of 1280x720: look at the dots"), std::string::npos) << run.err;
    EXPECT_TRUE(std::filesystem::exists(file));
}

}  // namespace
}  // namespace foverig
