#include "rig/session/lens_pass.h"

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
    : distortion_(Dk2Optics::kEyePanel.width, Dk2Optics::kEyePanel.height,
                  tables_of(scenario.display), scenario.render.threads),
      eyes_(static_cast<std::size_t>(scenario.display.eyes)) {}

std::vector<PassTime> LensPass::run(const Renderer& renderer) {
    const HostTime begin = clock_.now();
    for (std::size_t eye = 0; eye < eyes_.size(); ++eye) {
        eyes_[eye] = renderer.image(static_cast<int>(eye));
    }
    const HostTime read = clock_.now();
    distortion_.apply(eyes_, panel_);
    return {{"read_image", to_ms(read - begin)}, {"lens_distortion", to_ms(clock_.now() - read)}};
}

}  // namespace foverig
