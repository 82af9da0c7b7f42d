#include "rig/live/target_window.h"

#include <epoxy/gl.h>
#include <imgui.h>

#include "devices/gaze_angles.h"
#include "rig/live/gaze_ring.h"
#include "rig/live/open_window.h"
#include "simulators/gaze/tracker_geometry.h"

namespace foverig {
namespace {

// A disc with a hole to look into. Thaler et al. 2013 (Vision Research 76) use 0.6 and 0.2 degrees;
// the DK2 has 10 pixels a degree, a window fewer.
constexpr double kDisc_deg = 0.75, kHole_deg = 0.25;  // radii
constexpr ImU32 kWaiting = IM_COL32(255, 255, 255, 255);
constexpr ImU32 kWatched = IM_COL32(80, 200, 120, 255);
constexpr ImU32 kHole = IM_COL32(0, 0, 0, 255);
constexpr ImU32 kText = IM_COL32(255, 255, 255, 160);
constexpr double kTextBelow = 0.55;  // of the half height, in the eye's NDC

ImVec2 im(const dvec2& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y)};
}

}  // namespace

std::unique_ptr<TargetWindow> TargetWindow::open(const Scenario& scenario) {
    if (scenario.display.kind == "virtual") return nullptr;
    return std::unique_ptr<TargetWindow>(
        new TargetWindow(scenario, open_window(scenario, "foverig: calibration")));
}

TargetWindow::TargetWindow(const Scenario& scenario, std::unique_ptr<window::Window> window)
    : window_(std::move(window)),
      map_(scenario.display.distortion),
      frame_s_(1.0 / scenario.display.rate_hz) {}

void TargetWindow::show(const Picture& picture) {
    window_->poll();
    const PanelView view = window_->view();
    glViewport(0, 0, view.framebuffer().width, view.framebuffer().height);
    glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    const PanelView landscape(overlay_.begin(view, frame_s_), false);
    if (picture.target_deg) draw_target(landscape, picture);
    draw_text(landscape, picture.text);
    overlay_.end(view);
    window_->swap();
}

void TargetWindow::draw_target(const PanelView& landscape, const Picture& picture) const {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const motion::EyeState looking{.direction = gaze_direction(*picture.target_deg),
                                   .vergence_m = picture.distance_m};
    for (const Eye eye : {Eye::left, Eye::right}) {
        const Side side = eye == Eye::left ? Side::left : Side::right;
        const dvec3 direction = eye_direction(side, looking);
        for (const auto& [radius_deg, colour] :
             {std::pair{kDisc_deg, picture.watched ? kWatched : kWaiting}, {kHole_deg, kHole}}) {
            std::vector<ImVec2> rim;
            for (const dvec2& ndc : gaze_ring(eye, direction, radius_deg, map_))
                rim.push_back(im(landscape.at_px({eye, ndc})));
            list.AddConvexPolyFilled(rim.data(), static_cast<int>(rim.size()), colour);
        }
    }
}

void TargetWindow::draw_text(const PanelView& landscape, const std::string& text) const {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    for (const Eye eye : {Eye::left, Eye::right}) {
        const ImVec2 at = im(landscape.at_px({eye, dvec2(0.0, -kTextBelow)}));
        list.AddText({at.x - 0.5F * size.x, at.y}, kText, text.c_str());
    }
}

}  // namespace foverig
