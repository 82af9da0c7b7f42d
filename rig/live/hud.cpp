#include "rig/live/hud.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "rig/live/gaze_ring.h"

namespace foverig {
namespace {

constexpr ImU32 kGood = IM_COL32(80, 200, 120, 255);
constexpr ImU32 kBad = IM_COL32(235, 80, 60, 255);
constexpr ImU32 kLine = IM_COL32(255, 255, 255, 160);
constexpr ImU32 kInner = IM_COL32(255, 220, 60, 220);
constexpr ImU32 kOuter = IM_COL32(90, 190, 255, 220);
constexpr ImU32 kBack = IM_COL32(0, 0, 0, 120);

constexpr float kStripWidth = 360.0F, kStripHeight = 72.0F, kBarHeight = 14.0F;
constexpr double kStripBudgets = 2.0;  // the strip's height

std::string ms(const std::optional<double>& value) {
    return value ? fmt::format("{:.1f} ms", *value) : "-";
}

ImVec2 im(const dvec2& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y)};
}

void draw_strip(const std::vector<float>& frame_ms, double budget_ms, float scale) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size(kStripWidth * scale, kStripHeight * scale);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, kBack);
    const float step = size.x / static_cast<float>(RecentFrames::kShown);
    const auto height = [&](double time_ms) {
        return size.y * static_cast<float>(std::min(1.0, time_ms / (kStripBudgets * budget_ms)));
    };
    for (std::size_t i = 0; i < frame_ms.size(); ++i) {
        const float x = at.x + step * static_cast<float>(i);
        list.AddRectFilled({x, at.y + size.y - height(frame_ms[i])}, {x + step, at.y + size.y},
                           frame_ms[i] <= budget_ms ? kGood : kBad);
    }
    const float y = at.y + size.y - height(budget_ms);
    list.AddLine({at.x, y}, {at.x + size.x, y}, kLine);
    ImGui::Dummy(size);
}

void draw_bar(double share, float scale) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size(kStripWidth * scale, kBarHeight * scale);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, kBack);
    list.AddRectFilled(at,
                       {at.x + size.x * static_cast<float>(std::min(1.0, share)), at.y + size.y},
                       share <= 1.0 ? kGood : kBad);
    ImGui::Dummy(size);
}

}  // namespace

Hud::Hud(const Scenario& scenario, double rate_hz)
    : foveation_(scenario.render.foveation),
      eyes_(static_cast<std::size_t>(scenario.display.eyes)),
      budget_ms_(1000.0 / rate_hz),
      map_(scenario.display.distortion) {}

void Hud::draw(const PanelView& view) {
    const SizePx size = overlay_.begin(view, 1e-3 * budget_ms_);
    draw_gaze(PanelView(size, false));
    draw_numbers(overlay_.scale());
    overlay_.end(view);
}

void Hud::draw_numbers(double scale) const {
    const auto s = static_cast<float>(scale);
    const auto& times = frames_.frame_ms();
    const double frame_ms = times.empty() ? 0.0 : static_cast<double>(times.back());
    ImGui::SetNextWindowPos({16.0F * s, 16.0F * s});
    ImGui::SetNextWindowBgAlpha(0.65F);
    ImGui::Begin("numbers", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings);
    ImGui::Text("frame %6.1f ms of %.1f ms", frame_ms, budget_ms_);
    draw_bar(frame_ms / budget_ms_, s);
    draw_strip(times, budget_ms_, s);
    ImGui::Text("motion to photon %s, warped %s", ms(frames_.motion_to_photon_ms()).c_str(),
                ms(frames_.warp_to_photon_ms()).c_str());
    ImGui::Text("gaze to photon   %s", ms(frames_.gaze_to_photon_ms()).c_str());
    if (frames_.see_through_to_photon_ms())
        ImGui::Text("camera to photon %s", ms(frames_.see_through_to_photon_ms()).c_str());
    ImGui::Text("dropped %llu frames, repeated %llu vsyncs",
                static_cast<unsigned long long>(frames_.dropped()),
                static_cast<unsigned long long>(frames_.repeated()));
    ImGui::Text("gaze rings %.0f and %.0f deg;  H hides this", foveation_.r0_deg,
                foveation_.r1_deg);
    ImGui::End();
}

void Hud::draw_gaze(const PanelView& landscape) const {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const PanelView::Rectangle& r = landscape.viewport();
    const float half = 0.5F * static_cast<float>(r.width_px);
    const float scale = 1e-3F * static_cast<float>(r.height_px);
    for (std::size_t i = 0; i < eyes_; ++i) {
        const Eye eye = i == 0 ? Eye::left : Eye::right;
        const dvec3 gaze(frames_.gaze()[i]);
        const float left = eye == Eye::left ? 0.0F : half;
        list.PushClipRect({left, 0.0F}, {left + half, static_cast<float>(r.height_px)});
        const auto at = [&](const dvec2& ndc) { return im(landscape.at_px({eye, ndc})); };
        for (const auto& [radius_deg, colour] :
             {std::pair{foveation_.r0_deg, kInner}, {foveation_.r1_deg, kOuter}}) {
            std::vector<ImVec2> line;
            for (const dvec2& ndc : gaze_ring(eye, gaze, radius_deg, map_)) line.push_back(at(ndc));
            list.AddPolyline(line.data(), static_cast<int>(line.size()), colour, 0, 2.0F * scale);
        }
        const ImVec2 dot = at(map_.ndc(eye, dvec2(gaze.x, gaze.y) / -gaze.z));
        list.AddCircleFilled(dot, 7.0F * scale, kBad);
        list.AddCircle(dot, 7.0F * scale, kLine, 0, 1.5F * scale);
        list.PopClipRect();
    }
}

}  // namespace foverig
