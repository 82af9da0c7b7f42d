#include "rig/session/lens_pass.h"

#include <utility>

#include "devices/display/dk2_optics.h"

namespace foverig {
namespace {

/// Where in the eye's image, which spans the frustum, each colour of each panel pixel comes from.
std::vector<ColourSources> sources_of(Eye eye, const DisplaySettings& display) {
    const Dk2Optics optics;
    const TangentFrustum frustum = optics.frustum(eye);
    std::vector<ColourSources> table;
    for (int y = 0; y < Dk2Optics::kEyePanel.height; ++y) {
        for (int x = 0; x < Dk2Optics::kEyePanel.width; ++x) {
            const auto tangents = optics.pixel_tangents(eye, x, y);
            ColourSources& sources = table.emplace_back();
            for (std::size_t colour = 0; colour < 3; ++colour) {
                const dvec2 tangent = tangents[colour];
                const double u = (tangent.x + frustum.left) / (frustum.left + frustum.right);
                const double v = (frustum.up - tangent.y) / (frustum.up + frustum.down);
                sources[colour] = vec2(dvec2(u * display.eye_width_px, v * display.eye_height_px));
            }
        }
    }
    return table;
}

std::vector<std::vector<ColourSources>> tables_of(const DisplaySettings& display) {
    std::vector<std::vector<ColourSources>> tables{sources_of(Eye::left, display)};
    if (display.eyes == 2) tables.push_back(sources_of(Eye::right, display));
    return tables;
}

}  // namespace

LensPass::LensPass(const Scenario& scenario)
    : distortion_({Dk2Optics::kEyePanel.width, Dk2Optics::kEyePanel.height},
                  {scenario.display.eye_width_px, scenario.display.eye_height_px},
                  tables_of(scenario.display), scenario.render.threads),
      eyes_(static_cast<std::size_t>(scenario.display.eyes)) {}

std::vector<PassTime> LensPass::run(const Renderer& renderer) {
    const HostTime begin = clock_.now();
    for (std::size_t eye = 0; eye < eyes_.size(); ++eye)
        eyes_[eye] = renderer.pixels(static_cast<int>(eye));
    distortion_.apply(eyes_, panel_);
    return {{"lens_distortion", to_ms(clock_.now() - begin)}};
}

Image LensPass::picture(std::span<const Image> eyes) const {
    std::vector<std::vector<Half4>> halves;
    std::vector<View<const Half4>> views;
    for (const Image& eye : eyes) {
        auto& packed = halves.emplace_back();
        for (const vec3& pixel : eye.pixels) packed.push_back(pack_half4(vec4(pixel, 0.0F)));
        views.push_back(view_of(std::as_const(packed)));
    }
    Image panel;
    distortion_.apply(views, panel);
    return panel;
}

}  // namespace foverig
