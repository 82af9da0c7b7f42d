#include "rig/live/overlay.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>

namespace foverig {
namespace {

constexpr double kUnscaledHeight_px = 720.0;

SizePx landscape_of(const PanelView& view) {
    const PanelView::Rectangle& r = view.viewport();
    return view.turned() ? SizePx{r.height_px, r.width_px} : SizePx{r.width_px, r.height_px};
}

/// From the landscape picture's pixels to the framebuffer's.
void move_to(const PanelView& view, const SizePx& framebuffer, ImDrawData& data) {
    const PanelView::Rectangle& r = view.viewport();
    const auto left = static_cast<float>(r.x_px);
    const auto top = static_cast<float>(framebuffer.height - r.y_px - r.height_px);
    const auto bottom = top + static_cast<float>(r.height_px);
    const auto moved = [&](const ImVec2& p) {
        return view.turned() ? ImVec2(left + p.y, bottom - p.x) : ImVec2(left + p.x, top + p.y);
    };
    for (int i = 0; i < data.CmdListsCount; ++i) {
        ImDrawList& list = *data.CmdLists[i];
        for (ImDrawVert& vertex : list.VtxBuffer) vertex.pos = moved(vertex.pos);
        for (ImDrawCmd& command : list.CmdBuffer) {
            const ImVec4 clip = command.ClipRect;
            const ImVec2 a = moved({clip.x, clip.y}), b = moved({clip.z, clip.w});
            command.ClipRect = {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x),
                                std::max(a.y, b.y)};
        }
    }
    data.DisplaySize = {static_cast<float>(framebuffer.width),
                        static_cast<float>(framebuffer.height)};
}

}  // namespace

Overlay::Overlay() : context_(ImGui::CreateContext()) {
    ImGui::GetIO().IniFilename = nullptr;
    ImGui_ImplOpenGL3_Init("#version 330");
}

Overlay::~Overlay() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext(context_);
}

SizePx Overlay::begin(const PanelView& view, double frame_s) {
    const SizePx size = landscape_of(view);
    scale_ = std::max(1.0, size.height / kUnscaledHeight_px);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(size.width), static_cast<float>(size.height)};
    io.DeltaTime = static_cast<float>(frame_s);
    io.FontGlobalScale = static_cast<float>(scale_);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    return size;
}

void Overlay::end(const PanelView& view) {
    ImGui::Render();
    ImDrawData& data = *ImGui::GetDrawData();
    move_to(view, view.framebuffer(), data);
    ImGui_ImplOpenGL3_RenderDrawData(&data);
}

}  // namespace foverig
