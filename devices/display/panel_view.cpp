#include "devices/display/panel_view.h"

#include <algorithm>
#include <cmath>

namespace foverig {
namespace {

constexpr SizePx kPanel{2 * Dk2Optics::kEyePanel.width, Dk2Optics::kEyePanel.height};

}  // namespace

PanelView::PanelView(const SizePx& framebuffer, bool turned)
    : framebuffer_(framebuffer), turned_(turned) {
    const double panel_width = turned ? kPanel.height : kPanel.width;
    const double panel_height = turned ? kPanel.width : kPanel.height;
    const double scale =
        std::min(framebuffer.width / panel_width, framebuffer.height / panel_height);
    viewport_.width_px = std::max(1, static_cast<int>(std::lround(panel_width * scale)));
    viewport_.height_px = std::max(1, static_cast<int>(std::lround(panel_height * scale)));
    viewport_.x_px = (framebuffer.width - viewport_.width_px) / 2;
    viewport_.y_px = (framebuffer.height - viewport_.height_px) / 2;
}

glm::dmat2 PanelView::viewport_from_panel() const {
    // Columns: where the panel's x and y go. Right goes up, up goes left.
    return turned_ ? glm::dmat2(dvec2(0.0, 1.0), dvec2(-1.0, 0.0)) : glm::dmat2(1.0);
}

PanelView::Rectangle PanelView::latency_pixel() const {
    const int x = turned_ ? viewport_.x_px : viewport_.x_px + viewport_.width_px - 1;
    return {x, viewport_.y_px + viewport_.height_px - 1, 1, 1};
}

std::optional<EyePlace> PanelView::place(const dvec2& at_px) const {
    const dvec2 in_viewport{
        2.0 * (at_px.x - viewport_.x_px) / viewport_.width_px - 1.0,
        2.0 * (framebuffer_.height - at_px.y - viewport_.y_px) / viewport_.height_px - 1.0};
    const dvec2 panel = glm::transpose(viewport_from_panel()) * in_viewport;
    if (!(std::abs(panel.x) <= 1.0 && std::abs(panel.y) <= 1.0)) return std::nullopt;
    const bool left = panel.x < 0.0;
    return EyePlace{left ? Eye::left : Eye::right, {2.0 * panel.x + (left ? 1.0 : -1.0), panel.y}};
}

dvec2 PanelView::at_px(const EyePlace& place) const {
    const double x = 0.5 * (place.ndc.x + (place.eye == Eye::left ? -1.0 : 1.0));
    const dvec2 in_viewport = viewport_from_panel() * dvec2(x, place.ndc.y);
    return {
        viewport_.x_px + 0.5 * (in_viewport.x + 1.0) * viewport_.width_px,
        framebuffer_.height - viewport_.y_px - 0.5 * (in_viewport.y + 1.0) * viewport_.height_px};
}

}  // namespace foverig
